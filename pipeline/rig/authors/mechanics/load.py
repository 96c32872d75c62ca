"""Laws of the load and of the carriage: what hangs on it rings, and what stands in its way holds it."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.mechanics.engine import (
    GRAVITY_MM_PER_S2,
    STOPS,
    following,
    model_text,
    push,
    simulated,
    slider,
    spring_drive,
)
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

PULSE = 2.0 * np.pi * 12.0  # of the carriage on its string, in rad/s


def bouncing_weight(scene: Scene, draw: np.random.Generator) -> Law:
    """The weight bounces on its hanger's spring, and its force stretches the string; a heavier one bounces slower."""
    frequency_hz, damping = float(draw.uniform(1.5, 5.0)), float(draw.uniform(0.004, 0.02))
    pulse = 2.0 * np.pi * frequency_hz
    text = model_text(slider("weight"), spring_drive("weight", pulse, damping))
    pieces = [(step, {"body_mass": np.array([0.0, load / scene.usual_load_n])}) for step, load in scene.loads()]
    carriage = scene.contraction_mm
    weight = simulated(text, following(carriage, STEP_S), STEP_S, carriage[:1], pieces).position[:, 0]
    parameters = {"frequency_hz": frequency_hz, "damping_ratio": damping}
    return proportional("length", "largest_mm", 5.0, weight - carriage, parameters)


def pendulum(scene: Scene, draw: np.random.Generator) -> Law:
    """The weight swings as a pendulum below a carriage whose guide leans, and pulls the carriage aside."""
    length_mm, damping = float(draw.uniform(90.0, 500.0)), float(draw.uniform(0.004, 0.02))
    leans, loss = float(draw.uniform(0.1, 0.3)), 2.0 * damping * np.sqrt(GRAVITY_MM_PER_S2 * length_mm**3)
    rod = f'<body><inertial pos="0 0 {-length_mm}" mass="1" diaginertia="1 1 1"/>'
    rod += f'<joint name="hook" type="hinge" axis="0 1 0" damping="{loss:.9g}"/></body>'
    heavy = slider("carriage", 'armature="10000"', rod)
    drive = spring_drive("carriage", 100.0 * PULSE, 0.7)
    text = model_text(heavy, drive, gravity_mm_per_s2=GRAVITY_MM_PER_S2)
    aside = leans * (scene.contraction_mm - scene.contraction_mm[0])
    angle = simulated(text, following(aside, STEP_S), STEP_S).position[:, 1]
    shape = np.sin(angle) * scene.load_n
    parameters = {"length_mm": length_mm, "damping_ratio": damping, "leans": leans}
    return proportional("length", "largest_mm", 5.0, shape, parameters)


def _stopped(given: Array, bodies: str, start: float | None = None) -> Array:
    """What a carriage on its springy string does, which something stops, less where the string pulls it, in mm."""
    text = model_text(bodies, spring_drive("carriage", PULSE, 0.7))
    first = [given[0] if start is None else start]
    return simulated(text, following(given, STEP_S), STEP_S, first).position[:, 0] - given


def hard_stop(scene: Scene, draw: np.random.Generator) -> Law:
    """The carriage meets a hard stop: a joint's limit that does not yield."""
    top = float(scene.contraction_mm.max())

    def act(depth: float, given: Array) -> Array:
        return _stopped(given, slider("carriage", f'range="-1000 {top - depth:.9g}" {STOPS}'))

    return Law("carriage", "mm_beyond", (1e-3, 0.6 * top), act, {"top_mm": top})


def foam_stop(scene: Scene, draw: np.random.Generator) -> Law:
    """The carriage presses into a pad of foam that hardens with depth: a joint's limit of growing impedance."""
    top, width = float(scene.contraction_mm.max()), float(draw.uniform(0.2, 0.8))

    def act(depth: float, given: Array) -> Array:
        limit = f'range="-1000 {top - depth:.9g}" solreflimit="0.015 1" solimplimit="0.3 0.995 {width:.6g} 0.5 2"'
        return _stopped(given, slider("carriage", limit))

    return Law("carriage", "mm_beyond", (1e-3, 0.6 * top), act, {"top_mm": top, "foam_mm": width})


def _lifted(given: Array, slack: float, seat: str, held: Array, more: str) -> Array:
    """What a string, which can only pull, makes of a carriage that stands on a seat, less what it asks, in mm."""
    weight = np.full(len(given), PULSE**2)  # the carriage's own, which sags the string by 1 mm
    only_pulls = 'ctrlrange="-1000 1000" forcerange="0 1e9"'
    string = f'<general joint="carriage" gainprm="{PULSE**2}" biastype="affine" biasprm="0 {-(PULSE**2)} 0" '
    string += f"{only_pulls}/>"
    text = model_text(slider("carriage", f'damping="{PULSE / 3:.9g}" {seat}'), string + push("carriage") + more)
    controls = np.column_stack([given - slack + 1.0, -weight, held])
    settle = simulated(text, np.tile(controls[:1], (600, 1)), STEP_S, given[:1]).position[-1:, 0]
    place = simulated(text, controls, STEP_S, settle).position[:, 0]
    return place - given


def hard_seat(scene: Scene, draw: np.random.Generator) -> Law:
    """The carriage stands on a hard seat until the loose string is taken up, which can only pull."""

    def act(slack: float, given: Array) -> Array:
        seat = f'range="{given[0]:.9g} 1000" {STOPS}'
        return _lifted(given, slack, seat, np.empty((len(given), 0)), "")

    return Law("carriage", "slack_mm", (1e-3, 0.5 * float(np.ptp(scene.contraction_mm))), act)


def springy_seat(scene: Scene, draw: np.random.Generator) -> Law:
    """The carriage stands on a springy seat, which bears less and less while the loose string takes it over."""
    share = float(draw.uniform(0.6, 1.5))

    def act(slack: float, given: Array) -> Array:
        depth = share * slack
        stiffness = PULSE**2 / depth
        pad = f'<general joint="carriage" gainprm="{stiffness:.9g}" biastype="affine" biasprm="0 {-stiffness:.9g} 0" '
        pad += 'forcerange="0 1e9"/>'
        height = np.full((len(given), 1), given[0] + depth)
        return _lifted(given, slack, "", height, pad)

    return Law("carriage", "slack_mm", (0.02, 0.5 * float(np.ptp(scene.contraction_mm))), act, {"seat_share": share})
