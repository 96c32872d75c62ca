"""Methods that learn a signal over a few columns without physics: a Gaussian process on some points, boosted trees.

Source: Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006; Friedman, "Greedy function approximation:
a gradient boosting machine", Annals of Statistics 29, 2001.
"""

import warnings
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from sklearn.ensemble import HistGradientBoostingRegressor
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

from ..kinematics import Array

STEPS, RESTARTS = 25, 1


def evenly(rows: int, most: int) -> NDArray[np.intp]:
    """At most that many of the first rows, evenly spread, with both ends. Shape (at most `most`,), as indices."""
    return np.unique(np.linspace(0, rows - 1, most).astype(int))


def gaussian_process(table: Array, values: Array, points: int, tuned_on: int) -> Callable[[Array], Array]:
    """The process's mean as a function of a table of standard columns, shape (rows, columns).

    It knows `points` of the rows, and its lengths are the likeliest on `tuned_on` of these. Values have one unit, which
    is the mean's.
    """
    learnt_rows = evenly(len(values), points)
    table, values = table[learnt_rows], values[learnt_rows]
    size = float(values.std()) or 1.0
    tuned = evenly(len(learnt_rows), tuned_on)
    kernel = ConstantKernel(1.0, (1e-3, 1e3)) * RBF(np.ones(table.shape[1]), (0.05, 1e2))
    kernel = kernel + WhiteKernel(0.1, (1e-4, 1.0))
    model = GaussianProcessRegressor(kernel, optimizer=_least, n_restarts_optimizer=RESTARTS, random_state=0)
    with warnings.catch_warnings():
        # the length of a column that the signal does not follow belongs at its bound
        warnings.filterwarnings("ignore", "The optimal value found for dimension", ConvergenceWarning)
        model.fit(table[tuned], values[tuned] / size)
    model = GaussianProcessRegressor(model.kernel_, optimizer=None).fit(table, values / size)

    def mean(other: Array) -> Array:
        return np.asarray(size * model.predict(other))

    return mean


def _least(objective: Callable[..., tuple[float, Array]], start: Array, bounds: Array) -> tuple[Array, float]:
    """A search for the likeliest lengths that stops after some steps."""
    solution = minimize(objective, start, method="L-BFGS-B", jac=True, bounds=bounds, options={"maxiter": STEPS})
    return solution.x, float(solution.fun)


def boosted_trees(table: Array, values: Array, seed: int) -> Callable[[Array], Array]:
    """Trees that each correct the residual of those before, as a function of a table, shape (rows, columns).

    Values of shape (rows,) have one unit, which is the answer's.
    """
    model = HistGradientBoostingRegressor(max_iter=300, learning_rate=0.05, early_stopping=False, random_state=seed)
    predict: Callable[[Array], Array] = model.fit(table, values).predict
    return predict
