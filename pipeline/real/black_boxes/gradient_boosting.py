"""Boosted trees over the columns.

Source: Friedman, "Greedy function approximation: a gradient boosting machine", Annals of Statistics 29, 2001.
"""

from ...ground.kinematics import Array
from ...ground.numbers.regression import boosted_trees
from . import Predict

LOOK = {"title": "boosted trees", "colour": "#009e73", "marker": "s"}
SEEDS = (0,)


def learn(table: Array, values: Array, seed: int) -> Predict:
    """Trees that each correct the residual of those before.

    The table has the shape (rows, columns), values and answers the shape (rows,), in one unit.
    """
    return boosted_trees(table, values, seed)
