"""Standardisation: every column to mean 0 and standard deviation 1, constant columns to 0."""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array

CONSTANT = 1e-9  # spread over size below which a column is the same number, give or take its rounding


@dataclass(frozen=True)
class Scaling:
    """Mean and standard deviation of each column, in the columns' units, each of shape (columns,)."""

    mean: Array
    std: Array

    @classmethod
    def of(cls, values: Array) -> "Scaling":
        """The scaling of a table of shape (rows, columns), each column in its own unit.

        One string gives constant b, l and r. Their std would be 0 or mere rounding, and dividing by it NaN or
        a blown-up rounding error, so it is set to 1.
        """
        mean, std = values.mean(axis=0), values.std(axis=0)
        constant = std <= CONSTANT * np.maximum(np.abs(mean), 1.0)
        return cls(mean, np.where(constant, 1.0, std))

    def scaled(self, values: Array) -> Array:
        """Values of shape (rows, columns) in standard deviations from the mean, without a unit."""
        return np.asarray((values - self.mean) / self.std)

    def restored(self, values: Array) -> Array:
        """Values of shape (rows, columns), in their own units again."""
        return np.asarray(values * self.std + self.mean)
