"""The motor's zero of a run that a diagnosis was not made of: homed anew, on the first stroke of its recording.

A motor that was switched off in between counts its turns from elsewhere, and a string's contraction grows ever faster
with them: a diagnosis of one recording is far off in another until that zero is found.

Source: Brent, Algorithms for Minimization without Derivatives, 1973 (the least of a function between two bounds).
"""

from dataclasses import dataclass
from pathlib import Path
from typing import cast

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from ...ground.kinematics import Array
from ..document.content import Simulated
from ..fit.problem import Problem
from .simulation import TARE_S, simulated, value_of

HOME = "--home"  # the option
BOUND, TRIED = 3.0, 25  # sigma that the zero may lie from that of run.yaml; places that are tried first


@dataclass(frozen=True)
class Home:
    """A motor's zero, homed: `value` in turns, `before` in the diagnosis.

    `left` is what the homed simulator leaves of the first stroke about its mean. The errors are those of the rest of
    the recording, its zero set on the first second. All three are rms, in the reading's unit.
    """

    value: float
    before: float
    error: float
    error_before: float
    at_bound: bool
    left: float


def homed(
    problem: Problem, content: Simulated, path: Path, run: str, coarse: Problem | None = None
) -> tuple[Simulated, Home]:
    """The simulator with the motor's zero that fits the first stroke of a run best, and that zero.

    `coarse`: the same recording in averages, on which the places that are tried first are told apart.

    The rig has such a zero. Raises BadInput where the simulator gives no number.
    """
    name = str(problem.system.homed)
    parameter = next(parameter for parameter in problem.parameters if parameter.name == name)
    first = _first_stroke(problem)

    def at(value: float) -> Simulated:
        return cast(Simulated, {**content, "parameters": {**content["parameters"], name: {"value": value}}})

    def residual_at(value: float) -> Array:
        return problem.measured - simulated(problem, at(value), path, run)

    def of_first(value: float) -> float:
        return left_of_first(problem, at(value), path, run)

    def roughly(value: float) -> float:
        return left_of_first(coarse or problem, at(value), path, run)

    reach = BOUND * parameter.sigma
    places = np.linspace(parameter.nominal - reach, parameter.nominal + reach, TRIED)
    best, step = float(min(places, key=roughly)), float(places[1] - places[0])
    if step > 0.0:
        ends = max(best - step, float(places[0])), min(best + step, float(places[-1]))
        best = float(minimize_scalar(of_first, bounds=ends, method="bounded", options={"xatol": 1e-3 * step}).x)
    before = value_of(content, name, path, parameter.nominal)
    error, error_before = (_rest(problem, residual_at(value), first) for value in (best, before))
    at_bound = abs(best - parameter.nominal) > 0.99 * reach
    return at(best), Home(best, before, error, error_before, at_bound, of_first(best))


def left_of_first(problem: Problem, content: Simulated, path: Path, run: str) -> float:
    """The rms residual of a simulator on a run's first stroke, about its mean where the reading's zero is free.

    Rms, in the reading's unit. Raises BadInput where the simulator gives no number.
    """
    residual = (problem.measured - simulated(problem, content, path, run))[_first_stroke(problem)]
    return float(np.std(residual) if problem.system.free_zero else np.sqrt(np.mean(np.square(residual))))


def _first_stroke(problem: Problem) -> NDArray[np.bool_]:
    """Rows from the start to the end of the first stroke, shape (samples,)."""
    stroke = problem.record.stroke
    return np.arange(len(stroke)) <= int(np.flatnonzero(stroke == stroke[stroke > 0].min())[-1])


def _rest(problem: Problem, residual: Array, first: NDArray[np.bool_]) -> float:
    """The rms error after the first stroke, or of all where nothing follows, about the zero of the first second."""
    time_s = problem.record.time_s
    rows = ~first if not first.all() else first
    return float(np.sqrt(np.mean(np.square(residual[rows] - np.median(residual[time_s - time_s[0] <= TARE_S])))))
