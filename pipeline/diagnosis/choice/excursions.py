"""Where a reading goes off for a while and comes back: nothing that a string does, and no noise.

A noise that holds such times is told far too loud, and then nothing else seems to be missing.

Source: Hampel, "The influence curve and its role in robust estimation", Journal of the American Statistical Association
69, 1974 (the median of distances as their spread). How far and how long counts is our own: docs/diagnosis.md, step 7.
"""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ...ground.numbers.spans import of_mask
from ..fit.problem import Problem, State

FAR = 5.0  # robust spreads of the residual: noise is never so far off for so long
LASTS_S = 0.5  # a shorter excursion is a spike


@dataclass(frozen=True)
class Excursion:
    """When a reading goes off, on the clock of the recording, for how long, and by how much, in the reading's unit."""

    at_s: float
    lasts_s: float
    size: float


def excursions(problem: Problem, state: State) -> list[Excursion]:
    """The excursions in the residual of a state, in order, in the rows that a fit sees.

    None of a rig that winds nothing, which has other noise, and none beside adopted effects, which are inexact.
    """
    if not problem.drivers.levered or problem.adopted:
        return []
    residual = (problem.measured - problem.simulate(state))[: problem.rows]
    return far_off(residual, problem.record.time_s[: problem.rows])


def far_off(residual: Array, time_s: Array) -> list[Excursion]:
    """The times at which a residual is far from its median, in order; none where much of it is far off.

    `residual` has the shape (samples,), in the reading's unit; `time_s` the same, in s.
    """
    size = np.abs(residual - np.median(residual))
    return [
        Excursion(float(time_s[begin]), float(time_s[end - 1] - time_s[begin]), float(size[begin:end].max()))
        for begin, end in of_mask(size > FAR * 1.4826 * np.median(size))
        if time_s[end - 1] - time_s[begin] >= LASTS_S
    ]
