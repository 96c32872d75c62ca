"""A Gaussian process on at most 1,000 points of the residual over a few drivers: it is smooth and names nothing.

Source: Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006.
"""

from ...diagnosis.fit.problem import Problem
from ...ground.kinematics import Array
from ...ground.numbers.regression import gaussian_process
from .driver_columns import plain, standard, table
from .learnt import Calibrated, Learnt

POINTS, TUNED_ON = 1000, 300  # points that it knows, and of these those on which its lengths are chosen
FEW = ("twist", "direction", "rate", "load", "time")


def learn(seen: Calibrated) -> Learnt:
    """A correction by the process's mean; no name."""
    rows = seen.problem.rows
    columns = _few(seen.problem)
    mean, spread = standard(columns, rows)
    correction = gaussian_process(table(columns, mean, spread)[:rows], seen.residual_mm, POINTS, TUNED_ON)

    def adds_mm(other: Problem) -> Array:
        return correction(table(_few(other), mean, spread))

    return Learnt(None, adds_mm)


def _few(problem: Problem) -> dict[str, Array]:
    return {name: column for name, column in plain(problem.drivers).items() if name in FEW}
