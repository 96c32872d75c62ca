"""The input and the output of every baseline: a calibrated simulator's residual, and a correction of its reading."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypedDict

import numpy as np

from ...diagnosis.fit import calibrate
from ...diagnosis.fit.problem import Problem, State
from ...diagnosis.recording.working_samples import wild
from ...diagnosis.study.engine import rms
from ...diagnosis.study.heldout import first_held_out
from ...ground.kinematics import Array


@dataclass(frozen=True)
class Calibrated:
    """A problem of which a method sees the first `rows` samples, with the simulator calibrated on these."""

    problem: Problem
    state: State

    @cached_property
    def residual_mm(self) -> Array:
        """Recording less simulator where a method may look, shape (rows,)."""
        return np.asarray((self.problem.measured - self.problem.simulate(self.state))[: self.problem.rows])


@dataclass(frozen=True)
class Learnt:
    """The result of a method: mechanisms by name (None: it names none), and mm to add to the reading."""

    named: list[str] | None
    adds_mm: Callable[[Problem], Array]


class Said(TypedDict):
    """A method's result on a recording, as baselines.json holds it; None: it names nothing, or nothing was held out."""

    named: list[str] | None
    heldout_mm: float | None
    seconds: float


Method = Callable[[Calibrated], Learnt]


def calibrated(problem: Problem) -> Calibrated:
    """The simulator calibrated on the rows that the problem shows, wild readings set aside as the diagnosis does."""
    problem, _ = calibrate.without_outliers(problem, calibrate.base(problem))
    return Calibrated(problem, calibrate.base(problem))


def held_out_mm(method: Method, problem: Problem, fine: Problem) -> float | None:
    """Rms error in mm on the last 30 % of strokes after learning from the others, or None when too few are left.

    As the diagnosis measures it: at the recording's own rate, zero as calibrated, lonely wild readings left out.
    """
    row = first_held_out(problem)
    if row is None:
        return None
    seen = calibrated(problem.until(row))
    unseen = fine.record.time_s >= problem.record.time_s[row]
    residual = fine.measured - fine.simulate(seen.state) - method(seen).adds_mm(fine)
    return rms(residual[unseen & ~wild(residual)[0]])
