"""The residual after calibration, in units of its own size, with the place and the time of each sample."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from ...ground.kinematics import Array
from ..fit.problem import Problem, State

SAMPLES = 4000  # of a recording are used, if it has as many: the width of a quick change depends on their number
MOVES = 0.1  # of the usual highest speed: a slower motion is rest
EDGES = (0.04, 0.12, 0.25, 0.4, 0.55, 0.7, 0.82, 0.9, 0.96)  # of the range of motion, between places
LOW, MIDDLE, TOP = (-0.01, 0.15), (0.3, 0.7), (0.85, 1.01)  # of the range of motion
QUICK = 1500  # parts of a recording: a change within one of them is quick
LEAST_SIZE = 0.3  # of the noise: least size of a mismatch
FEWEST = 20  # least number of samples for a slope


@dataclass(frozen=True)
class Mismatch:
    """A mismatch and its circumstances, each of shape (samples,); all are shares except times, turns and numbers."""

    raw: Array  # in units of its rms beyond the noise
    smooth: Array  # the same without what is quick
    noise: float  # in the same unit
    motion: Array  # in turns
    place: Array  # of the range of motion, from 0 to 1
    way: NDArray[np.intp]  # 1 while the motion winds, −1 while it unwinds, 0 at rest: counts
    speed: Array  # of the usual highest
    heavier: Array  # by how much the load is above its mean, as a share of the mean
    course: Array  # of the recording's duration, from 0 to 1
    stroke: NDArray[np.intp]  # numbers of strokes, as counts

    @property
    def bins(self) -> NDArray[np.intp]:
        """The bin between EDGES of each sample's place, as places. Shape (samples,)."""
        return np.searchsorted(EDGES, self.place, side="right")

    @property
    def remainder(self) -> Array:
        """The mismatch less its mean at each place and on each way. Shape (samples,), in its own unit."""
        groups = 3 * self.bins + self.way + 1
        number = np.maximum(np.bincount(groups, minlength=groups.max() + 1), 1)
        mean = np.bincount(groups, self.smooth, minlength=groups.max() + 1) / number
        return np.asarray(self.smooth - mean[groups])

    def quicker_than(self, times: float) -> Array:
        """The part of the mismatch that changes within `times` the width of a quick change.

        Shape (samples,), in its own unit.
        """
        return np.asarray(self.raw - without_quick(self.raw, times))

    def within(self, part: tuple[float, float]) -> NDArray[np.bool_]:
        """Which samples lie in a part of the range of motion. Shape (samples,)."""
        return (self.place > part[0]) & (self.place < part[1])


def mismatch(problem: Problem, base: State) -> Mismatch:
    """The residual of a calibrated simulator with its circumstances; of long recordings only every nth sample."""
    drivers, residual = problem.drivers, problem.measured - problem.simulate(base)
    looked_at = slice(None, problem.rows, max(1, problem.rows // SAMPLES))
    return seen(
        residual[looked_at], drivers.motion[looked_at], drivers.rate[looked_at],
        drivers.load[looked_at], drivers.time_s[looked_at], problem.record.stroke[looked_at],
    )  # fmt: skip


def seen(residual: Array, motion: Array, rate: Array, load: Array, time_s: Array, stroke: NDArray[np.intp]) -> Mismatch:
    """A mismatch from its parts, each of shape (samples,).

    The residual in mm, the motion in turns, its rate in turns a second, the load in any unit, the time in s, the
    strokes as counts.
    """
    noise = max(float(np.std(np.diff(residual))) / np.sqrt(2.0), 1e-12)
    size = float(np.sqrt(max(float(np.var(residual)) - noise**2, (LEAST_SIZE * noise) ** 2)))
    raw = (residual - np.median(residual)) / size
    low, high = np.percentile(motion, [0.1, 99.9])
    fastest = max(float(np.percentile(np.abs(rate), 95)), 1e-12)
    mean_load = max(float(np.mean(load)), 1e-6)
    return Mismatch(
        raw, without_quick(raw), noise / size, motion,
        np.clip((motion - low) / max(high - low, 1e-12), 0.0, 1.0),
        np.where(rate > MOVES * fastest, 1, np.where(rate < -MOVES * fastest, -1, 0)),
        np.abs(rate) / fastest, (load - np.mean(load)) / mean_load,
        (time_s - time_s[0]) / max(float(time_s[-1] - time_s[0]), 1e-12), stroke,
    )  # fmt: skip


def without_quick(values: Array, times: float = 1.0) -> Array:
    """Values without the part that changes within `times` the width of a quick change.

    Shape (samples,), in their own unit.
    """
    return np.asarray(gaussian_filter1d(values, times * max(1.0, len(values) / QUICK)))


def mean(values: Array, least: int = 4) -> float:
    """The mean of values of shape (values,), in their unit; 0 where they are too few."""
    return float(np.mean(values)) if len(values) >= least else 0.0


def follows(values: Array, driver: Array, where: NDArray[np.bool_]) -> float:
    """How far values move, in their unit, with one standard deviation of a driver.

    Both of shape (samples,), in any unit.
    """
    if np.count_nonzero(where) < FEWEST:
        return 0.0
    centred = driver[where] - np.mean(driver[where])
    spread = float(np.std(centred))
    return float(np.mean(centred * values[where])) / spread if spread > 1e-6 else 0.0
