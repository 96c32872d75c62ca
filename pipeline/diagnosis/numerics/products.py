"""The products of a fit's columns with each other and with its target, made when they are asked for."""

from functools import cached_property

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.linalg.blas import dsyrk

from ...ground.kinematics import Array
from .noise import Noise
from .recursions import whiten_from

STRETCH = 1024  # samples: a whitened copy of all of them at once would be as large as the table
TOGETHER = 64  # columns that are laid side by side for a product


@njit(cache=True)
def mirrored(lower: Array, scale: float) -> Array:
    """The symmetric matrix from its lower triangle, divided by a scale; shape (n, n).

    In the unit squared of what it holds.
    """
    whole = np.empty(lower.shape)
    for i in range(len(lower)):
        for j in range(i + 1):
            whole[i, j] = whole[j, i] = lower[i, j] / scale
    return whole


class Products:
    """Products of a table's rows, the columns of a fit and its target, whitened and as they are."""

    def hold(self, table: Array, prior: Array, noise: Noise, first: NDArray[np.intp]) -> None:
        """Take a table, shape (columns and the target, samples), the columns' priors (1/variance), and the noise."""
        self.table, self.prior, self.noise, self.first = table, prior, noise, first
        self.raw_prior = prior * noise.floor**2
        self._kept: dict[int, int] = {}
        self._raw = np.zeros((0, 0))

    @cached_property
    def whitened(self) -> tuple[Array, Array, float]:
        """Products of the whitened columns, priors included, and with the target, and the target's square.

        They are made stretch by stretch. Shapes (columns, columns) and (columns,).
        """
        count, samples = self.table.shape
        upper, room = np.zeros((count, count), order="F"), np.empty(count * min(STRETCH, samples))
        for start in range(0, samples, STRETCH):
            part = room[: count * min(STRETCH, samples - start)].reshape(count, -1)
            whiten_from(self.table, self.noise.ar, self.first, start, part)
            upper = dsyrk(1.0, part.T, beta=1.0, c=upper, trans=1, overwrite_c=1)
        lower, scale = upper.T, self.noise.innovation**2
        gram = mirrored(lower[:-1, :-1], scale)
        gram[np.diag_indices(count - 1)] += self.prior
        return gram, lower[-1, :-1] / scale, float(lower[-1, -1]) / scale

    @property
    def gram(self) -> Array:
        """Products of the whitened columns, priors included. Shape (columns, columns)."""
        return self.whitened[0]

    @property
    def moment(self) -> Array:
        """Products of the whitened columns with the target. Shape (columns,)."""
        return self.whitened[1]

    @property
    def square(self) -> float:
        """The whitened target's square."""
        return self.whitened[2]

    @cached_property
    def scale(self) -> Array:
        """Lengths of the whitened columns, priors included. Shape (columns,)."""
        return np.sqrt(np.diag(self.gram))

    def gather(self, columns: np.ndarray) -> None:
        """Make the products of some columns, not whitened, where they are not made: many at once cost least.

        Places of columns, shape (columns,), which are indices.
        """
        wanted = [*dict.fromkeys(columns.tolist()), len(self.table) - 1]
        new = [column for column in wanted if column not in self._kept]
        if new:
            before, rows = len(self._kept), self.table[new]
            self._kept |= {column: before + place for place, column in enumerate(new)}
            kept = list(self._kept)
            grown = np.empty((len(kept), len(kept)))
            for start in range(0, len(kept), TOGETHER):
                part = slice(start, start + TOGETHER)
                grown[before:, part] = rows @ self.table[kept[part]].T
            grown[:before, :before], grown[:before, before:] = self._raw, grown[before:, :before].T
            self._raw = grown

    def raw(self, columns: np.ndarray) -> tuple[Array, Array, float]:
        """Products of some columns, not whitened; their products with the target; and the target's square.

        Few columns of many are ever asked for, so that products are made when they are, and kept.
        Shapes (columns, columns) and (columns,).
        """
        self.gather(columns)
        place = np.array([self._kept[column] for column in columns.tolist()], np.intp)
        target = self._kept[len(self.table) - 1]
        return self._raw[np.ix_(place, place)], self._raw[place, target], float(self._raw[target, target])

    def let_go(self) -> None:
        """Free the columns and their products; no fit is possible afterwards."""
        self.table, self._raw = self.table[:0].copy(), np.zeros((0, 0))
        self._kept.clear()
        self.__dict__.pop("whitened", None)
