"""The samples of a run that settle makes, as means that fit a screen, to show beside their prediction."""

import numpy as np

from ..ground.kinematics import Array
from ..settle.beyond import SMOOTH_S, simulated_mm, zero_mm
from ..settle.proposed import Curves

MOST = 2400  # means that are kept: ten minutes of a quarter of a second each; of a longer run they are of twice that


class Means:
    """Means of all columns over equal pieces of the time, the time itself included; memory is bounded."""

    def __init__(self) -> None:
        self._begin(0)

    def _begin(self, columns: int) -> None:
        self._over_s = SMOOTH_S
        self._sums: Array = np.zeros((0, columns))
        self._counts: Array = np.zeros(0)

    def add(self, rows: Array) -> None:
        """Take samples, shape (samples, columns), column 0 the time in s since the first. Each in its own unit."""
        if rows.shape[1] != self._sums.shape[1]:  # other columns than before: another recording
            self._begin(rows.shape[1])
        latest_s = float(rows[:, 0].max(initial=0.0))
        while latest_s // self._over_s >= MOST:
            self._halve()
        pieces = np.maximum(rows[:, 0] // self._over_s, 0).astype(int)
        if (more := int(pieces.max(initial=-1)) + 1 - len(self._counts)) > 0:
            self._sums = np.vstack([self._sums, np.zeros((more, self._sums.shape[1]))])
            self._counts = np.concatenate([self._counts, np.zeros(more)])
        np.add.at(self._sums, pieces, rows)
        np.add.at(self._counts, pieces, 1.0)

    def _halve(self) -> None:
        """Make one piece of each two."""
        self._over_s *= 2.0
        if len(self._counts) % 2:
            self._sums = np.vstack([self._sums, np.zeros((1, self._sums.shape[1]))])
            self._counts = np.append(self._counts, 0.0)
        self._sums = self._sums[::2] + self._sums[1::2]
        self._counts = self._counts[::2] + self._counts[1::2]

    @property
    def rows(self) -> Array:
        """The means, shape (pieces with samples, columns). Each column in its own unit."""
        has = self._counts > 0
        return np.asarray(self._sums[has] / self._counts[has, None])


def beyond(time_s: Array, turns: Array, reading_mm: Array, curves: Curves) -> dict[str, Array]:
    """The reading before the motor moved, and its later difference from the simulator, in mm.

    All of shape (means,), `zero_mm` of shape (1,); times in s since the run began.
    """
    zero = zero_mm(turns, reading_mm)
    difference_mm = reading_mm - zero - simulated_mm(curves, time_s, turns)
    return {"zero_mm": np.array([zero]), "time_s": time_s, "difference_mm": difference_mm}
