"""Recordings that hardly differ from their noise decide nothing: they are refused, with the size of both."""

from pathlib import Path

import numpy as np

from ..ground.errors import BadInput
from .choice.outcome import Study, rms
from .fit.flexible import foretold
from .fit.problem import Problem, State
from .study.heldout import first_held_out
from .words.language.quantity import size

LEAST_MOTION = 20.0  # times the noise that the reading must move: less shows no physics


def refuse_faint(study: Study, folder: Path) -> None:
    """Raise BadInput where the reading hardly exceeds the noise, so that any verdict would be a guess.

    What was measured to move counts, or what should have moved where that is more. What a regression without physics
    foretells of strokes that it has not seen is no noise, even if no mechanism explains it.
    """
    problem, floor = study.problem, study.floor
    measured = float(np.subtract(*np.percentile(problem.measured[: problem.rows], [99.5, 0.5])))
    moved = max(measured, float(np.ptp(problem.simulate(study.nominal)[: problem.rows])))
    if moved < LEAST_MOTION * floor:
        floor = min(floor, unforeseen(problem, study.base))
    if moved < LEAST_MOTION * floor:
        unit = problem.drivers.units.reading
        gap = f"moves by {size(moved, unit)} and has a noise of {size(floor, unit)}: nothing can be told from it"
        mend = "record strokes over more turns, or with a finer sensor"
        if problem.system.differentiates:
            mend += "; or set a lower working_hz in its system"
        raise BadInput(folder, problem.system.channel, gap, mend)


def unforeseen(problem: Problem, state: State) -> float:
    """The rms residual of a state on the later strokes, less what a regression on the earlier ones foretells.

    It is infinite where there are too few strokes to hold any out.
    """
    row = first_held_out(problem)
    if row is None:
        return float("inf")
    unseen = np.arange(len(problem.record)) >= row
    residual = problem.measured - problem.simulate(state)
    return rms((residual - foretold(problem, problem, state, unseen).added)[unseen])
