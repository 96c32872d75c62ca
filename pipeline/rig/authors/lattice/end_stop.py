"""End stop: near the top of its way the carriage meets a stop, and the string stretches instead."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng, log_uniform, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "end_stop"


def _beyond(world: World, contraction_mm: Array, p: Params) -> Array:
    """How far the free carriage would be beyond the stop, in mm; `overrun_mm` at the session's top."""
    top_mm = float(world.base_mm.max())
    return np.maximum(contraction_mm - (top_mm - p["overrun_mm"]), 0.0)


def _act_hard(world: World, contraction_mm: Array, p: Params) -> Array:
    return np.asarray(contraction_mm - _beyond(world, contraction_mm, p))


def _draw_hertz(rng: Rng, world: World) -> Params:
    stiffness = world.true.stiffness_n_per_mm * log_uniform(rng, 5.0, 40.0)
    return {"contact_n_per_mm_1_5": float(stiffness)}


def _act_hertz(world: World, contraction_mm: Array, p: Params) -> Array:
    """K (g − δ) = H δ^1.5 for a gap g that the string would overrun, by Newton in √δ from above."""
    beyond = _beyond(world, contraction_mm, p)
    touching = beyond > 0.0
    over, stiffness, contact = beyond[touching], world.true.stiffness_n_per_mm, p["contact_n_per_mm_1_5"]
    root = np.sqrt(over)
    for _ in range(20):
        rest = contact * root**3 + stiffness * (root**2 - over)
        root -= rest / (3.0 * contact * root**2 + 2.0 * stiffness * root + 1e-12)
    pressed = np.zeros_like(beyond)
    pressed[touching] = np.square(root)
    return np.asarray(contraction_mm - beyond + pressed)


def _draw_foam(rng: Rng, world: World) -> Params:
    return {"plateau_n_per_mm": float(world.true.stiffness_n_per_mm * rng.uniform(0.5, 2.5)), "locks_at_mm": 1.0}


def _act_foam(world: World, contraction_mm: Array, p: Params) -> Array:
    """A foam pad: K (g − δ) = c δ / (1 − δ/D), a quadratic in δ."""
    beyond = _beyond(world, contraction_mm, p)
    stiffness, soft, locks = world.true.stiffness_n_per_mm, p["plateau_n_per_mm"], p["locks_at_mm"]
    half = 0.5 * (beyond + locks + soft * locks / stiffness)
    pressed = half - np.sqrt(np.square(half) - beyond * locks)
    return np.asarray(contraction_mm - beyond + pressed)


LAWS = (
    Law(EFFECT, "hard", "contraction", "overrun_mm", 12.0, nothing, _act_hard),
    Law(EFFECT, "hertz", "contraction", "overrun_mm", 12.0, _draw_hertz, _act_hertz),
    Law(EFFECT, "foam", "contraction", "overrun_mm", 12.0, _draw_foam, _act_foam),
)
