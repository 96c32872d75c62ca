"""A recording's motion without spikes and outliers, and its speed, for any part of it; only that part is read."""

from collections.abc import Iterator
from functools import cached_property, lru_cache

import numpy as np
from scipy.ndimage import median_filter

from ..ground.kinematics import Array, Places
from ..ground.numbers import quantiles
from ..ground.stored.rows import Rows
from .spikes import spikes, without_spikes

OUTLIER_SAMPLES = 5  # width of the median that keeps outliers of the motor channel out
SPEED_WINDOW_S = 0.2


class Motion:
    """The driver of a recording: samples are counted from 0, the motion is in the driver's unit."""

    def __init__(self, rows: Rows, driver: str) -> None:
        self.rows, self.driver, self.length = rows, driver, len(rows)
        self.speed = lru_cache(maxsize=2)(self._speed)

    def time_s(self, first: int, stop: int) -> Array:
        """Time from sample `first` until `stop`, in s; shape (stop - first,)."""
        return self.rows.read("time_s", first, stop)

    @cached_property
    def _spikes(self) -> Places:
        return spikes(self.rows, self.driver)

    def smooth(self, first: int, stop: int) -> Array:
        """Motion from sample `first` until `stop`, each the median of the samples about it.

        In the driver's unit, shape (stop - first,).
        """
        begin, end = max(first - OUTLIER_SAMPLES // 2, 0), min(stop + OUTLIER_SAMPLES // 2, self.length)
        about = without_spikes(self.rows, self.driver, self._spikes, begin, end)
        return np.asarray(median_filter(about, OUTLIER_SAMPLES, mode="nearest")[first - begin : stop - begin])

    def smooth_at(self, places: Places) -> Array:
        """Motion at some samples, in any order; shape (places,), in the driver's unit."""
        values = np.empty(len(places))
        piece = np.searchsorted(self.rows.borders, places, side="right") - 1
        for number in np.unique(piece).tolist():
            inside, (first, stop) = piece == number, self.rows.spans[number]
            values[inside] = self.smooth(first, stop)[places[inside] - first]
        return values

    def pieces(self) -> Iterator[Array]:
        """All of the motion, piece by piece, each of shape (samples,), in the driver's unit."""
        return (self.smooth(*span) for span in self.rows.spans)

    def steps_s(self, first: int, stop: int) -> Array:
        """Time from each sample to the next, the last one's 0; shape (stop - first,), in s."""
        time_s = self.time_s(first, min(stop + 1, self.length))
        return np.diff(time_s, append=time_s[-1:]) if stop == self.length else np.diff(time_s)

    @cached_property
    def step_s(self) -> float:
        """The usual time from one sample to the next: the median."""
        last = self.length - 1
        return quantiles.median(lambda: (self.steps_s(first, min(stop, last)) for first, stop in self.rows.spans), last)

    @cached_property
    def reach(self) -> int:
        """Number of samples on either side over which the speed is taken."""
        return max(1, round(SPEED_WINDOW_S / 2 / self.step_s))

    def _speed(self, first: int, stop: int) -> Array:
        """The speed without its sign, in the driver's unit per second; shape (stop - first,)."""
        places, last = np.arange(first, stop), self.length - 1
        begin, end = max(first - self.reach, 0), min(stop + self.reach, self.length)
        ahead, behind = (np.clip(places + way, 0, last) - begin for way in (self.reach, -self.reach))
        motion, time_s = self.smooth(begin, end), self.time_s(begin, end)
        return np.asarray(np.abs(motion[ahead] - motion[behind]) / (time_s[ahead] - time_s[behind]))
