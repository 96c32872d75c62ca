"""Where the motor's zero lies in each of several runs: in a break a person may home it, or hang the string anew."""

from dataclasses import replace

from ...run.description import Run
from ...systems import Parameter, System
from ..choice.outcome import Study
from ..document.bounds import HOME_REACH
from ..fit import calibrate
from ..fit.problem import Problem
from ..mechanisms.interface import FOR_GOOD
from ..mechanisms.library import mechanisms

STAYED = 1.5  # tolerances: within them the motor's zero of a named string counts as unmoved from run to run


def one_string(runs: list[Run]) -> bool:
    """Whether all runs name one string."""
    ids = {run.string.id if run.string else None for run in runs}
    return len(ids) == 1 and None not in ids


def of_runs(system: System, runs: list[Run]) -> list[Parameter]:
    """The motor's zero of each run after the first.

    It may go further than a dimension may, so that a step of the twist between two runs is no slip.
    """
    if system.homed is None:
        return []
    first = next(parameter for parameter in system.parameters(runs[0]) if parameter.name == system.homed)
    home = replace(first, nominal=0.0, reach=HOME_REACH)
    return [replace(home, name=f"{first.name}_{number}") for number in range(2, len(runs) + 1)]


def held(problem: Problem) -> Problem:
    """The problem with the motor's zero of each later run held at the first run's.

    A free zero could take up much of what an effect does.
    """
    own = len(problem.parameters) - problem.homed
    still = (replace(parameter, sigma=0.0) for parameter in problem.parameters[own:])
    return replace(problem, parameters=(*problem.parameters[:own], *still))


def moved(problem: Problem, study: Study) -> bool:
    """Whether a held zero may have moved: a free zero moves beside the explanation, or a slip of the twist is named."""
    acts = tuple(act for act in study.best.acts if act not in problem.included)
    named = {act.id for act in acts} | {id_ for explanation in study.sets for id_ in explanation.ids}
    if any(mechanisms()[id_].driver == FOR_GOOD[1] for id_ in named):
        return True
    free = replace(study.problem, parameters=problem.parameters)
    values = calibrate.calibrate(free, study.noise, study.best, acts).values
    own = len(values) - problem.homed
    pairs = zip(values[own:], problem.parameters[own:], strict=True)
    return any(abs(value) > STAYED * parameter.sigma for value, parameter in pairs)
