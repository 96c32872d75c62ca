"""A neural network of two hidden layers over the columns.

Source: Rumelhart, Hinton and Williams, "Learning representations by back-propagating errors", Nature 323, 1986.
"""

import warnings

from sklearn.exceptions import ConvergenceWarning
from sklearn.neural_network import MLPRegressor

from ...ground.kinematics import Array
from ...ground.numbers.regression import evenly
from . import Predict

LOOK = {"title": "neural network", "colour": "#cc79a7", "marker": "D"}
SEEDS = (0, 1, 2)
POINTS = 5000


def learn(table: Array, values: Array, seed: int) -> Predict:
    """A network whose weights begin where the seed says.

    The table has the shape (rows, columns), values and answers the shape (rows,), in one unit.
    """
    size = float(values.std()) or 1.0
    rows = evenly(len(values), POINTS)
    model = MLPRegressor(hidden_layer_sizes=(64, 64), max_iter=300, random_state=seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)  # it stops where its epochs end
        model.fit(table[rows], values[rows] / size)
    return lambda other: size * model.predict(other)
