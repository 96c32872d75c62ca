"""The columns of a linearised fit, one below the other in one table, each with its bounds, prior and starting point."""

import numpy as np

from ...ground.kinematics import Array


class Columns:
    """A table, shape (columns, samples), filled column by column: a list, stacked at the end, needs it twice.

    `room` is for how many columns at first. Memory that nothing was written to costs nothing, but a large piece is
    fetched anew from the system each time, page by page.
    """

    def __init__(self, samples: int, room: int) -> None:
        self._table = np.empty((room, samples))
        self._numbers: list[tuple[float, float, float, float]] = []

    def __len__(self) -> int:
        return len(self._numbers)

    def add(self, column: Array, low: float, high: float, sigma: float, at: float = 0.0) -> None:
        """Add a column with its bounds, one sigma of its prior, and where its number stands.

        Shape (samples,), in the reading's unit for each unit of its number.
        """
        if len(self) == len(self._table):
            wider = np.empty((2 * len(self), self._table.shape[1]))
            wider[: len(self)], self._table = self._table, wider
        self._table[len(self)] = column
        self._numbers.append((low, high, sigma, at))

    def free(self, more: Array, sigma: float) -> np.ndarray:
        """Add columns without bounds, as long as the others; their places.

        Shape (columns, samples), in the reading's unit.
        """
        for column in more:
            self.add(column[: self._table.shape[1]], -np.inf, np.inf, sigma)
        return np.arange(len(self) - len(more), len(self))

    @property
    def table(self) -> Array:
        """The columns so far. Shape (columns, samples), in the reading's unit."""
        return self._table[: len(self)]

    def numbers(self) -> tuple[Array, Array, Array, Array]:
        """Lower and upper bounds, sigmas of the priors, and where the numbers stand, each of shape (columns,).

        In each column's own unit.
        """
        low, high, sigma, at = np.array(self._numbers).reshape(-1, 4).T.copy()
        return low, high, sigma, at
