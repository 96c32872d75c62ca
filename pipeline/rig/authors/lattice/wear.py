"""Wear of the string: its radius changes with the rubbing travel, for good."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "wear"
LIMIT = 0.15  # share of the radius over the session


def _worn(world: World) -> Array:
    """Rubbing travel over the whole session's."""
    travel = np.maximum.accumulate(world.travel)
    return np.asarray(travel / travel[-1])


def _act_archard(world: World, share: Array, p: Params) -> Array:
    return np.asarray(share * (1.0 - p["lost_share"] * _worn(world)))


def _draw_run_in(rng: Rng, _world: World) -> Params:
    return {"run_in_share": float(rng.uniform(0.1, 0.4))}


def _act_run_in(world: World, share: Array, p: Params) -> Array:
    """Running-in: the wear slows as the surfaces fit each other."""
    worn = -np.expm1(-_worn(world) / p["run_in_share"])
    return np.asarray(share * (1.0 - p["lost_share"] * worn))


def _draw_fuzz(rng: Rng, _world: World) -> Params:
    return {"power": float(rng.uniform(0.5, 0.9))}


def _act_fuzz(world: World, share: Array, p: Params) -> Array:
    """Broken filaments stand out as fuzz and the bundle thickens, by a power of the travel."""
    return np.asarray(share * (1.0 + p["gained_share"] * _worn(world) ** p["power"]))


LAWS = (
    Law(EFFECT, "archard", "radius", "lost_share", LIMIT, nothing, _act_archard),
    Law(EFFECT, "running_in", "radius", "lost_share", LIMIT, _draw_run_in, _act_run_in),
    Law(EFFECT, "fuzz", "radius", "gained_share", LIMIT, _draw_fuzz, _act_fuzz),
)
