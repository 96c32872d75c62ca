"""The noise floor that a diagnosis states: at most the rms that the simulator leaves on the same values.

The estimate that decides also counts the noise that generic shapes could have taken away. Of noise with much slow
wander these shapes take more than there is. The estimate then exceeds the whole residual, and is no size of the noise.
"""

import numpy as np

from ..choice.outcome import Study, rms
from ..fit.problem import Problem
from ..numerics.noise import robust

ABOVE = 1.1  # times the residual: a larger estimate is no size of the noise; a smaller excess is chance


def told_floor(study: Study) -> float:
    """The floor of the values that were compared, in the reading's unit."""
    problem = study.problem
    states = (study.base, study.best)
    least_rms = min(rms(robust((problem.measured - problem.simulate(state))[: problem.rows])) for state in states)
    return study.floor if study.floor <= ABOVE * least_rms else least_rms


def told_fine_floor(own: float, fine: Problem, study: Study) -> float:
    """The floor at the recording's own rate, estimated as `own`; both in the reading's unit.

    The noise that averaging took off is added to the floor of the averages.
    """
    floor = told_floor(study)
    if floor == study.floor:
        return own
    if len(fine.record) == len(study.problem.record):
        return floor
    return float(np.sqrt(max(own**2 - study.floor**2, 0.0) + floor**2))
