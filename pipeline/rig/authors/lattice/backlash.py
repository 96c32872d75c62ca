"""Play in the drive between encoder and string: the string follows the last flank, whatever it carries."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, play, stepped
from pipeline.rig.authors.lattice.law import Law, Params, Rng, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "backlash"


def _hard(turns: Array, half_width: float) -> Array:
    return np.asarray(play(turns, np.full_like(turns, half_width), turns[0] - half_width))


def _act_hard(world: World, turns: Array, p: Params) -> Array:
    return np.asarray(play(turns, 0.5 * p["gap_turns"] * world.wander, turns[0] - 0.5 * p["gap_turns"]))


def _draw_worn(rng: Rng, _world: World) -> Params:
    return {"unevenness": float(rng.uniform(0.15, 0.35))}


def _act_worn(world: World, turns: Array, p: Params) -> Array:
    """Worn flanks: the gap differs from tooth to tooth, and the teeth take up the motion one after another."""
    shares = 1.0 + p["unevenness"] * np.linspace(-1.0, 1.0, 5)
    return np.asarray(np.mean([_hard(turns, 0.5 * p["gap_turns"] * share) for share in shares], axis=0))


def _draw_late(rng: Rng, _world: World) -> Params:
    return {"abruptness": float(rng.uniform(2.5, 6.0))}


@stepped
def _across(twist: Array, half_width: float, abruptness: float) -> Array:
    """Where in the gap the driver stands: free in the middle, carried along the more the nearer it is to a flank."""
    out = np.empty_like(twist)
    state = half_width
    for i in range(twist.size):
        whole = twist[i] - twist[max(i - 1, 0)]
        parts = min(100, 1 + int(abs(whole) * 2.0 * abruptness / (half_width + 1e-12)))
        for _ in range(parts):
            carried = (abs(state) / half_width) ** abruptness if whole * state > 0 else 0.0
            state += whole / parts * (1.0 - min(carried, 1.0))
        state = min(max(state, -half_width), half_width)
        out[i] = state
    return out


def _act_late(world: World, turns: Array, p: Params) -> Array:
    half_width = 0.5 * p["gap_turns"]
    return np.asarray(turns - _across(turns, half_width, p["abruptness"]))


LAWS = (
    Law(EFFECT, "hard_gap", "twist", "gap_turns", 2.5, nothing, _act_hard),
    Law(EFFECT, "worn_flanks", "twist", "gap_turns", 2.5, _draw_worn, _act_worn),
    Law(EFFECT, "late_take_up", "twist", "gap_turns", 2.5, _draw_late, _act_late),
)
