"""Plastic elongation: the string grows longer for good as it is worked, or as it is pulled harder than before."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "plastic_elongation"
LIMIT = 12.0


def _grown(contraction_mm: Array, growth: Array, p: Params) -> Array:
    """A law's growth laid on the string: `grown_mm` is what it comes to at the session's end."""
    return np.asarray(contraction_mm - p["grown_mm"] * (growth - growth[0]) / (growth[-1] - growth[0] + 1e-12))


def _worked(world: World) -> Array:
    """Worked strokes, at a pace that wanders a little."""
    return np.cumsum(np.diff(world.work, prepend=0.0) * np.clip(world.wander, 0.7, 1.3))


def _draw_log(rng: Rng, _world: World) -> Params:
    return {"first_strokes": float(rng.uniform(0.3, 1.5))}


def _act_log(world: World, contraction_mm: Array, p: Params) -> Array:
    return _grown(contraction_mm, np.log1p(_worked(world) / p["first_strokes"]), p)


def _draw_saturating(rng: Rng, world: World) -> Params:
    return {"strokes": float(world.strokes * rng.uniform(0.15, 0.4))}


def _act_saturating(world: World, contraction_mm: Array, p: Params) -> Array:
    """A back stress that grows with the growth: dP/dc = (P∞ − P)/n."""
    return _grown(contraction_mm, -np.expm1(-_worked(world) / p["strokes"]), p)


def _draw_power(rng: Rng, _world: World) -> Params:
    return {"power": float(rng.uniform(0.35, 0.65))}


def _act_power(world: World, contraction_mm: Array, p: Params) -> Array:
    return _grown(contraction_mm, (_worked(world) + 1e-4) ** p["power"], p)


def _draw_yield(rng: Rng, _world: World) -> Params:
    return {"twist_share": float(rng.uniform(0.3, 1.0)), "hardening_power": float(rng.uniform(0.6, 1.6))}


def _act_yield(world: World, contraction_mm: Array, p: Params) -> Array:
    """A yield surface that moves only outwards: growth follows the greatest tension so far."""
    tension = world.pull * (1.0 + p["twist_share"] * np.square(world.slope / world.slope.max()))
    above = np.maximum.accumulate(tension) - tension[0]
    return _grown(contraction_mm, above ** p["hardening_power"], p)


LAWS = (
    Law(EFFECT, "logarithmic", "length", "grown_mm", LIMIT, _draw_log, _act_log),
    Law(EFFECT, "back_stress", "length", "grown_mm", LIMIT, _draw_saturating, _act_saturating),
    Law(EFFECT, "power_of_work", "length", "grown_mm", LIMIT, _draw_power, _act_power),
    Law(EFFECT, "yield_surface", "length", "grown_mm", LIMIT, _draw_yield, _act_yield),
)
