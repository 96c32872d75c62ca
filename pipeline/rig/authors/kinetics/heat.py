"""Warmth and moisture of the string, by the series of the diffusion equation."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.law import Law, Parameters
from pipeline.rig.authors.kinetics.populations import diffusion, followed, relaxed


def air_soaks_in(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The string takes the air's temperature through its section, and lengthens or shortens by it."""
    times_s, weights = diffusion(p["time_s"])
    warmer = relaxed(bench.air_c - bench.air_c[0], times_s, weights)
    return np.asarray(size * np.sign(p["sign"]) * warmer)


def rubbing_warms(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Strands rub with torque times rate; the heat leaves through the surface as the diffusion series has it."""
    times_s, weights = diffusion(p["time_s"], 5)
    power = bench.torque * np.abs(bench.rate) / np.abs(bench.rate).max()
    return np.asarray(size * np.sign(p["sign"]) * relaxed(power, times_s, weights))


def motor_warms(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The motor heats while it turns, and the mount that holds the string follows it."""
    running = (np.abs(bench.rate) > 0.02).astype(float)
    running[0] = 0.0
    return np.asarray(size * np.sign(p["sign"]) * followed(followed(running, p["motor_s"], 0.0), p["mount_s"], 0.0))


def coil_warms(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Ohm's heat of the current that the torque asks for, a holding current included, warms the motor's mount."""
    current = p["idle"] + bench.torque
    return np.asarray(size * np.sign(p["sign"]) * followed(current**2 - current[0] ** 2, p["mount_s"], 0.0))


def drying(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A string wetted before the run dries by Fick's law, and its strands grow thinner."""
    times_s, weights = diffusion(p["time_s"], 10)
    left = sum(w * np.exp(-bench.time_s / t) for t, w in zip(times_s, weights, strict=True)) / weights.sum()
    return np.asarray(-size * (1.0 - left))


def soaking(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A sharp front of moisture walks into dry strands at a constant speed, and thickens them until it meets itself."""
    return np.asarray(size * (1.0 - np.maximum(1.0 - bench.time_s / p["front_s"], 0.0) ** 2))


SIGN = {"sign": (-1.0, 1.0)}
THERMAL = (
    Law("air_soaks_in", "elongation", 3.0, air_soaks_in, {"time_s": (1.0, 12.0), **SIGN}, needs_air=True),
    Law("rubbing_warms", "elongation", 40.0, rubbing_warms, {"time_s": (40.0, 200.0), **SIGN}),
    Law("motor_warms", "elongation", 20.0, motor_warms, {"motor_s": (20.0, 60.0), "mount_s": (60.0, 250.0), **SIGN}),
    Law("coil_warms", "elongation", 40.0, coil_warms, {"idle": (0.1, 0.4), "mount_s": (60.0, 250.0), **SIGN}),
)
MOISTURE = (
    Law("drying", "radius", 0.6, drying, {"time_s": (150.0, 600.0)}),
    Law("soaking", "radius", 0.6, soaking, {"front_s": (200.0, 700.0)}),
)
