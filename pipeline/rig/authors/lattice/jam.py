"""Jam: beyond a critical twist the coils touch, and the displacement falls behind, the same way back."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "jam"


def _critical(rng: Rng, world: World) -> Params:
    return {"critical_turns": float(world.top_turns * rng.uniform(0.62, 0.86))}


def _act_hard(_world: World, turns: Array, p: Params) -> Array:
    beyond = np.maximum(turns - p["critical_turns"], 0.0)
    return np.asarray(turns - p["lost_share"] * beyond)


def _draw_soft(rng: Rng, world: World) -> Params:
    return {**_critical(rng, world), "onset_turns": float(world.top_turns * rng.uniform(0.015, 0.045))}


def _act_soft(_world: World, turns: Array, p: Params) -> Array:
    onset = p["onset_turns"]
    beyond = onset * np.logaddexp(0.0, (turns - p["critical_turns"]) / onset)
    return np.asarray(turns - p["lost_share"] * beyond)


def _draw_locking(rng: Rng, world: World) -> Params:
    return _critical(rng, world)


def _act_locking(world: World, turns: Array, p: Params) -> Array:
    """The gaps between the coils close one after another: what twist still does decays beyond the critical."""
    beyond = np.maximum(turns - p["critical_turns"], 0.0)
    rate = p["locking"] / (world.top_turns - p["critical_turns"])
    return np.asarray(turns - beyond - np.expm1(-rate * beyond) / rate)


LAWS = (
    Law(EFFECT, "hard_contact", "twist", "lost_share", 0.95, _critical, _act_hard),
    Law(EFFECT, "soft_contact", "twist", "lost_share", 0.95, _draw_soft, _act_soft),
    Law(EFFECT, "coils_lock", "twist", "locking", 8.0, _draw_locking, _act_locking),
)
