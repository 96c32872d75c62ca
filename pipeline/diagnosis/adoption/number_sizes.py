"""What each number of adopted effects does to the reading of a recording while all other numbers are held."""

from dataclasses import replace

import numpy as np

from ...ground.kinematics import Array
from ..choice.outcome import rms
from ..fit.problem import Act, Problem, State
from ..words.measured.moved_reading import Size

NEAR = 0.02  # of the motion's range: places nearer to its highest or lowest one count as that


def sizes(problem: Problem, state: State) -> list[list[Size]]:
    """For each act in a state: the size of the whole act, then that of each coefficient that is not 0."""
    whole = problem.simulate(state)

    def size_of(act: Act, instead: Act | None) -> Size:
        acts = tuple(instead if other is act else other for other in state.acts)
        rest = replace(state, acts=tuple(other for other in acts if other is not None))
        return _size(problem, whole - problem.simulate(rest))

    return [
        [
            size_of(act, None),
            *(
                size_of(act, replace(act, coefficients=_without(act.coefficients, place)))
                for place, value in enumerate(act.coefficients)
                if value
            ),
        ]
        for act in state.acts
    ]


def _without(coefficients: tuple[float, ...], place: int) -> tuple[float, ...]:
    return (*coefficients[:place], 0.0, *coefficients[place + 1 :])


def _size(problem: Problem, effect: Array) -> Size:
    """The size of an effect of shape (samples,), in the reading's unit; `rms` is computed as in the verdict."""
    motion = problem.record.motion
    low, high = float(motion.min()), float(motion.max())
    near = NEAR * (high - low)
    at_top = float(np.mean(effect[motion >= high - near]) - np.mean(effect[motion <= low + near]))
    return Size(rms(effect), at_top, (low, high))
