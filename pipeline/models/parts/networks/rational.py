"""Monotone rational-quadratic splines, a set of knots for every point: value, inverse, and slope by the knots.

Gregory and Delbourgo's interpolant: between two knots a rise h and the slopes at both ends give a rising rational
quadratic; beyond the outer knots it goes on as a straight line. It rises wherever rises and slopes are positive.

Source: Gregory and Delbourgo, "Piecewise rational quadratic interpolation to monotonic data", IMA Journal of
Numerical Analysis 2, 1982.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ....ground.kinematics import Array


@dataclass(frozen=True)
class Knots:
    """Knots of a spline for each point: `at` is shared, the rest is each point's own."""

    at: Array  # (knots,), rising, in u's unit
    start: Array  # (points,): value at the first knot, in the value's unit
    rise: Array  # (points, knots - 1), positive: value gained from knot to knot, in the value's unit
    slope: Array  # (points, knots), positive, in the value's unit over u's unit

    @property
    def values(self) -> Array:
        """Value at every knot, shape (points, knots), in the unit of `start`."""
        gained = np.cumsum(self.rise, axis=1)
        return self.start[:, None] + np.concatenate([np.zeros((len(self.rise), 1)), gained], axis=1)


@dataclass(frozen=True)
class _Piece:
    """The position of each point: its bin, how far in it (0 to 1), and the bin's curve."""

    bin: NDArray[np.intp]
    share: Array
    width: Array
    rise: Array
    left: Array  # slope at the left knot
    right: Array


def _piece(knots: Knots, u: Array) -> _Piece:
    """The bin of each u and its share of the bin, clipped to it before anything is computed."""
    number = np.clip(np.searchsorted(knots.at, u, side="right") - 1, 0, len(knots.at) - 2)
    rows = np.arange(len(u))
    width = np.diff(knots.at)[number]
    share = np.clip((u - knots.at[number]) / width, 0.0, 1.0)
    return _Piece(
        number, share, width, knots.rise[rows, number], knots.slope[rows, number], knots.slope[rows, number + 1]
    )


def _beyond(knots: Knots, u: Array) -> Array:
    """The value added by the straight lines outside the outer knots."""
    below, above = np.minimum(u - knots.at[0], 0.0), np.maximum(u - knots.at[-1], 0.0)
    return below * knots.slope[:, 0] + above * knots.slope[:, -1]


def value(knots: Knots, u: Array) -> Array:
    """The spline at u, one value a point; both of shape (points,). u and value in the units of the knots."""
    at = _piece(knots, u)
    steep, mixed = at.rise / at.width, at.share * (1.0 - at.share)
    curve = at.rise * (steep * at.share**2 + at.left * mixed) / (steep + (at.left + at.right - 2.0 * steep) * mixed)
    return knots.values[np.arange(len(u)), at.bin] + curve + _beyond(knots, u)


def inverse(knots: Knots, y: Array) -> Array:
    """The u at which the spline is y, one a point; both of shape (points,). u and y in the units of the knots."""
    rows, values = np.arange(len(y)), knots.values
    number = np.clip((values <= y[:, None]).sum(axis=1) - 1, 0, values.shape[1] - 2)
    width, rise = np.diff(knots.at)[number], knots.rise[rows, number]
    left_slope, right_slope, steep = knots.slope[rows, number], knots.slope[rows, number + 1], rise / width
    up = np.clip(y - values[rows, number], 0.0, rise)
    bend = up * (left_slope + right_slope - 2.0 * steep)
    a, b, c = rise * (steep - left_slope) + bend, rise * left_slope - bend, -steep * up
    root = np.sqrt(np.maximum(b * b - 4.0 * a * c, 0.0))
    # this form of the root has no difference of near numbers; b + root is 0 only where the rise is
    share = np.clip(2.0 * c / (-b - root), 0.0, 1.0)
    below, above = np.minimum(y - values[:, 0], 0.0), np.maximum(y - values[:, -1], 0.0)
    return knots.at[number] + share * width + below / knots.slope[:, 0] + above / knots.slope[:, -1]


def by_logarithms(knots: Knots, u: Array) -> tuple[Array, Array]:
    """The change of the value with the logarithm of each rise and of each slope.

    Shape (points, knots - 1) and (points, knots), in the unit of the knots' values.
    """
    at, rows = _piece(knots, u), np.arange(len(u))
    steep, share, mixed = at.rise / at.width, at.share, at.share * (1.0 - at.share)
    top = steep * share**2 + at.left * mixed
    bottom = steep + (at.left + at.right - 2.0 * steep) * mixed
    rises = np.where(np.arange(knots.rise.shape[1]) < at.bin[:, None], knots.rise, 0.0)
    by_rise = top / bottom + steep * (share**2 * bottom - top * (1.0 - 2.0 * mixed)) / bottom**2
    rises[rows, at.bin] = at.rise * by_rise
    slopes = np.zeros_like(knots.slope)
    slopes[rows, at.bin] = at.left * at.rise * mixed * (bottom - top) / bottom**2
    slopes[rows, at.bin + 1] = -at.right * at.rise * mixed * top / bottom**2
    slopes[:, 0] += np.minimum(u - knots.at[0], 0.0) * knots.slope[:, 0]
    slopes[:, -1] += np.maximum(u - knots.at[-1], 0.0) * knots.slope[:, -1]
    return rises, slopes
