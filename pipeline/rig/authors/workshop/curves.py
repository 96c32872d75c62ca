"""Curves through drawn points, and wandering: what an engineer reads off a sheet instead of a formula."""

from collections.abc import Callable

import numpy as np
from scipy.interpolate import PchipInterpolator

from pipeline.ground.kinematics import Array, Values

Curve = Callable[[Values], Array]


def drawn_curve(rng: np.random.Generator, bend: float, points: int = 6) -> Curve:
    """A rising curve from (0, 0) to (1, 1) through drawn points; `bend` above 0 flattens it towards the end.

    `bend` is the fall of the slope, in e-folds; below 0 the curve steepens. Outside 0…1 the ends are held.
    """
    at = np.linspace(0.0, 1.0, points + 1)
    middle = (at[1:] + at[:-1]) / 2.0
    rise = np.exp(-bend * middle) * rng.uniform(0.8, 1.2, points)
    spline = PchipInterpolator(at, np.concatenate([[0.0], np.cumsum(rise) / rise.sum()]))
    return lambda value: np.asarray(spline(np.clip(value, 0.0, 1.0)))


def wander(rng: np.random.Generator, time_s: Array, share: float) -> Array:
    """A factor about 1 that wanders by a share (one sigma), slowly, through points drawn every 30 s."""
    knots = max(4, int(time_s[-1] / 30.0) + 2)
    spline = PchipInterpolator(np.linspace(0.0, time_s[-1], knots), rng.normal(0.0, share, knots))
    return np.asarray(1.0 + spline(time_s))


def histogram_draws(rng: np.random.Generator, edges: Array, shares: Array, count: int) -> Array:
    """Values drawn from a histogram: a bin by its share, then anywhere inside it."""
    bins = rng.choice(len(shares), size=count, p=np.asarray(shares) / np.sum(shares))
    return np.asarray(rng.uniform(np.asarray(edges)[bins], np.asarray(edges)[bins + 1]))


def eased(time_s: Array, start_s: float, lasting_s: float) -> Array:
    """0 before an event, 1 once it has lasted its time, straight between; at once where it lasts no time."""
    if lasting_s <= 0.0:
        return np.where(time_s >= start_s, 1.0, 0.0)
    return np.clip((time_s - start_s) / lasting_s, 0.0, 1.0)


def unit(shape: Array) -> Array:
    """A shape over its greatest deviation from its first value, from which it counts."""
    shape = shape - shape[0]
    greatest = float(np.abs(shape).max())
    return shape / greatest if greatest > 0.0 else shape
