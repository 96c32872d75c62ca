"""What a screen can show of a signal of any length: the least and the greatest of each of a bounded number of parts."""

import numpy as np

from ..ground.kinematics import Array


class _Extreme:
    """The least sample of each part by column, and column 0, the time, where it is; of `-rows` it is the greatest."""

    def __init__(self, columns: int) -> None:
        self.values: Array = np.zeros((0, columns))
        self.times: Array = np.zeros((0, columns))

    def append(self, values: Array, time: Array, each: int) -> None:
        """Begin parts of so many samples each; the last one may be shorter."""
        whole = len(values) // each * each
        places = values[:whole].reshape(-1, each, values.shape[1]).argmin(axis=1) + np.arange(0, whole, each)[:, None]
        if whole < len(values):
            places = np.vstack([places, whole + values[whole:].argmin(axis=0)])
        self.values = np.vstack([self.values, np.take_along_axis(values, places, axis=0)])
        self.times = np.vstack([self.times, time[places]])

    def widen(self, values: Array, time: Array) -> None:
        """Add samples to the last part."""
        places = values.argmin(axis=0)
        self._lesser(np.take_along_axis(values, places[None], axis=0), time[places][None], np.s_[-1:])

    def halve(self) -> None:
        """Make one part of each two."""
        values, times = self.values[1::2], self.times[1::2]
        self.values, self.times = self.values[::2].copy(), self.times[::2].copy()
        self._lesser(values, times, np.s_[:])

    def _lesser(self, values: Array, times: Array, parts: slice) -> None:
        is_less = (values < self.values[parts]) | np.isnan(values)
        self.values[parts] = np.where(is_less, values, self.values[parts])
        self.times[parts] = np.where(is_less, times, self.times[parts])


class Envelope:
    """Samples in at most `most` parts of equally many samples; when they are full, neighbours become one part."""

    def __init__(self, columns: int, most: int) -> None:
        self.most, self.each = most, 1
        self._low, self._high = _Extreme(columns), _Extreme(columns)
        self._first: Array = np.zeros((0, columns))
        self._open = 0  # samples in the last part

    def add(self, rows: Array) -> None:
        """Take samples, shape (samples, columns), column 0 the time in s. Each column in its own unit."""
        while len(rows):
            if 0 < self._open < self.each:
                part, rows = rows[: self.each - self._open], rows[self.each - self._open :]
                self._low.widen(part, part[:, 0])
                self._high.widen(-part, part[:, 0])
                self._open += len(part)
                continue
            if len(self._first) == self.most:
                self._halve()
                continue
            room = (self.most - len(self._first)) * self.each
            part, rows = rows[:room], rows[room:]
            self._low.append(part, part[:, 0], self.each)
            self._high.append(-part, part[:, 0], self.each)
            begins = np.arange(0, len(part), self.each)
            self._first = np.vstack([self._first, part[begins]])
            self._open = len(part) - int(begins[-1])

    def _halve(self) -> None:
        """Make one part of each two; `most` is even, and all parts are full here."""
        self._low.halve()
        self._high.halve()
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
        return self._low.values

    @property
    def high(self) -> Array:
        """The greatest of each part, shape (parts, columns). Each column in its own unit."""
        return -self._high.values

    @property
    def low_s(self) -> Array:
        """When each column was least in each part, shape (parts, columns). In s."""
        return self._low.times

    @property
    def high_s(self) -> Array:
        """When each column was greatest in each part, shape (parts, columns). In s."""
        return self._high.times
