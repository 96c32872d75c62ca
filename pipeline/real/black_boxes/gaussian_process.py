"""A Gaussian process over the columns, on a thousand of the rows.

Source: Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006.
"""

from ...ground.kinematics import Array
from ...ground.numbers.regression import gaussian_process
from . import Predict

LOOK = {"title": "Gaussian process", "colour": "#0072b2", "marker": "^"}
SEEDS = (0,)
POINTS, TUNED_ON = 1000, 300


def learn(table: Array, values: Array, seed: int) -> Predict:
    """The process's mean; nothing is drawn by the seed.

    The table has the shape (rows, columns), values and answers the shape (rows,), in one unit.
    """
    return gaussian_process(table, values, POINTS, TUNED_ON)
