"""The noise of single readings, from the recording itself: second differences, which a motion hardly has."""

import math
from collections import Counter

import numpy as np

from ..ground.kinematics import Array

BLOCK = 32  # second differences whose mean square is one number
LEAST = 10  # blocks: of fewer the noise is not said, for it would still jump
OF_WHITE = 6.0  # a second difference has so many times the variance of white noise: 1 + 4 + 1
LOUDEST = 3.0  # times the middle block: what is louder holds an outlier or a turn of the motion, and counts as this
STEP = math.log(1.01)  # of the kept mean squares: they are counted in classes, since a recording may last for days
SILENT = 1e-300  # the mean square of readings that are all the same


class Noise:
    """One sigma of white noise on one channel, from all samples so far; how they were read in pieces is no matter.

    Means of squares, and no medians of single differences: those of a sensor with steps are steps too. Memory is
    bounded.
    """

    def __init__(self) -> None:
        self._rest: Array = np.zeros(0)
        self._classes: Counter[int] = Counter()

    def add(self, readings: Array) -> None:
        """Take samples of one channel, shape (samples,), in the channel's unit."""
        readings = np.concatenate([self._rest, readings])
        blocks = max(0, len(readings) - 2) // BLOCK
        apart = np.diff(readings[: blocks * BLOCK + 2], 2) if blocks else np.zeros(0)
        self._rest = readings[blocks * BLOCK :].copy()
        squares = np.mean(apart.reshape(-1, BLOCK) ** 2, axis=1)
        squares = np.maximum(squares[np.isfinite(squares)], SILENT)
        self._classes.update(np.rint(np.log(squares) / STEP).astype(int).tolist())

    @property
    def sigma(self) -> float | None:
        """The noise in the channel's unit, or None before there is enough of it."""
        if self._classes.total() < LEAST:
            return None
        classes = sorted(self._classes)
        counts = np.array([self._classes[each] for each in classes])
        squares = np.exp(STEP * np.array(classes))
        middle = squares[int(np.searchsorted(np.cumsum(counts), counts.sum() / 2))]
        return math.sqrt(float(np.average(np.minimum(squares, LOUDEST * middle), weights=counts)) / OF_WHITE)
