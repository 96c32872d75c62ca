"""Eccentricity: what turns does not turn about its middle, and the reading ripples once a turn."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN
from pipeline.rig.authors.lattice.kernels import Array
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "eccentricity"
LIMIT = 3.0


def _phase(rng: Rng, _world: World) -> Params:
    return {"phase_rad": float(rng.uniform(0.0, RAD_PER_TURN))}


def _act_runout(world: World, contraction_mm: Array, p: Params) -> Array:
    """An eye that runs out: one pure harmonic."""
    return np.asarray(contraction_mm + p["runout_mm"] * np.sin(RAD_PER_TURN * world.turns + p["phase_rad"]))


def _draw_bent(rng: Rng, world: World) -> Params:
    shares = {"second_share": float(rng.uniform(0.15, 0.5)), "third_share": float(rng.uniform(0.05, 0.25))}
    phases = {"second_rad": float(rng.uniform(0.0, RAD_PER_TURN)), "third_rad": float(rng.uniform(0.0, RAD_PER_TURN))}
    return {**_phase(rng, world), **shares, **phases}


def _act_bent(world: World, contraction_mm: Array, p: Params) -> Array:
    """A bent shaft: the turn's first three harmonics."""
    angle = RAD_PER_TURN * world.turns
    ripple = np.sin(angle + p["phase_rad"]) + p["second_share"] * np.sin(2.0 * angle + p["second_rad"])
    ripple += p["third_share"] * np.sin(3.0 * angle + p["third_rad"])
    return np.asarray(contraction_mm + p["runout_mm"] * ripple)


def _draw_offset(rng: Rng, world: World) -> Params:
    return {**_phase(rng, world), "untwisted_share": float(rng.uniform(0.1, 0.4))}


def _act_offset(world: World, contraction_mm: Array, p: Params) -> Array:
    """A hook beside the axis tilts the helix: the ripple grows with the helix angle."""
    grown = p["untwisted_share"] + (1.0 - p["untwisted_share"]) * world.lever
    return np.asarray(contraction_mm + p["runout_mm"] * grown * np.sin(RAD_PER_TURN * world.turns + p["phase_rad"]))


LAWS = (
    Law(EFFECT, "runout", "contraction", "runout_mm", LIMIT, _phase, _act_runout),
    Law(EFFECT, "bent_shaft", "contraction", "runout_mm", LIMIT, _draw_bent, _act_bent),
    Law(EFFECT, "hook_off_axis", "contraction", "runout_mm", LIMIT, _draw_offset, _act_offset),
)
