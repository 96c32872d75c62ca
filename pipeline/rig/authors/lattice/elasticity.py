"""Axial elasticity: the string's length follows its load, at once and back again."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "axial_elasticity"
LIMIT = 15.0


def _act_hooke(world: World, contraction_mm: Array, p: Params) -> Array:
    return np.asarray(contraction_mm - p["stretch_mm"] * world.pull)


def _draw_crimp(rng: Rng, _world: World) -> Params:
    return {"straight_at": float(rng.uniform(0.25, 0.8))}


def _act_crimp(world: World, contraction_mm: Array, p: Params) -> Array:
    """Crimped fibres straighten, and give no more."""
    return np.asarray(contraction_mm + p["stretch_mm"] * np.expm1(-world.pull / p["straight_at"]))


def _draw_hardening(rng: Rng, _world: World) -> Params:
    return {"power": float(rng.uniform(0.4, 0.75))}


def _act_hardening(world: World, contraction_mm: Array, p: Params) -> Array:
    return np.asarray(contraction_mm - p["stretch_mm"] * world.pull ** p["power"])


def _draw_ramberg(rng: Rng, _world: World) -> Params:
    return {"power": float(rng.uniform(2.5, 5.0)), "share": float(rng.uniform(0.1, 0.4))}


def _act_ramberg(world: World, contraction_mm: Array, p: Params) -> Array:
    give = (1.0 - p["share"]) * world.pull + p["share"] * world.pull ** p["power"]
    return np.asarray(contraction_mm - p["stretch_mm"] * give)


LAWS = (
    Law(EFFECT, "hooke", "length", "stretch_mm", LIMIT, nothing, _act_hooke),
    Law(EFFECT, "crimp", "length", "stretch_mm", LIMIT, _draw_crimp, _act_crimp),
    Law(EFFECT, "hardening", "length", "stretch_mm", LIMIT, _draw_hardening, _act_hardening),
    Law(EFFECT, "ramberg_osgood", "length", "stretch_mm", LIMIT, _draw_ramberg, _act_ramberg),
)
