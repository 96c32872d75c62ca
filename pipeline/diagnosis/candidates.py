"""What a search may choose from: every shape that a recording can show or suggests, and what has no physics at all."""

import numpy as np

from ..systems.interface import PORTS
from . import generic
from .interface import Shape
from .library import mechanisms
from .problem import Problem, State, placed


def suggested(problem: Problem, state: State) -> dict[str, list[Shape]]:
    """Shapes that what a state leaves makes plausible, by mechanism."""
    residual = (problem.measured - problem.simulate(state))[: problem.rows]
    return {id_: mechanism.suggest(problem.drivers, residual) for id_, mechanism in problem.library.items()}


def catalogue(problem: Problem, more: dict[str, list[Shape]]) -> dict[str, list[Shape]]:
    """All shapes of all mechanisms that the recording could show, and those that it suggests."""
    catalogued = {id_: mechanism.shapes(problem.drivers) + more[id_] for id_, mechanism in problem.library.items()}
    if not set(PORTS) <= set(problem.system.ports):  # the shapes that act where the system has a port
        catalogued = {
            id_: [shape for shape in shapes if placed(problem.system, problem.terms(mechanisms()[id_], shape))]
            for id_, shapes in catalogued.items()
        }
    return {id_: shapes for id_, shapes in catalogued.items() if shapes}


def without_physics(problem: Problem, more: dict[str, list[Shape]]) -> np.ndarray:
    """The generic dictionary, and what acts on the reading alone in the shapes that a recording suggests.

    Shape (columns, samples), in the reading's unit.
    """
    terms = [
        term for id_, shapes in more.items() for shape in shapes for term in problem.terms(mechanisms()[id_], shape)
    ]
    waves = [term.signal for term in terms if term.port == "sensor" and not callable(term.signal)]
    return np.vstack([generic.dictionary(problem.drivers), *waves])


def with_refined(problem: Problem, shapes: dict[str, list[Shape]], states: list[State]) -> dict[str, list[Shape]]:
    """The catalogue with the refined shapes of what acts in some states."""
    near = {id_: list(options) for id_, options in shapes.items()}
    for state in states:
        for act in state.acts:
            if act not in problem.included:
                near[act.id] += [shape for shape in act.shapes if shape not in near[act.id]]
    return near
