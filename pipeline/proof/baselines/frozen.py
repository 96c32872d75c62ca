"""A problem with its calibration frozen: its dimensions stay where they are, only the zero of the reading is free."""

from dataclasses import replace

from ...diagnosis.fit.problem import Problem, State
from ...systems import Parameter


def frozen(problem: Problem, state: State) -> Problem:
    """The same problem with every dimension fixed at a state's value, so that a fit moves mechanisms and zero alone."""
    fixed = [
        Parameter(known.name, float(value), 0.0) for known, value in zip(problem.parameters, state.values, strict=True)
    ]
    return replace(problem, parameters=tuple(fixed))
