"""The explanations that tie with the best one, as simulators: on a new motion they may predict different readings."""

from ...run.description import Included
from ..choice.outcome import Study
from ..choice.search import Explanation
from ..document.content import Rival
from ..document.effects_named import Dimension
from ..fit.adopt import DIGITS, entries
from ..fit.calibrate import calibrate
from ..fit.problem import Problem, State
from ..fit.uncertainty import zero_names


def refitted(study: Study, explanation: Explanation) -> State:
    """An explanation as the search found it, its dimensions, zeros and coefficients refitted through the simulator."""
    state = study.search.linear.state_of(explanation.fit, explanation.keys)
    acts = tuple(act for act in state.acts if act not in study.problem.included)
    return calibrate(study.problem, study.noise, state, acts)


def rivals(study: Study, ending: str) -> list[Rival]:
    """The explanations that tie with the best, in the order of `alternatives`; `ending`: of the channel.

    Each is refitted through the simulator: the search's straight lines miss the recording where dimensions moved far.
    """
    problem, simulators = study.problem, []
    for explanation in study.sets[1:]:
        state = refitted(study, explanation)
        simulators.append(named_simulator(problem, state, list(explanation.ids), ending))
    return simulators


def named_simulator(problem: Problem, state: State, ids: list[str], ending: str) -> Rival:
    """A state as a simulator, with the ids of its acts that are not from run.yaml; `ending`: of the channel."""
    parameters, simulation = as_simulator(problem, state, ending)
    return Rival(ids=ids, parameters=parameters, simulation=simulation)


def as_simulator(problem: Problem, state: State, ending: str) -> tuple[dict[str, Dimension], list[Included]]:
    """A state in the form of a simulator in a diagnosis: dimensions, the zero of each run, and the acts."""
    values = {problem.parameters[index].name: float(state.values[index]) for index in problem.movable}
    if problem.system.free_zero:
        values |= dict(zip(zero_names(problem, ending), state.zeros.tolist(), strict=True))
    parameters: dict[str, Dimension] = {name: {"value": float(f"{value:.{DIGITS}g}")} for name, value in values.items()}
    return parameters, entries(state.acts, problem.drivers)
