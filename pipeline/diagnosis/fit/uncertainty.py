"""The joint uncertainty of all fitted numbers: a prediction along another motion needs it.

Source: the Laplace approximation of a posterior, MacKay, Neural Computation 4, 1992.
"""

import numpy as np

from ...ground.kinematics import Array
from ..document.content import Doubt
from ..mechanisms.library import mechanisms
from .intervals import continuous
from .problem import Problem, State

DIGITS = 5


def factor(covariance: Array) -> Array:
    """The lower triangle L with L·Lᵀ equal to a covariance; rounding may have made that a little negative.

    Both of shape (numbers, numbers), in the numbers' own units.
    """
    sigma = np.sqrt(np.maximum(np.diag(covariance), np.finfo(float).tiny))
    values, vectors = np.linalg.eigh(covariance / np.outer(sigma, sigma))
    _, upper = np.linalg.qr((vectors * np.sqrt(np.maximum(values, 0.0))).T)
    return np.asarray(sigma[:, None] * (upper * np.where(np.diag(upper) < 0.0, -1.0, 1.0)[:, None]).T)


def zero_names(problem: Problem, ending: str) -> list[str]:
    """The name of each run's zero in a diagnosis; `ending`: of the channel."""
    return [f"zero_{ending}"] if problem.runs == 1 else [f"zero_{run + 1}_{ending}" for run in range(problem.runs)]


def doubts(problem: Problem, state: State, covariance: Array, ending: str) -> list[Doubt]:
    """The joint uncertainty of all fitted numbers: zeros, dimensions, coefficients and nonlinear parameters.

    `covariance` is that of `intervals`, of shape (numbers, numbers) in its units and order; `ending` that of the
    channel. Nothing where it is no number.
    """
    if not np.isfinite(covariance).all():
        return []
    numbers = [Doubt(name=name, moves=[]) for name in zero_names(problem, ending)]
    numbers += [Doubt(name=problem.parameters[index].name, moves=[]) for index in problem.movable]
    units = [1.0] * len(numbers)
    own = [act for act in state.acts if act not in problem.included]
    entry = {act.id: sum(len(other.nonlinear) for other in problem.included if other.id == act.id) for act in own}
    name_of = problem.drivers.units.name
    for act in own:
        for number, nonlinear in enumerate(act.nonlinear):
            terms = problem.terms(mechanisms()[act.id], nonlinear)
            place = entry[act.id] + number
            numbers += [Doubt(name=name_of(term.name), moves=[], id=act.id, entry=place) for term in terms]
            units += [1.0] * len(terms)
    for act in own:
        for number, name in continuous(problem, act):
            numbers.append(Doubt(name=name_of(name), moves=[], id=act.id, entry=entry[act.id] + number))
            units.append(0.5 * act.nonlinear[number][name])
    rows = factor(covariance) * np.array(units)[:, None]
    for place, doubt in enumerate(numbers):
        doubt["moves"] = [float(f"{move:.{DIGITS}g}") + 0.0 for move in rows[place, : place + 1]]
    return numbers if problem.system.free_zero else numbers[problem.runs :]
