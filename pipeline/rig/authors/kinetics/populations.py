"""Populations of elements that respond one by one: quantiles of distributions, relaxing and irreversible ones."""

import numpy as np
from scipy.signal import lfilter
from scipy.stats import norm

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S


def quantiles(count: int) -> Array:
    """Middles of `count` equal shares of a population, in 0…1."""
    return (np.arange(count) + 0.5) / count


def lognormal(count: int, median: float, spread: float) -> Array:
    """Elements of equal weight, spread lognormally; `spread` is the standard deviation of the logarithm."""
    return np.asarray(median * np.exp(spread * norm.ppf(quantiles(count))))


def weibull(count: int, scale: float, shape: float) -> Array:
    """Elements of equal weight with Weibull-distributed values."""
    return np.asarray(scale * (-np.log1p(-quantiles(count))) ** (1.0 / shape))


def followed(drive: Array, time_s: float, start: float) -> Array:
    """First-order relaxation towards `drive` with one time constant, exact for a drive held over each step."""
    keep = float(np.exp(-STEP_S / time_s))
    return np.asarray(lfilter([1.0 - keep], [1.0, -keep], drive, zi=np.array([keep * start]))[0])


def relaxed(drive: Array, times_s: Array, weights: Array, age_s: float = np.inf) -> Array:
    """Weighted sum of relaxations towards `drive`, whose first value has been there for `age_s`."""
    total = np.zeros(len(drive))
    for time_s, weight in zip(times_s, weights, strict=True):
        total += weight * followed(drive, time_s, drive[0] * (1.0 - np.exp(-age_s / time_s)))
    return np.asarray(total / np.sum(weights))


def turned_over(exposure: Array, rates: Array) -> Array:
    """Share of an irreversible population that has turned over, each element at its own rate by the exposure."""
    total = np.zeros(len(exposure))
    for rate in rates:
        total -= np.expm1(-rate * exposure)
    return total / len(rates)


def diffusion(time_s: float, count: int = 8) -> tuple[Array, Array]:
    """Times and weights of the series of a slab that takes up heat or moisture from its faces."""
    odd = 2.0 * np.arange(count, dtype=np.float64) + 1.0
    return time_s / odd**2, 8.0 / (np.pi * odd) ** 2


def wandering(chance: np.random.Generator, count: int, time_s: float) -> Array:
    """An Ornstein-Uhlenbeck process of unit variance with a correlation time."""
    keep = float(np.exp(-STEP_S / time_s))
    pushes = chance.normal(size=count) * np.sqrt(1.0 - keep**2)
    return np.asarray(lfilter([1.0], [1.0, -keep], pushes, zi=np.array([keep * chance.normal()]))[0])
