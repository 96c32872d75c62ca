"""Drift of the sensor's zero: the reading moves with time, whatever the string does."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, pink
from pipeline.rig.authors.lattice.law import Law, Params, Rng
from pipeline.rig.authors.lattice.world import World

EFFECT = "sensor_drift"
LIMIT = 8.0


def _drifted(reading_mm: Array, drift: Array, p: Params) -> Array:
    return np.asarray(reading_mm + p["sign"] * p["range_mm"] * (drift - drift[0]) / float(np.ptp(drift)))


def _sign(rng: Rng, _world: World) -> Params:
    return {"sign": float(rng.choice([-1.0, 1.0]))}


def _act_linear(world: World, reading_mm: Array, p: Params) -> Array:
    return _drifted(reading_mm, world.time_s, p)


def _draw_settling(rng: Rng, world: World) -> Params:
    return {**_sign(rng, world), "tau_s": float(world.time_s[-1] * rng.uniform(0.15, 0.5))}


def _act_settling(world: World, reading_mm: Array, p: Params) -> Array:
    """Electronics that were switched on just before and warm up."""
    return _drifted(reading_mm, -np.expm1(-world.time_s / p["tau_s"]), p)


def _act_root(world: World, reading_mm: Array, p: Params) -> Array:
    """Heat or moisture that diffuses into the sensor: the root of time."""
    return _drifted(reading_mm, np.sqrt(world.time_s + 1.0), p)


def _seeded(rng: Rng, world: World) -> Params:
    return {**_sign(rng, world), "seed": int(rng.integers(1 << 30))}


def _act_walk(world: World, reading_mm: Array, p: Params) -> Array:
    return _drifted(reading_mm, np.cumsum(np.random.default_rng(p["seed"]).normal(size=world.time_s.size)), p)


def _act_flicker(world: World, reading_mm: Array, p: Params) -> Array:
    """Flicker of a zero: random states that relax in a minute to an hour, equally strong."""
    rng = np.random.default_rng(p["seed"])
    return _drifted(reading_mm, pink(rng, world.time_s.size, world.step_s, (60.0, 240.0, 900.0, 3600.0)), p)


LAWS = (
    Law(EFFECT, "linear", "reading", "range_mm", LIMIT, _sign, _act_linear),
    Law(EFFECT, "settling", "reading", "range_mm", LIMIT, _draw_settling, _act_settling),
    Law(EFFECT, "root_of_time", "reading", "range_mm", LIMIT, _sign, _act_root),
    Law(EFFECT, "random_walk", "reading", "range_mm", LIMIT, _seeded, _act_walk),
    Law(EFFECT, "flicker", "reading", "range_mm", LIMIT, _seeded, _act_flicker),
)
