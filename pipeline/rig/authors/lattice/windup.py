"""Wind-up of the coupling between encoder and string: it yields to the torque that the load asks, without loss."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "shaft_windup"
LIMIT = 6.0  # turns at the greatest torque: a soft rubber coupling


def _act_linear(world: World, turns: Array, p: Params) -> Array:
    return np.asarray(turns - p["turns_at_top"] * world.torque)


def _draw_hardening(rng: Rng, _world: World) -> Params:
    return {"cubic_share": float(rng.uniform(1.0, 8.0))}


def _act_hardening(world: World, turns: Array, p: Params) -> Array:
    """Torque = φ + c φ³, solved by Newton from above, where the cubic is convex."""
    angle = world.torque.copy()
    for _ in range(12):
        angle -= (angle + p["cubic_share"] * angle**3 - world.torque) / (1.0 + 3.0 * p["cubic_share"] * angle**2)
    return np.asarray(turns - p["turns_at_top"] * angle / angle.max())


def _draw_jaw(rng: Rng, _world: World) -> Params:
    return {"seating_torque": float(rng.uniform(0.08, 0.3)), "seated_share": float(rng.uniform(0.3, 0.6))}


def _act_jaw(world: World, turns: Array, p: Params) -> Array:
    """A rubber jaw seats itself under little torque, then is stiff."""
    seated = -np.expm1(-world.torque / p["seating_torque"])
    angle = p["seated_share"] * seated + (1.0 - p["seated_share"]) * world.torque
    return np.asarray(turns - p["turns_at_top"] * angle)


LAWS = (
    Law(EFFECT, "linear_spring", "twist", "turns_at_top", LIMIT, nothing, _act_linear),
    Law(EFFECT, "hardening_spring", "twist", "turns_at_top", LIMIT, _draw_hardening, _act_hardening),
    Law(EFFECT, "seating_jaw", "twist", "turns_at_top", LIMIT, _draw_jaw, _act_jaw),
)
