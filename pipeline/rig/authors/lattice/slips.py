"""Sudden slips: of the set screw on the shaft, which loses twist, and of the clamp, which lets out string."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World


def _moments(rng: Rng, world: World, count: int) -> list[float]:
    """Times of slips, each while winding near the top of a stroke of its own, never in the first or the last."""
    strokes = rng.choice(np.arange(1, world.strokes - 1), min(count, world.strokes - 2), replace=False)
    moments = []
    for stroke in np.sort(strokes):
        steps = np.flatnonzero((world.stroke == stroke) & (world.rate > 0.05))
        steep = world.torque[steps] > rng.uniform(0.6, 0.9) * world.torque[steps].max()
        moments.append(float(world.time_s[steps[np.argmax(steep)]]))
    return moments


def _shared(rng: Rng, count: int) -> list[float]:
    shares = rng.dirichlet(np.full(count, 4.0))
    return [float(share) for share in shares]


def _draw_once(rng: Rng, world: World) -> Params:
    at = _moments(rng, world, int(rng.choice([1, 1, 2])))
    return {"at_s": at, "shares": _shared(rng, len(at))}


def _draw_slow(rng: Rng, world: World) -> Params:
    return {**_draw_once(rng, world), "lasts_s": float(rng.uniform(0.3, 1.2))}


def _draw_ratchet(rng: Rng, world: World) -> Params:
    at = _moments(rng, world, int(rng.integers(3, 6)))
    return {"at_s": at, "shares": [1.0 / len(at)] * len(at)}


def _slipped(world: World, p: Params) -> Array:
    """Share of all slips done so far: each an even slide that ends when the grip catches again."""
    total = np.zeros_like(world.time_s)
    lasts_s = p.get("lasts_s", 0.015)
    for at_s, share in zip(p["at_s"], p["shares"], strict=True):
        total += share * np.clip((world.time_s - at_s) / lasts_s, 0.0, 1.0)
    return total


def _act_twist(world: World, turns: Array, p: Params) -> Array:
    return np.asarray(turns - p["lost_turns"] * _slipped(world, p))


def _act_length(world: World, contraction_mm: Array, p: Params) -> Array:
    return np.asarray(contraction_mm - p["let_out_mm"] * _slipped(world, p))


COUNT, CLAMP = "count_slip", "clamp_slip"
LAWS = (
    Law(COUNT, "set_screw_jumps", "twist", "lost_turns", 4.0, _draw_once, _act_twist),
    Law(COUNT, "set_screw_slides", "twist", "lost_turns", 4.0, _draw_slow, _act_twist),
    Law(COUNT, "ratchet", "twist", "lost_turns", 5.0, _draw_ratchet, _act_twist),
    Law(CLAMP, "knot_jumps", "length", "let_out_mm", 8.0, _draw_once, _act_length),
    Law(CLAMP, "knot_slides", "length", "let_out_mm", 8.0, _draw_slow, _act_length),
    Law(CLAMP, "ratchet", "length", "let_out_mm", 8.0, _draw_ratchet, _act_length),
)
