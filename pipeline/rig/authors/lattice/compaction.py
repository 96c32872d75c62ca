"""Compaction of the strands under the twist: the bundle's radius falls as the helix presses it together."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "radius_compaction"
LIMIT = 0.3  # share of the radius


def _pressure(world: World) -> Array:
    """Radial pressure of the helix, F sin²α / r, over its greatest value."""
    pressure = world.load_n * np.square(world.lever) / world.radius_mm
    return np.asarray(pressure / pressure.max())


def _draw_wool(rng: Rng, _world: World) -> Params:
    return {"stiff_at": float(rng.uniform(0.1, 0.8)), "power": float(rng.uniform(2.5, 4.0))}


def _act_wool(world: World, share: Array, p: Params) -> Array:
    """Van Wyk's wool: pressure rises with a power of the packing, so the radius gives ever less."""
    give = 1.0 - (1.0 + _pressure(world) / p["stiff_at"]) ** (-0.5 / p["power"])
    return np.asarray(share * (1.0 - p["lost_share"] * give / give.max()))


def _draw_packing(rng: Rng, _world: World) -> Params:
    return {"packed_at": float(rng.uniform(0.15, 0.6))}


def _act_packing(world: World, share: Array, p: Params) -> Array:
    """Packing that saturates with the twist, the same under every load."""
    twist = np.maximum(world.turns, 0.0) / world.top_turns
    return np.asarray(share * (1.0 - p["lost_share"] * -np.expm1(-np.square(twist / p["packed_at"]))))


def _draw_two(rng: Rng, _world: World) -> Params:
    onsets = {"first_at": float(rng.uniform(0.08, 0.2)), "second_at": float(rng.uniform(0.5, 0.7))}
    return {**onsets, "first_share": float(rng.uniform(0.3, 0.6))}


def _act_two(world: World, share: Array, p: Params) -> Array:
    """Two stages: the strands nestle at little twist, the fibres rearrange at much."""
    twist = np.maximum(world.turns, 0.0) / world.top_turns
    late = 1.0 / (1.0 + np.exp(-(twist - p["second_at"]) / 0.08))
    stages = p["first_share"] * np.tanh(twist / p["first_at"]) + (1.0 - p["first_share"]) * late
    return np.asarray(share * (1.0 - p["lost_share"] * stages))


LAWS = (
    Law(EFFECT, "wool", "radius", "lost_share", LIMIT, _draw_wool, _act_wool),
    Law(EFFECT, "saturating_packing", "radius", "lost_share", LIMIT, _draw_packing, _act_packing),
    Law(EFFECT, "two_stages", "radius", "lost_share", LIMIT, _draw_two, _act_two),
)
