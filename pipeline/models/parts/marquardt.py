"""Levenberg and Marquardt's damped least squares, for models that know their own Jacobian.

Source: Levenberg, "A method for the solution of certain non-linear problems in least squares", Quarterly of Applied
Mathematics 2, 1944; Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", SIAM Journal 11,
1963.
"""

from collections.abc import Callable

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from ...ground.kinematics import Array
from ...ground.words.progress import steps as shown

Problem = Callable[[Array], tuple[Array, Array]]  # parameters → residuals (rows,), Jacobian (rows, parameters)
FIRST_DAMPING, SOFTER, HARDER, HARDEST = 1e-3, 0.2, 8.0, 1e9
ENOUGH = 1e-6  # relative gain of a step below which the fit is done


def least_squares(problem: Problem, start: Array, ridge: Array, steps: int) -> Array:
    """Parameters that make Σ residuals² + Σ ridge · parameters² least, shape (parameters,), in at most `steps` steps.

    `ridge` holds a weight for each parameter. Raises ArithmeticError when the residuals at the start are not finite.
    Parameters and residuals have whatever units the problem gives them.
    """

    def cost(residuals: Array, parameters: Array) -> float:
        return float(residuals @ residuals + ridge @ parameters**2)

    parameters, damping = start.copy(), FIRST_DAMPING
    residuals, jacobian = problem(parameters)
    now = cost(residuals, parameters)
    if not np.isfinite(now):
        raise ArithmeticError("the residuals are not finite at the start of the fit")
    for _ in shown(range(steps), "step"):
        square = jacobian.T @ jacobian
        square[np.diag_indices_from(square)] += ridge
        downhill = jacobian.T @ residuals + ridge * parameters
        size = np.maximum(np.diag(square), 1e-12 * float(np.max(np.diag(square))))
        while damping < HARDEST:
            step = -cho_solve(cho_factor(square + np.diag(damping * size)), downhill)
            tried_residuals, tried_jacobian = problem(parameters + step)
            tried = cost(tried_residuals, parameters + step)
            if tried < now:
                break
            damping *= HARDER
        else:
            return parameters
        gained, now = (now - tried) / now, tried
        parameters, residuals, jacobian, damping = parameters + step, tried_residuals, tried_jacobian, damping * SOFTER
        if gained < ENOUGH:
            break
    return parameters
