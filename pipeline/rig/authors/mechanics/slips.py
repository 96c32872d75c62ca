"""Laws of sudden slips: a grip of dry friction works loose under load, and the next ridge stops what slides."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.mechanics.engine import STICKS, STOPS, model_text, push, simulated, slider
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

RIDGE, FORCE = 20.0, 1000.0  # way to the next ridge, and the largest force per unit of mass: a slide takes about 1 s
TIGHT, LOOSE = 1.5, 0.9  # grip over the largest force at first, and over the force of the moment once it is loose


def _slid(force: Array, shares: Array, draw: np.random.Generator) -> tuple[Array, dict[str, float]]:
    """How far grips in a row have slid under a force, 1 in all, one value a step; and the times in s of their slips.

    Each grip works loose at one moment when the force is large; `shares` are the grips' parts of the way.
    """
    pulled = force / force.max()
    after = int(0.12 * len(pulled))
    loud = after + np.flatnonzero(pulled[after : -after // 2] > 0.5 * pulled[after : -after // 2].max())
    moments = np.sort(draw.choice(loud, len(shares), replace=False))
    names = [f"grip{number}" for number in range(len(shares))]
    bodies = "".join(
        slider(name, f'range="-1 {RIDGE}" frictionloss="1" damping="4" {STICKS} {STOPS}') for name in names
    )
    text = model_text(bodies, "".join(map(push, names)))
    grips = np.full(len(shares), TIGHT * FORCE)
    pieces = [(0, {"dof_frictionloss": grips.copy()})]
    for number, moment in enumerate(moments):
        grips[number] = LOOSE * FORCE * pulled[moment]
        pieces.append((int(moment), {"dof_frictionloss": grips.copy()}))
    position = simulated(text, np.tile(FORCE * pulled[:, None], len(names)), STEP_S, pieces=pieces).position
    moments_s = {f"slip_{number}_s": float(moment * STEP_S) for number, moment in enumerate(moments, 1)}
    return position @ shares, moments_s


def _few(draw: np.random.Generator) -> Array:
    shares = draw.uniform(0.5, 1.0, int(draw.integers(2, 5)))
    return np.asarray(shares / shares.sum())


def one_ridge(scene: Scene, draw: np.random.Generator) -> Law:
    """The string's knot slides in its clamp once, from one ridge to the next."""
    slid, moments_s = _slid(scene.load_n * (1.0 + np.square(scene.tangent)), np.ones(1), draw)
    return proportional("length", "slipped_mm", 5.0, -slid, moments_s, wanders=False)


def several_ridges(scene: Scene, draw: np.random.Generator) -> Law:
    """The knot slides some times, ridge after ridge."""
    slid, moments_s = _slid(scene.load_n * (1.0 + np.square(scene.tangent)), _few(draw), draw)
    return proportional("length", "slipped_mm", 5.0, -slid, moments_s, wanders=False)


def one_flat(scene: Scene, draw: np.random.Generator) -> Law:
    """The set screw slides on the shaft once, to the next flat: twist is lost under the load's torque."""
    slid, moments_s = _slid(scene.torque_nmm, np.ones(1), draw)
    return proportional("twist", "lost_turns", 4.0, -slid, moments_s, wanders=False)


def several_flats(scene: Scene, draw: np.random.Generator) -> Law:
    """The set screw slides some times, flat after flat."""
    slid, moments_s = _slid(scene.torque_nmm, _few(draw), draw)
    return proportional("twist", "lost_turns", 4.0, -slid, moments_s, wanders=False)
