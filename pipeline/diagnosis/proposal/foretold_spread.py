"""How far the numbers that a simulator predicts may be off: by what its fit leaves open, and by what it missed before.

Source: the Laplace approximation of a posterior, MacKay, Neural Computation 4, 1992.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ...ground.kinematics import Array
from ..fit.intervals import Z90, continuous, intervals
from ..fit.problem import Problem, State
from ..fit.uncertainty import factor
from ..numerics.noise import Noise

SMALL = 0.1  # of a sigma: a step so short is straight


def plus_minus(
    problem: Problem, state: State, noise: Noise, numbers: Callable[[State], dict[str, float]], missed: float
) -> dict[str, float]:
    """Half of the interval that holds nine of ten true values of each number, in its unit, by its key.

    `numbers` gives them for a simulator near `state`; `missed`: by how much unseen strokes were missed, or the noise,
    rms in the same unit. It covers no wrong explanation. Empty where the fit leaves open what is no number.
    """
    covariance = intervals(problem, state, noise).covariance
    if not np.isfinite(covariance).all():
        return {}
    before = numbers(state)
    variance = dict.fromkeys(before, 0.0)
    for direction in factor(covariance).T:
        after = numbers(moved(problem, state, SMALL * direction))
        for key, value in before.items():
            variance[key] += ((after[key] - value) / SMALL) ** 2
    return {key: Z90 * float(np.hypot(np.sqrt(variance[key]), missed)) for key in before}


def moved(problem: Problem, state: State, steps: Array) -> State:
    """A simulator with its fitted numbers moved; `steps`, of shape (numbers,), in order and units of the covariance."""
    values, calibrated = state.values.copy(), problem.runs + len(problem.movable)
    values[problem.movable] += steps[problem.runs : calibrated]
    own = [act for act in state.acts if act not in problem.included]
    shapes, at = [continuous(problem, act) for act in own], calibrated + sum(len(act.coefficients) for act in own)
    acts, begins = [], calibrated
    for act, shape in zip(own, shapes, strict=True):
        coefficients = np.array(act.coefficients) + steps[begins : begins + len(act.coefficients)]
        begins += len(act.coefficients)
        nonlinear = [dict(each) for each in act.nonlinear]
        for number, name in shape:  # in halves of the value
            nonlinear[number][name] *= 1.0 + 0.5 * float(steps[at])
            at += 1
        acts.append(replace(act, nonlinear=tuple(nonlinear), coefficients=tuple(map(float, coefficients))))
    return State(values, state.zeros + steps[: problem.runs], (*problem.included, *acts))
