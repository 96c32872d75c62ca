"""Sparse regression of the calibrated residual on drivers (PySINDy's STLSQ), the threshold chosen by BIC.

Source: Brunton, Proctor and Kutz, PNAS 113, 2016; BIC: Schwarz, "Estimating the dimension of a model", Annals of
Statistics 6, 1978.
"""

import warnings

import numpy as np
from pysindy import STLSQ, IdentityLibrary, SINDy

from ...diagnosis.fit.problem import Problem
from ...ground.kinematics import Array
from .driver_columns import products, standard, stands_for, table
from .learnt import Calibrated, Learnt

THRESHOLDS = np.geomspace(0.02, 2.0, 14)  # of the residual's rms, on columns of unit spread
RIDGE = 1e-2  # for each sample: keeps columns that look alike from cancelling each other, which would name at random


def learn(seen: Calibrated) -> Learnt:
    """The sparse model with the least BIC, named by its largest term; nothing when no term stays."""
    problem, rows = seen.problem, seen.problem.rows
    columns = products(problem.drivers)
    mean, spread = standard(columns, rows)
    zero = float(seen.residual_mm.mean())
    weights = _sparse(table(columns, mean, spread)[:rows], seen.residual_mm - zero)

    def adds_mm(other: Problem) -> Array:
        return zero + table(products(other.drivers), mean, spread) @ weights

    if not weights.any():
        return Learnt([], adds_mm)
    largest = int(np.argmax(np.abs(weights)))
    return Learnt(stands_for(list(columns)[largest], weights[largest]), adds_mm)


def _sparse(table: Array, target: Array) -> Array:
    """Weights of the columns, many of them zero; the mean of `target` is 0."""
    samples, size = len(target), float(np.sqrt(np.mean(np.square(target))))
    best = np.zeros(table.shape[1])
    if size == 0.0:
        return best
    cost = samples * np.log(size**2)
    for threshold in THRESHOLDS * size:
        sparse = STLSQ(threshold=threshold, alpha=RIDGE * samples, unbias=False)
        model = SINDy(optimizer=sparse, feature_library=IdentityLibrary())
        with warnings.catch_warnings():
            # that no term stays is an answer here, and costs what it costs
            warnings.filterwarnings("ignore", "Sparsity parameter is too big", UserWarning)
            model.fit(table, t=1.0, x_dot=target[:, None])
        weights = model.coefficients()[0]
        mean_square = float(np.mean(np.square(target - table @ weights)))
        own = samples * np.log(mean_square) + np.log(samples) * np.count_nonzero(weights)
        if own < cost:
            best, cost = weights, own
    return np.asarray(best)
