"""Stiffening: worked or loaded, the string gives less under its load, and the load hangs higher."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "stiffening"
LIMIT = 8.0


def _stiffer(world: World, contraction_mm: Array, hardened: Array, p: Params) -> Array:
    """Stretch F/K falls by the hardened part, 0 to 1, of `gained_mm` at the mean load."""
    return np.asarray(contraction_mm + p["gained_mm"] * world.pull * hardened / hardened[-1])


def _draw_work(rng: Rng, _world: World) -> Params:
    return {"first_strokes": float(rng.uniform(0.4, 2.0)), "most": float(rng.uniform(0.05, 0.3))}


def _act_work(world: World, contraction_mm: Array, p: Params) -> Array:
    """K = K0 (1 + k ln(1 + c)) with the worked strokes c."""
    stiffer = p["most"] * np.log1p(world.work / p["first_strokes"])
    return _stiffer(world, contraction_mm, stiffer / (1.0 + stiffer), p)


def _draw_alignment(rng: Rng, world: World) -> Params:
    return {"strokes": float(world.strokes * rng.uniform(0.15, 0.5))}


def _act_alignment(world: World, contraction_mm: Array, p: Params) -> Array:
    """The fibres align with each stroke by a share of what is left to align."""
    return _stiffer(world, contraction_mm, -np.expm1(-world.work / p["strokes"]), p)


def _draw_time(rng: Rng, world: World) -> Params:
    return {"impulse_s": float(world.time_s[-1] * rng.uniform(0.2, 0.7))}


def _act_time(world: World, contraction_mm: Array, p: Params) -> Array:
    """The fibres align with the load's impulse, worked or not."""
    impulse_s = np.cumsum(world.pull) * world.step_s
    return _stiffer(world, contraction_mm, -np.expm1(-impulse_s / p["impulse_s"]), p)


LAWS = (
    Law(EFFECT, "log_of_work", "length", "gained_mm", LIMIT, _draw_work, _act_work),
    Law(EFFECT, "alignment_by_work", "length", "gained_mm", LIMIT, _draw_alignment, _act_alignment),
    Law(EFFECT, "alignment_under_load", "length", "gained_mm", LIMIT, _draw_time, _act_time),
)
