"""Odd things in the sensor and its supply that are no physics of the string."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, relaxed, wandering
from pipeline.rig.authors.lattice.law import Law, Params, Rng, log_uniform
from pipeline.rig.authors.lattice.world import World


def _draw_sag(rng: Rng, world: World) -> Params:
    return {"pace": float(np.percentile(np.abs(world.rate), 90)), "settles_s": float(rng.uniform(0.03, 0.3))}


def _act_sag(world: World, reading_mm: Array, p: Params) -> Array:
    """The running motor pulls the sensor's supply down, either way, and with it the scale of the reading."""
    current = np.minimum(np.abs(world.rate) / p["pace"], 2.0)
    return np.asarray(reading_mm * (1.0 - p["sag_share"] * relaxed(current, world.step_s, p["settles_s"], 0.0)))


def _draw_bow(rng: Rng, world: World) -> Params:
    return {"middle_mm": float(world.span_mm * rng.uniform(0.3, 0.7)), "waves": float(rng.uniform(1.2, 2.6))}


def _act_bow(world: World, reading_mm: Array, p: Params) -> Array:
    """A transducer out of its linear range: its error waves along its stroke, the same at every passage."""
    way = (reading_mm - reading_mm[0] - p["middle_mm"]) / world.span_mm
    return np.asarray(reading_mm + p["error_mm"] * np.sin(2.0 * np.pi * p["waves"] * way) * (0.5 + np.abs(way)))


def _draw_speckle(rng: Rng, world: World) -> Params:
    grain_mm = float(world.span_mm * log_uniform(rng, 0.005, 0.03))
    return {"grain_mm": grain_mm, "seed": int(rng.integers(1 << 30))}


def _act_speckle(world: World, reading_mm: Array, p: Params) -> Array:
    """Speckle of a laser sensor: an error that belongs to the spot of the target, rough at the size of a grain."""
    spots = np.arange(-3.0, world.span_mm * 1.5, 0.2 * p["grain_mm"])
    rough = wandering(np.random.default_rng(p["seed"]), spots.size, 0.2, 1.0)
    return np.asarray(reading_mm + p["rough_mm"] * np.interp(reading_mm - reading_mm[0], spots, rough))


def _draw_gain(rng: Rng, world: World) -> Params:
    period_s = float(world.time_s[-1] * rng.uniform(0.09, 0.25))
    return {"period_s": period_s, "phase": float(rng.uniform()), "on_share": float(rng.uniform(0.3, 0.6))}


def _act_gain(world: World, reading_mm: Array, p: Params) -> Array:
    """A thermostat warms and cools the amplifier in turns: the scale of the reading saws, its zero stays."""
    warming = np.mod(world.time_s / p["period_s"] + p["phase"], 1.0) < p["on_share"]
    heated = relaxed(warming.astype(float), world.step_s, 0.25 * p["period_s"], p["on_share"])
    return np.asarray(reading_mm * (1.0 + p["gain_share"] * (heated - heated[0])))


LAWS = (
    Law("x_supply_sag", "ratiometric", "reading", "sag_share", 0.2, _draw_sag, _act_sag),
    Law("x_transducer_bow", "waves", "reading", "error_mm", 3.0, _draw_bow, _act_bow),
    Law("x_speckle", "rough_target", "reading", "rough_mm", 2.0, _draw_speckle, _act_speckle),
    Law("x_gain_cycle", "thermostat", "reading", "gain_share", 0.2, _draw_gain, _act_gain),
)
