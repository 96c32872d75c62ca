"""Losses that follow the twisting rate, at every twist alike: the drag of shearing fibres stretches the string."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, relaxed
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "viscous_loss"


def _pace(world: World) -> float:
    """A rate typical of the session, in turns/s."""
    return float(np.percentile(np.abs(world.rate), 90))


def _draw_dashpot(_rng: Rng, world: World) -> Params:
    return {"pace": _pace(world)}


def _act_dashpot(world: World, contraction_mm: Array, p: Params) -> Array:
    return np.asarray(contraction_mm - p["loss_mm"] * world.wander * world.rate / p["pace"])


def _draw_power(rng: Rng, world: World) -> Params:
    return {"pace": _pace(world), "power": float(rng.choice([rng.uniform(0.4, 0.75), rng.uniform(1.3, 1.9)]))}


def _act_power(world: World, contraction_mm: Array, p: Params) -> Array:
    drag = np.sign(world.rate) * np.abs(world.rate / p["pace"]) ** p["power"]
    return np.asarray(contraction_mm - p["loss_mm"] * world.wander * drag)


def _draw_carreau(rng: Rng, world: World) -> Params:
    return {
        "pace": _pace(world),
        "knee": float(_pace(world) * rng.uniform(0.15, 0.5)),
        "power": float(rng.uniform(0.4, 0.7)),
    }


def _act_carreau(world: World, contraction_mm: Array, p: Params) -> Array:
    """Thins beyond a knee: even at small rates, a power of the rate at great ones."""
    drag = world.rate / p["pace"] * (1.0 + (world.rate / p["knee"]) ** 2) ** (0.5 * (p["power"] - 1.0))
    return np.asarray(contraction_mm - p["loss_mm"] * world.wander * drag)


def _draw_kelvin(rng: Rng, world: World) -> Params:
    return {"pace": _pace(world), "tau_s": float(rng.uniform(0.1, 0.45))}


def _act_kelvin(world: World, contraction_mm: Array, p: Params) -> Array:
    drag = relaxed(world.rate / p["pace"], world.step_s, p["tau_s"], 0.0)
    return np.asarray(contraction_mm - p["loss_mm"] * world.wander * drag)


LAWS = (
    Law(EFFECT, "dashpot", "length", "loss_mm", 3.0, _draw_dashpot, _act_dashpot),
    Law(EFFECT, "power_fluid", "length", "loss_mm", 3.0, _draw_power, _act_power),
    Law(EFFECT, "carreau", "length", "loss_mm", 3.0, _draw_carreau, _act_carreau),
    Law(EFFECT, "kelvin_element", "length", "loss_mm", 3.0, _draw_kelvin, _act_kelvin),
)
