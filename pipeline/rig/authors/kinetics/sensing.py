"""The displacement sensor: readings that come late by a population of delays, and a zero that wanders."""

import numpy as np
from scipy.stats import gamma, invgauss

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd
from pipeline.rig.authors.kinetics.populations import lognormal, quantiles, turned_over, wandering

# --- lag, whose size is the mean delay in seconds


def _late(bench: Bench, now: Array, delays_s: Array) -> Array:
    """The mean of the reading over delays, each an equal share, minus the reading."""
    late = np.mean([np.interp(bench.time_s - delay_s, bench.time_s, now) for delay_s in delays_s], axis=0)
    return np.asarray(late - now)


def one_delay(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Every reading is late by one and the same time."""
    return _late(bench, now, np.array([size]))


def even_delays(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The converter averages over a window."""
    return _late(bench, now, 2.0 * size * quantiles(16))


def staged_delays(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A few equal stages in a row: one stage is an ordinary low-pass."""
    stages = round(p["stages"])
    return _late(bench, now, gamma.ppf(quantiles(24), stages, scale=size / stages))


def first_passages(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Signals diffuse through the sensor's body: delays have the distribution of first passages."""
    delays = invgauss.ppf(quantiles(24), p["scatter"])
    return _late(bench, now, size * delays / delays.mean())


# --- drift, whose size is in mm


def ornstein_uhlenbeck(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The zero wanders at random and is drawn back, over minutes."""
    return np.asarray(size * wandering(crowd(p), len(now), p["time_s"]))


def ageing_sites(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The amplifier settles since it was switched on, over a spread of times."""
    return np.asarray(
        size * np.sign(p["sign"]) * turned_over(bench.time_s, 1.0 / lognormal(12, p["time_s"], p["spread"]))
    )


def traps(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Charges hop in and out of traps with lives from seconds to minutes: flicker noise."""
    chance = crowd(p)
    total = np.zeros(len(now))
    for life_s in p["slowest_s"] * np.exp(-chance.uniform(0.0, 3.0, 24)):
        hops = chance.uniform(0.0, 1.0, len(now)) < STEP_S / life_s
        total += np.where((np.cumsum(hops) + chance.integers(0, 2)) % 2, 1.0, -1.0)
    return np.asarray(size * total / np.sqrt(24.0))


def seeping(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Moisture seeps into the sensor's body, at first with the root of time."""
    return np.asarray(size * np.sign(p["sign"]) * np.tanh(np.sqrt(bench.time_s / p["time_s"])))


LAG = (
    Law("one_delay", "reading", 1.5, one_delay, still=True),
    Law("even_delays", "reading", 1.5, even_delays, still=True),
    Law("staged_delays", "reading", 1.5, staged_delays, {"stages": (1.0, 3.4)}, still=True),
    Law("first_passages", "reading", 1.5, first_passages, {"scatter": (1.0, 3.0)}, still=True),
)
DRIFT = (
    Law("ornstein_uhlenbeck", "reading", 5.0, ornstein_uhlenbeck, {"time_s": (80.0, 400.0)}),
    Law(
        "ageing_sites",
        "reading",
        8.0,
        ageing_sites,
        {"time_s": (60.0, 300.0), "spread": (0.3, 1.2), "sign": (-1.0, 1.0)},
    ),
    Law("traps", "reading", 5.0, traps, {"slowest_s": (80.0, 250.0)}),
    Law("seeping", "reading", 8.0, seeping, {"time_s": (300.0, 2000.0), "sign": (-1.0, 1.0)}),
)
