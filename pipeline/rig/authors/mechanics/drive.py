"""Laws of the drive line, which act on the twist: play, wind-up of the shaft, jam of the strands."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.mechanics.engine import (
    STICKS,
    STOPS,
    following,
    model_text,
    push,
    simulated,
    slider,
    spring_drive,
)
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

PULSE = 2.0 * np.pi * 12.0  # of the shafts and their bearings, in rad/s


def _played(turns: Array, widths: tuple[float, ...], start: float) -> Array:
    """What followers do, each with its own gap to the shaft and dry bearings that hold it within the gap, in turns."""
    dogs = [f"dog{number}" for number in range(len(widths))]
    bodies = slider("shaft") + "".join(slider(dog, f'frictionloss="40" armature="1" {STICKS}') for dog in dogs)
    gaps = "".join(
        f'<fixed range="{-width / 2:.9g} {width / 2:.9g}" {STOPS}><joint joint="{dog}" coef="1"/>'
        '<joint joint="shaft" coef="-1"/></fixed>'
        for dog, width in zip(dogs, widths, strict=True)
    )
    text = model_text(bodies, spring_drive("shaft", 3.0 * PULSE, 0.7), gaps)
    first = [turns[0], *(turns[0] + start * width / 2 for width in widths)]
    return np.mean(simulated(text, following(turns, STEP_S), STEP_S, first).position[:, 1:], axis=1)


def toothed(scene: Scene, draw: np.random.Generator) -> Law:
    """One gap with hard flanks: a tendon of limited range between two shafts, the second held by dry friction."""
    start = float(draw.uniform(-1.0, 1.0))

    def act(width: float, given: Array) -> Array:
        return _played(given, (width,), start) - given

    return Law("twist", "play_turns", (1e-3, 6.0), act, {"start_in_gap": start}, wanders=True)


def two_dogs(scene: Scene, draw: np.random.Generator) -> Law:
    """Two hooks, one for each strand, with gaps of unlike width: the string's twist is the mean of both."""
    start, share = float(draw.uniform(-1.0, 1.0)), float(draw.uniform(0.4, 0.75))

    def act(width: float, given: Array) -> Array:
        return _played(given, (width, share * width), start) - given

    return Law(
        "twist", "wider_play_turns", (1e-3, 6.0), act, {"start_in_gap": start, "narrower_share": share}, wanders=True
    )


def _wound(scene: Scene, stiffness: float, tendons: str = "") -> Array:
    """Deflection of a torsion spring under the load's torque, which is 1 where it is largest; one value a step."""
    torque = scene.torque_nmm / scene.torque_nmm.max() * stiffness
    text = model_text(slider("coupling", f'stiffness="{stiffness}" damping="{1.4 * PULSE}"'), push("coupling"), tendons)
    return simulated(text, torque[:, None], STEP_S, [torque[0] / stiffness]).position[:, 0]


def torsion_spring(scene: Scene, draw: np.random.Generator) -> Law:
    """A coupling that yields to the load's torque as a linear spring."""
    return proportional("twist", "windup_turns", 4.0, -_wound(scene, PULSE**2), {})


def spider_coupling(scene: Scene, draw: np.random.Generator) -> Law:
    """A coupling with a rubber spider: past a soft angle a second spring, a tendon with a dead band, bears too."""
    soft, harder = float(draw.uniform(0.2, 0.45)), float(draw.uniform(2.0, 6.0))
    band = f'<fixed springlength="-1 {soft}" stiffness="{harder * PULSE**2}"><joint joint="coupling" coef="1"/></fixed>'
    shape = -_wound(scene, PULSE**2, band)
    return proportional("twist", "windup_turns", 4.0, shape, {"soft_share": soft, "stiffer": harder})


def strand_pads(scene: Scene, draw: np.random.Generator) -> Law:
    """Strands that lie coil on coil past a critical twist: a spring with a dead band stands against the shaft's."""
    share = float(draw.uniform(0.15, 0.5))
    top = float(scene.turns.max())

    def act(depth: float, given: Array) -> Array:
        pads = f'<fixed springlength="-1000 {top - depth:.9g}" stiffness="{(1 / share - 1) * PULSE**2:.9g}">'
        pads += '<joint joint="string" coef="1"/></fixed>'
        text = model_text(slider("string"), spring_drive("string", PULSE, 0.7), pads)
        return simulated(text, following(given, STEP_S), STEP_S, given[:1]).position[:, 0] - given

    return Law("twist", "turns_past_critical", (0.02, 0.6 * top), act, {"slope_share": share, "top_turns": top})


def packed_strands(scene: Scene, draw: np.random.Generator) -> Law:
    """Strands that pack closer and closer: a joint's limit whose impedance grows as it is pressed in."""
    width, top = float(draw.uniform(1.0, 4.0)), float(scene.turns.max())

    def act(depth: float, given: Array) -> Array:
        limit = f'range="-1000 {top - depth:.9g}" solreflimit="0.03 1" solimplimit="0.05 0.97 {width:.6g} 0.5 2"'
        text = model_text(slider("string", limit), spring_drive("string", PULSE, 0.7))
        return simulated(text, following(given, STEP_S), STEP_S, given[:1]).position[:, 0] - given

    return Law("twist", "turns_past_critical", (0.02, 0.6 * top), act, {"width_turns": width, "top_turns": top})
