"""Warmth: the string's length follows its temperature, the room's or its own, through one or two thermal nodes."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, relaxed
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "thermal"
LIMIT = 12.0


def _sign(rng: Rng) -> float:
    return float(rng.choice([-1.0, 1.0]))  # polymers differ in whether warmth lengthens or shortens them


def _longer(contraction_mm: Array, warmth: Array, p: Params) -> Array:
    swing = float(np.ptp(warmth)) + 1e-12
    return np.asarray(contraction_mm - p["sign"] * p["range_mm"] * (warmth - warmth[0]) / swing)


def _draw_ambient(rng: Rng, _world: World) -> Params:
    return {"sign": _sign(rng), "tau_s": float(rng.uniform(3.0, 30.0))}


def _act_ambient(world: World, contraction_mm: Array, p: Params) -> Array:
    return _longer(contraction_mm, relaxed(world.ambient_k, world.step_s, p["tau_s"], 0.0), p)


def _draw_motor(rng: Rng, world: World) -> Params:
    return {"sign": _sign(rng), "tau_s": float(world.time_s[-1] * rng.uniform(0.12, 0.4))}


def _act_motor(world: World, contraction_mm: Array, p: Params) -> Array:
    """A motor that draws its current whenever it turns, however fast, warms the mount that it sits on."""
    turning = np.abs(world.rate) > 0.02 * np.abs(world.rate).max()
    heat = turning * world.wander
    return _longer(contraction_mm, relaxed(heat, world.step_s, p["tau_s"], 0.0), p)


def _draw_nodes(rng: Rng, world: World) -> Params:
    taus = {"tau_1_s": float(rng.uniform(10.0, 40.0)), "tau_2_s": float(world.time_s[-1] * rng.uniform(0.15, 0.5))}
    return {"sign": _sign(rng), **taus, "mount_share": float(rng.uniform(0.3, 0.6))}


def _act_nodes(world: World, contraction_mm: Array, p: Params) -> Array:
    """Friction heat, torque times rate, warms the string, which warms its mount in turn; both grow longer."""
    heat = world.torque * np.abs(world.rate) / world.top_turns * world.wander
    string = relaxed(heat, world.step_s, p["tau_1_s"], 0.0)
    mount = relaxed(string, world.step_s, p["tau_2_s"], 0.0)
    return _longer(contraction_mm, (1.0 - p["mount_share"]) * string + p["mount_share"] * mount, p)


LAWS = (
    Law(EFFECT, "ambient_node", "length", "range_mm", LIMIT, _draw_ambient, _act_ambient),
    Law(EFFECT, "running_motor", "length", "range_mm", LIMIT, _draw_motor, _act_motor),
    Law(EFFECT, "two_nodes", "length", "range_mm", LIMIT, _draw_nodes, _act_nodes),
)
