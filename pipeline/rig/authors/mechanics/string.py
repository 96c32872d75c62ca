"""Laws of the string's own length and radius: springs, dashpots and yielding knots under its tension."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.mechanics.engine import HARD_SOLREF, STICKS, model_text, push, simulated, slider
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

SLOW = 8  # steps of the scene in one step of what takes seconds
PULSE = 2.0 * np.pi * 5.0  # of the string on its load, in rad/s


def slowly(scene: Scene, text: str, forces: Array, start: list[float]) -> Array:
    """Positions under forces that change slowly, stepped coarsely, one row a step of the scene."""
    coarse = simulated(text, forces[::SLOW], STEP_S * SLOW, start).position
    return np.column_stack([np.interp(scene.time_s, scene.time_s[::SLOW], column) for column in coarse.T])


def strand_tension(scene: Scene, by_angle: float) -> Array:
    """Tension of the outer fibres over the load that is usual: more the steeper they lie; one value a step."""
    return scene.load_n / scene.usual_load_n * (1.0 + by_angle * np.square(scene.tangent))


def linear_spring(scene: Scene, draw: np.random.Generator) -> Law:
    """A string that is a linear spring: the load's change is its length's change."""
    force = scene.load_n / scene.usual_load_n * PULSE**2
    text = model_text(slider("end", f'stiffness="{PULSE**2}" damping="{1.6 * PULSE}"'), push("end"))
    shape = -simulated(text, force[:, None], STEP_S, [force[0] / PULSE**2]).position[:, 0]
    return proportional("length", "largest_mm", 6.0, shape, {})


def crimped_braid(scene: Scene, draw: np.random.Generator) -> Law:
    """A braid whose yarns bear one after the other: three tendons with dead bands stiffen a soft spring."""
    soft = PULSE**2 * 0.4
    bands = np.sort(draw.uniform(0.1, 0.9, 3))
    tendons = "".join(
        f'<fixed springlength="-1 {band:.6g}" stiffness="{PULSE**2}"><joint joint="end" coef="1"/></fixed>'
        for band in bands
    )
    force = scene.load_n / scene.usual_load_n * PULSE**2
    text = model_text(slider("end", f'stiffness="{soft}" damping="{2 * PULSE}"'), push("end"), tendons)
    settle = simulated(text, np.full((400, 1), force[0]), STEP_S).position[-1, 0]
    shape = -simulated(text, force[:, None], STEP_S, [settle]).position[:, 0]
    return proportional("length", "largest_mm", 6.0, shape, {f"band_{n}": float(b) for n, b in enumerate(bands, 1)})


def _kelvin(scene: Scene, times_s: list[float], start: float) -> Array:
    """Strains of Kelvin-Voigt elements (spring beside dashpot) under the strands' tension, one column an element."""
    names = [f"element{number}" for number in range(len(times_s))]
    bodies = "".join(
        slider(name, f'stiffness="1" damping="{tau_s:.9g}"') for name, tau_s in zip(names, times_s, strict=True)
    )
    tension = strand_tension(scene, 0.5)
    text = model_text(bodies, "".join(map(push, names)))
    return slowly(scene, text, np.tile(tension[:, None], len(names)), [start * tension[0]] * len(names))


def kelvin_voigt(scene: Scene, draw: np.random.Generator) -> Law:
    """One Kelvin-Voigt element: a joint's stiffness and damping under the strands' tension."""
    tau_s, start = float(np.exp(draw.uniform(np.log(10.0), np.log(90.0)))), float(draw.uniform(0.0, 0.3))
    shape = -_kelvin(scene, [tau_s], start)[:, 0]
    return proportional("length", "largest_mm", 6.0, shape, {"tau_s": tau_s, "start_share": start})


def two_kelvins(scene: Scene, draw: np.random.Generator) -> Law:
    """Two Kelvin-Voigt elements in a row, a quick and a slow one."""
    quick_s, slow_s = float(draw.uniform(4.0, 12.0)), float(draw.uniform(80.0, 300.0))
    share, start = float(draw.uniform(0.3, 0.7)), float(draw.uniform(0.0, 0.2))
    strains = _kelvin(scene, [quick_s, slow_s], start)
    shape = -(strains @ np.array([share, 1.0 - share]))
    parameters = {"quick_s": quick_s, "slow_s": slow_s, "quick_share": share, "start_share": start}
    return proportional("length", "largest_mm", 6.0, shape, parameters)


def _yielded(scene: Scene, draw: np.random.Generator, tau_s: float) -> tuple[Array, dict[str, float]]:
    """Slip of knots that hold by dry friction, harden as they draw tight, and need time; and what was drawn."""
    by_angle, share = float(draw.uniform(1.0, 3.0)), float(draw.uniform(0.55, 0.8))
    tension = strand_tension(scene, by_angle)
    yields = share * tension.max()
    joint = f'stiffness="1" damping="{tau_s:.9g}" frictionloss="{yields:.9g}" solreffriction="0.08 1" '
    joint += STICKS.replace(f'solreffriction="{HARD_SOLREF}"', "")
    text = model_text(slider("knots", joint), push("knots"))
    slipped = slowly(scene, text, tension[:, None], [max(0.0, float(tension[0]) - yields)])[:, 0]
    return -slipped, {"tension_by_angle": by_angle, "yield_share": share, "tau_s": tau_s}


def hardening_knots(scene: Scene, draw: np.random.Generator) -> Law:
    """Knots that draw tight by dry friction and harden: the greatest tension so far sets the length."""
    shape, parameters = _yielded(scene, draw, 1.0)
    return proportional("length", "largest_mm", 6.0, shape, parameters, wanders=False)


def viscous_knots(scene: Scene, draw: np.random.Generator) -> Law:
    """Knots that draw tight slowly (Bingham): every hard pull adds a little, and nothing recovers."""
    shape, parameters = _yielded(scene, draw, float(draw.uniform(25.0, 100.0)))
    return proportional("length", "largest_mm", 6.0, shape, parameters, wanders=False)


def _squeeze(scene: Scene) -> Array:
    """Line pressure of the strands on each other, 1 at its largest; one value a step."""
    pressure = scene.load_n * np.square(scene.sine)
    return np.asarray(pressure / pressure.max())


def springy_core(scene: Scene, draw: np.random.Generator) -> Law:
    """A bundle whose core is a spring: the radius falls with the strands' pressure."""
    text = model_text(slider("core", f'stiffness="{PULSE**2}" damping="{1.6 * PULSE}"'), push("core"))
    force = _squeeze(scene) * PULSE**2
    shape = -simulated(text, force[:, None], STEP_S, [force[0] / PULSE**2]).position[:, 0]
    return proportional("radius", "largest_ratio", 0.25, shape, {})


def pressed_fibres(scene: Scene, draw: np.random.Generator) -> Law:
    """A bundle whose fibres touch more and more as it is pressed: a joint's limit that hardens with depth."""
    width = float(draw.uniform(0.3, 1.0))
    limit = f'range="-10 0" solreflimit="0.1 1" solimplimit="0.3 0.95 {width:.6g} 0.5 2"'
    text = model_text(slider("core", f'{limit} damping="{PULSE}"'), push("core"))
    force = _squeeze(scene)[:, None] * 800.0
    settle = simulated(text, np.full((600, 1), force[0, 0]), STEP_S).position[-1, 0]
    shape = -simulated(text, force, STEP_S, [settle]).position[:, 0]
    return proportional("radius", "largest_ratio", 0.25, shape, {"width": width})
