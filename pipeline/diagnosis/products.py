"""The products of a fit's columns with each other and with its target, made when they are asked for."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.blas import dsyrk

from pipeline.diagnosis.noise import Noise
from pipeline.diagnosis.recursions import whiten
from pipeline.kinematics import Array


class Products:
    """Products of a table's rows, the columns of a fit and its target, whitened and as they are."""

    def hold(self, table: Array, prior: Array, noise: Noise, first: NDArray[np.intp]) -> None:
        """Take a table, shape (columns and the target, samples), the columns' priors (1/variance), and the noise."""
        self.table, self.prior, self.noise, self.first = table, prior, noise, first
        self.raw_prior = prior * noise.floor**2
        self._kept: dict[int, int] = {}
        self._raw = np.zeros((0, 0))

    @cached_property
    def products(self) -> Array:
        """All products of the whitened columns and of the target; the target last."""
        return _products(whiten(self.table, self.noise.ar, self.first) / self.noise.innovation)

    @cached_property
    def gram(self) -> Array:
        """Products of the whitened columns, priors included."""
        gram = self.products[:-1, :-1].copy()
        gram[np.diag_indices(len(gram))] += self.prior
        return gram

    @cached_property
    def moment(self) -> Array:
        """Products of the whitened columns with the target."""
        return self.products[-1, :-1].copy()

    @property
    def square(self) -> float:
        """The whitened target's square."""
        return float(self.products[-1, -1])

    @cached_property
    def scale(self) -> Array:
        """Lengths of the whitened columns, priors included."""
        return np.sqrt(np.diag(self.gram))

    def raw(self, columns: np.ndarray) -> tuple[Array, Array, float]:
        """Products of some columns, not whitened; their products with the target; and the target's square.

        Few columns of many are ever asked for, so that products are made when they are, and kept.
        """
        wanted = [*dict.fromkeys(columns.tolist()), len(self.table) - 1]
        new = [column for column in wanted if column not in self._kept]
        if new:
            known, more = len(self._kept), self.table[new]
            self._kept |= {column: known + place for place, column in enumerate(new)}
            across = more @ self.table[list(self._kept)].T
            grown = np.empty((len(self._kept), len(self._kept)))
            grown[:known, :known], grown[known:], grown[:, known:] = self._raw, across, across.T
            self._raw = grown
        place = np.array([self._kept[column] for column in columns.tolist()], np.intp)
        target = self._kept[len(self.table) - 1]
        return self._raw[np.ix_(place, place)], self._raw[place, target], float(self._raw[target, target])


def _products(table: Array) -> Array:
    """All products of the rows of a table, symmetric."""
    upper = dsyrk(1.0, table.T, trans=1)
    return np.asarray(np.triu(upper) + np.triu(upper, 1).T)
