"""The candidates of a search: those that a recording shows or suggests, and columns without any physics."""

import numpy as np

from ...systems.interface import PORTS
from ..fit import generic
from ..fit.problem import Problem, State, placed
from ..mechanisms.interface import Nonlinear
from ..mechanisms.library import mechanisms


def suggested(problem: Problem, state: State) -> dict[str, list[Nonlinear]]:
    """Candidates that the residual of a state suggests, by mechanism."""
    predicted = problem.simulate(state)[: problem.rows]
    residual = problem.measured[: problem.rows] - predicted
    return {id_: mechanism.suggest(problem.drivers, residual, predicted) for id_, mechanism in problem.library.items()}


def catalogue(problem: Problem, more: dict[str, list[Nonlinear]]) -> dict[str, list[Nonlinear]]:
    """All candidates of all mechanisms that the recording could show, and the suggested candidates."""
    catalogued = {id_: mechanism.candidates(problem.drivers) + more[id_] for id_, mechanism in problem.library.items()}
    if not set(PORTS) <= set(problem.system.ports):  # those that act where the system has a port
        catalogued = {
            id_: [
                nonlinear
                for nonlinear in options
                if placed(problem.system, problem.terms(mechanisms()[id_], nonlinear))
            ]
            for id_, options in catalogued.items()
        }
    return {id_: options for id_, options in catalogued.items() if options}


def without_physics(problem: Problem, more: dict[str, list[Nonlinear]]) -> np.ndarray:
    """The generic dictionary, and the suggested terms that act on the reading alone.

    Shape (columns, samples), in the reading's unit.
    """
    terms = [
        term
        for id_, options in more.items()
        for nonlinear in options
        for term in problem.terms(mechanisms()[id_], nonlinear)
    ]
    waves = [term.signal for term in terms if term.port == "sensor" and not callable(term.signal)]
    return np.vstack([generic.dictionary(problem.drivers), *waves])


def with_refined(
    problem: Problem, catalogued: dict[str, list[Nonlinear]], states: list[State]
) -> dict[str, list[Nonlinear]]:
    """The catalogue with the refined parameters of the acts in some states added."""
    near = {id_: list(options) for id_, options in catalogued.items()}
    for state in states:
        for act in state.acts:
            if act not in problem.included:
                near[act.id] += [nonlinear for nonlinear in act.nonlinear if nonlinear not in near[act.id]]
    return near


def apart(ids: tuple[str, ...]) -> bool:
    """Whether all mechanisms of a set follow different drivers.

    Two laws of one driver imitate anything, and name nothing.
    """
    return len({mechanisms()[id_].driver for id_ in ids}) == len(ids)
