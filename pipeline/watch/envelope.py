"""A signal of any length for a screen: the least and the greatest value of each of a bounded number of parts."""

import numpy as np

from ..ground.kinematics import Array


class _Extreme:
    """The least sample of each part by column, and `beside`, the time and another column, where it is.

    Of `-rows` it is the greatest.
    """

    def __init__(self, columns: int) -> None:
        self.values: Array = np.zeros((0, columns))
        self.beside: Array = np.zeros((0, columns, 2))

    def append(self, values: Array, beside: Array, each: int) -> None:
        """Begin parts of so many samples each; the last one may be shorter."""
        whole = len(values) // each * each
        places = values[:whole].reshape(-1, each, values.shape[1]).argmin(axis=1) + np.arange(0, whole, each)[:, None]
        if whole < len(values):
            places = np.vstack([places, whole + values[whole:].argmin(axis=0)])
        self.values = np.vstack([self.values, np.take_along_axis(values, places, axis=0)])
        self.beside = np.concatenate([self.beside, beside[places]])

    def widen(self, values: Array, beside: Array) -> None:
        """Add samples to the last part."""
        places = values.argmin(axis=0)
        self._lesser(np.take_along_axis(values, places[None], axis=0), beside[places][None], np.s_[-1:])

    def halve(self) -> None:
        """Make one part of each two."""
        values, beside = self.values[1::2], self.beside[1::2]
        self.values, self.beside = self.values[::2].copy(), self.beside[::2].copy()
        self._lesser(values, beside, np.s_[:])

    def _lesser(self, values: Array, beside: Array, parts: slice) -> None:
        is_less = (values < self.values[parts]) | np.isnan(values)
        self.values[parts] = np.where(is_less, values, self.values[parts])
        self.beside[parts] = np.where(is_less[:, :, None], beside, self.beside[parts])


class Envelope:
    """Samples in at most `most` parts of equal length; when they are full, neighbours become one part.

    `along`: the column over which the others are drawn, the time or another one.
    """

    def __init__(self, columns: int, most: int, along: int = 0) -> None:
        self.most, self.each, self._beside = most, 1, [0, along]
        self._low, self._high = _Extreme(columns), _Extreme(columns)
        self._first: Array = np.zeros((0, columns))
        self._open = 0  # samples in the last part

    def add(self, rows: Array) -> None:
        """Take samples, shape (samples, columns), column 0 the time in s. Each column in its own unit."""
        while len(rows):
            if 0 < self._open < self.each:
                part, rows = rows[: self.each - self._open], rows[self.each - self._open :]
                self._low.widen(part, part[:, self._beside])
                self._high.widen(-part, part[:, self._beside])
                self._open += len(part)
                continue
            if len(self._first) == self.most:
                self._halve()
                continue
            room = (self.most - len(self._first)) * self.each
            part, rows = rows[:room], rows[room:]
            self._low.append(part, part[:, self._beside], self.each)
            self._high.append(-part, part[:, self._beside], self.each)
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
        return np.asarray(self._low.beside[:, :, 0])

    @property
    def high_s(self) -> Array:
        """When each column was greatest in each part, shape (parts, columns). In s."""
        return np.asarray(self._high.beside[:, :, 0])

    def line(self, column: int) -> tuple[Array, Array]:
        """The column `along`, and a column's least and greatest of each part, in time order; both of shape (points,).

        Each in its own unit. Parts of one sample and of two give the samples themselves.
        """
        values = np.column_stack([self.low[:, column], self.high[:, column]])
        beside = np.stack([self._low.beside[:, column], self._high.beside[:, column]], axis=1)
        later = beside[:, 1, 0] < beside[:, 0, 0]
        values[later], beside[later] = values[later, ::-1], beside[later, ::-1]
        is_new = np.column_stack([np.ones(len(values), bool), np.any(beside[:, 0] != beside[:, 1], axis=1)])
        return np.asarray(beside[is_new][:, 1]), np.asarray(values[is_new])
