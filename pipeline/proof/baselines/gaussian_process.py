"""A Gaussian process on at most 1,000 points of the residual over a few drivers: smooth, and names nothing."""

import warnings
from collections.abc import Callable

import numpy as np
from scipy.optimize import minimize
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

from pipeline.diagnosis.problem import Problem
from pipeline.kinematics import Array
from pipeline.proof.baselines.features import plain, standard, table
from pipeline.proof.baselines.learnt import Calibrated, Learnt

POINTS, TUNED_ON = 1000, 300  # points that it knows, and of these those on which its lengths are chosen
STEPS, RESTARTS = 25, 1
FEW = ("twist", "direction", "rate", "load", "time")


def learn(seen: Calibrated) -> Learnt:
    """A correction by the process's mean; no name."""
    rows = seen.problem.rows
    columns = _few(seen.problem)
    mean, spread = standard(columns, rows)
    known = np.unique(np.linspace(0, rows - 1, POINTS).astype(int))
    points, values = table(columns, mean, spread)[known], seen.residual_mm[known]
    size = float(values.std()) or 1.0
    tuned = np.unique(np.linspace(0, len(known) - 1, TUNED_ON).astype(int))
    kernel = ConstantKernel(1.0, (1e-3, 1e3)) * RBF(np.ones(len(columns)), (0.05, 1e2)) + WhiteKernel(0.1, (1e-4, 1.0))
    model = GaussianProcessRegressor(kernel, optimizer=_least, n_restarts_optimizer=RESTARTS, random_state=0)
    with warnings.catch_warnings():
        # the length of a driver that the residual does not follow belongs at its bound
        warnings.filterwarnings("ignore", "The optimal value found for dimension", ConvergenceWarning)
        model.fit(points[tuned], values[tuned] / size)
    model = GaussianProcessRegressor(model.kernel_, optimizer=None).fit(points, values / size)

    def adds_mm(other: Problem) -> Array:
        return size * model.predict(table(_few(other), mean, spread))

    return Learnt(None, adds_mm)


def _few(problem: Problem) -> dict[str, Array]:
    return {name: column for name, column in plain(problem.drivers).items() if name in FEW}


def _least(objective: Callable[..., tuple[float, Array]], start: Array, bounds: Array) -> tuple[Array, float]:
    """A search for the likeliest lengths that stops after some steps."""
    found = minimize(objective, start, method="L-BFGS-B", jac=True, bounds=bounds, options={"maxiter": STEPS})
    return found.x, float(found.fun)
