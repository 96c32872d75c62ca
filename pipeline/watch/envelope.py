"""What a screen can show of a signal of any length: the least and the greatest of each of a bounded number of parts."""

import numpy as np

from ..ground.kinematics import Array


class Envelope:
    """Samples in at most `most` parts of equally many samples; when they are full, neighbours become one part."""

    def __init__(self, columns: int, most: int) -> None:
        self.most, self.each = most, 1
        self._low: Array = np.zeros((0, columns))
        self._high: Array = np.zeros((0, columns))
        self._first: Array = np.zeros((0, columns))
        self._open = 0  # samples in the last part

    def add(self, rows: Array) -> None:
        """Take samples, shape (samples, columns). Each column in its own unit."""
        while len(rows):
            if 0 < self._open < self.each:
                part, rows = rows[: self.each - self._open], rows[self.each - self._open :]
                self._low[-1] = np.minimum(self._low[-1], part.min(axis=0))
                self._high[-1] = np.maximum(self._high[-1], part.max(axis=0))
                self._open += len(part)
                continue
            if len(self._low) == self.most:
                self._halve()
                continue
            room = (self.most - len(self._low)) * self.each
            part, rows = rows[:room], rows[room:]
            begins = np.arange(0, len(part), self.each)
            self._low = np.vstack([self._low, np.minimum.reduceat(part, begins)])
            self._high = np.vstack([self._high, np.maximum.reduceat(part, begins)])
            self._first = np.vstack([self._first, part[begins]])
            self._open = len(part) - int(begins[-1])

    def _halve(self) -> None:
        """Make one part of each two; `most` is even, and all parts are full here."""
        self._low = np.minimum(self._low[::2], self._low[1::2])
        self._high = np.maximum(self._high[::2], self._high[1::2])
        self._first = self._first[::2].copy()
        self.each *= 2
        self._open = self.each

    @property
    def first(self) -> Array:
        """The first sample of each part, shape (parts, columns). Each column in its own unit."""
        return self._first

    @property
    def low(self) -> Array:
        """The least of each part, shape (parts, columns). Each column in its own unit."""
        return self._low

    @property
    def high(self) -> Array:
        """The greatest of each part, shape (parts, columns). Each column in its own unit."""
        return self._high
