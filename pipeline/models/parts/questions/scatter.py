"""The size of a map's errors at a twist and a direction, and the quantiles of errors relative to that size.

Source: Vovk, Gammerman and Shafer, Algorithmic Learning in a Random World, 2005 (conformal prediction).
"""

from dataclasses import dataclass

import numpy as np

from ....ground.kinematics import Array

TWISTS = 6  # ranges of twist, equally populated, that have a scatter of their own


@dataclass(frozen=True)
class Scatter:
    """Local root mean square error of one map, by range of twist and direction."""

    edges_turns: Array  # (ranges + 1,)
    size: Array  # (ranges, 2): winding, unwinding; in the predicted column's unit

    @classmethod
    def of(cls, turns: Array, direction: Array, error: Array) -> "Scatter":
        """The scatter of errors at twists, all of shape (points,).

        Twist in turns; errors in mm, or in turns for the inverse.
        """
        edges = np.quantile(turns, np.linspace(0.0, 1.0, TWISTS + 1)[1:-1])
        whole = float(np.sqrt(np.mean(error**2)))
        size = np.full((TWISTS, 2), whole)
        place = np.searchsorted(edges, turns)
        for number in range(TWISTS):
            for way, sign in enumerate((1, -1)):
                in_group = error[(place == number) & (direction == sign)]
                if len(in_group):
                    size[number, way] = np.sqrt(np.mean(in_group**2))
        return cls(edges, np.maximum(size, 1e-12))

    def at(self, turns: Array, direction: Array) -> Array:
        """Scatter at twists, shape (points,). In the unit of the errors; twist in turns, direction 1 or -1."""
        return self.size[np.searchsorted(self.edges_turns, turns), np.where(direction > 0, 0, 1)]


def quantile(sorted_scores: Array, level: float) -> float:
    """The conformal quantile: the least score that a share `level` of n + 1 scores do not exceed.

    Scores have the shape (scores,), without unit.
    """
    rank = int(np.ceil(level * (len(sorted_scores) + 1)))
    return float(sorted_scores[min(rank, len(sorted_scores)) - 1])
