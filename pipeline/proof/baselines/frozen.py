"""A problem with its calibration frozen: its dimensions stay where they are, only the zero of the reading is free."""

from dataclasses import replace

import numpy as np

from ...diagnosis.fit.problem import Problem, State


def frozen(problem: Problem, state: State) -> Problem:
    """The same problem with every dimension fixed at a state's value, so that a fit moves mechanisms and zero alone."""
    fixed = [
        replace(parameter, nominal=float(value), sigma=0.0, lowest=-np.inf)
        for parameter, value in zip(problem.parameters, state.values, strict=True)
    ]
    return replace(problem, parameters=tuple(fixed))
