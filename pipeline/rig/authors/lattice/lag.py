"""Lag of the displacement sensor: its reading is late by its electronics, whatever the string does."""

import numpy as np

from pipeline.rig.authors.lattice.kernels import Array, relaxed, stepped
from pipeline.rig.authors.lattice.law import Law, Params, Rng, nothing
from pipeline.rig.authors.lattice.world import World

EFFECT = "sensor_lag"
LIMIT = 2.5


def _act_pole(world: World, reading_mm: Array, p: Params) -> Array:
    return np.asarray(relaxed(reading_mm, world.step_s, p["late_s"], reading_mm[0]))


def _draw_second(rng: Rng, _world: World) -> Params:
    return {"damping": float(rng.uniform(0.6, 1.0))}


@stepped
def _second_order(drive: Array, step_s: float, omega: float, damping: float) -> Array:
    """y'' = ω²(u − y) − 2ζω y', stepped implicitly."""
    out = np.empty_like(drive)
    at, speed = drive[0], 0.0
    for i in range(drive.size):
        speed += step_s * omega * omega * (drive[i] - at)
        speed /= 1.0 + 2.0 * damping * omega * step_s + (omega * step_s) ** 2
        at += step_s * speed
        out[i] = at
    return out


def _act_second(world: World, reading_mm: Array, p: Params) -> Array:
    omega = 2.0 * p["damping"] / p["late_s"]  # late by 2ζ/ω on a ramp
    return np.asarray(_second_order(reading_mm, world.step_s, omega, p["damping"]))


def _act_average(world: World, reading_mm: Array, p: Params) -> Array:
    """The mean over a window that ends now, twice as long as the delay that it makes."""
    window_s = 2.0 * p["late_s"]
    summed = np.concatenate([[0.0], np.cumsum(0.5 * (reading_mm[1:] + reading_mm[:-1]))]) * world.step_s
    before = np.interp(world.time_s - window_s, world.time_s, summed)
    early = np.minimum(world.time_s - window_s, 0.0) * reading_mm[0]
    return np.asarray((summed - before - early) / window_s)


def _act_dead(world: World, reading_mm: Array, p: Params) -> Array:
    return np.asarray(np.interp(world.time_s - p["late_s"], world.time_s, reading_mm))


LAWS = (
    Law(EFFECT, "one_pole", "reading", "late_s", LIMIT, nothing, _act_pole),
    Law(EFFECT, "second_order", "reading", "late_s", LIMIT, _draw_second, _act_second),
    Law(EFFECT, "moving_average", "reading", "late_s", LIMIT, nothing, _act_average),
    Law(EFFECT, "dead_time", "reading", "late_s", LIMIT, nothing, _act_dead),
)
