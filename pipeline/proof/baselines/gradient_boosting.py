"""Boosted trees on the residual over driver features: they interpolate well and name nothing.

Source: Friedman, "Greedy function approximation: a gradient boosting machine", Annals of Statistics 29, 2001.
"""

from sklearn.ensemble import HistGradientBoostingRegressor

from ...diagnosis.fit.problem import Problem
from ...ground.kinematics import Array
from .driver_columns import plain, standard, table
from .learnt import Calibrated, Learnt


def learn(seen: Calibrated) -> Learnt:
    """A correction by trees; no name."""
    columns, rows = plain(seen.problem.drivers), seen.problem.rows
    mean, spread = standard(columns, rows)
    model = HistGradientBoostingRegressor(max_iter=200, early_stopping=False, random_state=0)
    model.fit(table(columns, mean, spread)[:rows], seen.residual_mm)

    def adds_mm(other: Problem) -> Array:
        return model.predict(table(plain(other.drivers), mean, spread))

    return Learnt(None, adds_mm)
