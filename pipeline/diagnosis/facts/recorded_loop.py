"""The loop of the recording itself: by how much winding and unwinding part in it, whatever the cause."""

from dataclasses import replace

from ..fit.problem import Problem, State
from .loops import OTHER_LOAD, widest


def recorded_loop(problem: Problem, base: State, state: State | None = None) -> float:
    """The width of the recorded loop in the reading's unit; with a `state`, that of its simulator in these strokes.

    `base` is calibration alone, whose own effects are taken out.

    0 where no whole stroke follows the first of a run, and where the loads of the recording differ: a loop of several
    loads is none of the usual one.
    """
    load = abs(problem.record.load)
    if load.max() - load.min() > OTHER_LOAD * load.max():
        return 0.0
    reading = problem.measured if state is None else problem.simulate(state)
    shown = widest(problem, reading - problem.simulate(replace(base, acts=())))
    return shown.width if shown else 0.0
