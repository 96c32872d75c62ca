"""One step of a fit through the simulator: taken whole if that lowers the misfit, else shorter until it does.

Source: Hartley, "The modified Gauss-Newton method for the fitting of non-linear regression functions by least squares",
Technometrics 3, 1961.
"""

import numpy as np

from ..numerics.noise import Noise
from ..numerics.recursions import whiten
from .linear import Key, Linear
from .problem import Act, Problem, State

SHORTER, LONGER = 0.25, 3.0  # times the reach of a step, after one that failed and after one that did not
SHORTEST = 1e-4  # of the range of calibration: without a better simulator within it, the fit is at an optimum
ROUNDING = 1e-9  # of a misfit


def misfit_of(problem: Problem, noise: Noise, state: State) -> float:
    """The whitened misfit of a state in the rows that a fit sees, plus the cost of moved dimensions; inf for NaN.

    It is what `Linear` minimises, but of the simulator itself, not of a straight line beside it. A zero has no price:
    where the reading begins to count is arbitrary.
    """
    residual = (problem.measured - problem.simulate(state))[: problem.rows]
    if not np.isfinite(residual).all():
        return float("inf")
    innovations = whiten(residual[None], noise.ar, problem.drivers.first[: problem.rows])[0] / noise.innovation
    moved = [(state.values[i] - problem.parameters[i].nominal) / problem.parameters[i].sigma for i in problem.movable]
    return float(innovations @ innovations + np.sum(np.square(moved)))


class Steps:
    """Steps from a state to better ones, in a region of trust that shrinks when a step fails and grows when not."""

    def __init__(self, problem: Problem, noise: Noise, state: State, acts: tuple[Act, ...]) -> None:
        self.problem, self.noise, self.state, self.acts = problem, noise, state, acts
        self.misfit = misfit_of(problem, noise, state)
        self.reach = 1.0  # of the ways that calibration may go, and that a coefficient would; 1 is a whole step

    def take(self, linear: Linear, keys: tuple[Key, ...]) -> bool:
        """Go to the target of a linearised fit, or part of the way; False and no step where none lowers the misfit.

        While no step fails, each is the whole one.
        """
        columns = linear.columns_of(keys)
        whole = linear.fit(columns)
        coefficients = [value for act in self.acts for value in act.coefficients]
        stands = np.concatenate([linear.begin[linear.calibration], coefficients])
        ways = np.abs(whole.coefficients - stands)
        dimensions = slice(self.problem.runs, len(linear.calibration))  # a zero is exactly linear
        ways[dimensions] = 0.5 * (linear.high - linear.low)[linear.calibration][dimensions]
        ways[: self.problem.runs] = np.inf
        while self.reach > SHORTEST:
            near = self.reach * ways
            fit = whole if self.reach == 1.0 else linear.fit(columns, stands - near, stands + near)
            state = linear.state_of(fit, keys)
            after = misfit_of(self.problem, self.noise, state)
            if after <= self.misfit * (1.0 + ROUNDING):
                self.state, self.misfit, self.reach = state, after, min(LONGER * self.reach, 1.0)
                self.acts = tuple(act for act in state.acts if act not in self.problem.included)
                return True
            self.reach *= SHORTER
        return False
