"""How the reading of a simulator moves with its dimensions and with its acts: one linearisation at a state."""

from dataclasses import dataclass, replace

import numpy as np

from ...ground.kinematics import Array
from ..mechanisms.interface import Term
from ..mechanisms.library import mechanisms
from .problem import Act, Problem, State

STEPS = {"twist": 1e-4, "radius": 1e-5, "length": 1e-3, "resistance": 1e-3}  # of what acts at a port


@dataclass(frozen=True)
class Linearised:
    """A simulator at a state: its channel before operators, its prediction, and the slopes of its reading.

    `slopes` are per unit at each port and of each movable parameter, by name. All of shape (samples,), in the channel's
    unit.
    """

    state: State
    clean: Array
    predicted: Array
    slopes: dict[str, Array]


def linearised(problem: Problem, state: State, unclipped: bool = False) -> Linearised:
    """A simulator at a state, with the slopes of its reading; the slopes are computed once.

    `unclipped`: as if no stop acted. Behind a stop nothing moves the reading, so its rivals would seem to do nothing.
    """
    added, operators = problem.ports(state.acts)
    clean = problem.simulated(state.values, added)
    before, nothing = problem.read(clean, added, operators), np.zeros(len(clean))
    predicted = before + state.zeros[problem.record.run_index]
    if unclipped and any(clips(problem, act) for act in state.acts):
        operators = problem.ports(tuple(act for act in state.acts if not clips(problem, act)))[1]
        before = problem.read(clean, added, operators)
    slopes = {"sensor": np.ones_like(before)}
    slope_by_step: dict[tuple[str, float], Array] = {}  # two ports may be one place of the system
    for port, step in STEPS.items():
        if port in problem.system.ports:
            place = problem.system.ports[port]
            if (place, step) not in slope_by_step:
                moved = {**added, place: added.get(place, nothing) + step}
                slope_by_step[place, step] = (problem.reading(state.values, moved, operators) - before) / step
            slopes[port] = slope_by_step[place, step]
    for index in problem.movable:
        values = state.values.copy()
        step = 1e-3 * problem.parameters[index].sigma
        values[index] += step
        slopes[problem.parameters[index].name] = (problem.reading(values, added, operators) - before) / step
    return Linearised(state, clean, predicted, slopes)


def clips(problem: Problem, act: Act) -> bool:
    """Whether an act clips the reading and is not included in the simulator."""
    return mechanisms()[act.id].clips and act not in problem.included


def untouched(problem: Problem, at: Linearised) -> Linearised:
    """The same linearisation with the channel as if the acts of the state were absent, for rivals of these acts.

    A stop clips the reading of a string without a jam, not one that a jam has kept below the stop.
    """
    acts = tuple(act for act in at.state.acts if act not in problem.included)
    if all(callable(term.signal) or term.port == "sensor" for act in acts for term, _ in problem.act_terms(act)):
        return at
    return replace(at, clean=problem.simulated(at.state.values, problem.ports(problem.included)[0]))


def column(problem: Problem, term: Term, at: Linearised) -> Array:
    """How the reading moves with the coefficient of a term.

    Shape (samples,), in the channel's unit per unit of the coefficient.
    """
    if callable(term.signal):
        return term.signal(at.clean)
    if problem.system.remembers and term.port != "sensor":
        return pushed(problem, term.port, term.signal, at)
    return at.slopes[term.port] * term.signal


def pushed(problem: Problem, port: str, signal: Array, at: Linearised) -> Array:
    """How the simulated channel moves, at once and later, if a small share of a signal is added at a port.

    Shape (samples,), in the channel's unit per unit at the port.
    """
    step = STEPS[port] / max(float(np.sqrt(np.mean(np.square(signal)))), 1e-300)
    added, place = problem.ports(at.state.acts)[0], problem.system.ports[port]
    moved = added[place] + step * signal if place in added else step * signal
    return (problem.simulated(at.state.values, {**added, place: moved}) - at.clean) / step
