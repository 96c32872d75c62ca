"""The noise of single readings, from a recording itself: second differences, which a motion hardly has."""

import math
from collections import deque

import numpy as np

from ..ground.kinematics import Array

KEPT = 200  # pieces, the median of which is the noise
LEAST = 8  # samples of a piece
OF_MEDIAN = 0.4549  # the median of a squared normal variable: of chi squared with one degree of freedom
OF_WHITE = 6.0  # a second difference has so many times the variance of white noise: 1 + 4 + 1


class Noise:
    """One sigma of white noise on one channel; motion that turns within three samples counts as noise."""

    def __init__(self) -> None:
        self._pieces: deque[float] = deque(maxlen=KEPT)

    def add(self, readings: Array) -> None:
        """Take samples of one channel, shape (samples,), in the channel's unit."""
        if len(readings) < LEAST:
            return
        apart = np.diff(readings, 2)
        self._pieces.append(math.sqrt(float(np.median(apart**2)) / OF_WHITE / OF_MEDIAN))

    @property
    def sigma(self) -> float | None:
        """The noise in the channel's unit, or None before there is any."""
        return float(np.median(self._pieces)) if self._pieces else None
