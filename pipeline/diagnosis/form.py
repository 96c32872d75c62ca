"""The formula of a mechanism is never exactly right: how its effect may differ from what the library says of it."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.generic import hats
from pipeline.diagnosis.problem import Problem, State
from pipeline.kinematics import Array

SIGMA = 0.1  # of the effect, in each of the ways below


def effect(problem: Problem, state: State, id_: str) -> Array:
    """What the prediction owes to the acts of one mechanism."""
    rest = State(state.values, state.zeros, tuple(act for act in state.acts if act.id != id_))
    return problem.simulate(state) - problem.simulate(rest)


def factors(drivers: Drivers) -> Array:
    """Smooth factors of an effect, each about 1 at most: over twist, time, load and rate; shape (factors, samples)."""
    rate = np.abs(drivers.rate)
    found = [hats(drivers.turns, 6), hats(drivers.elapsed_s, 5), rate[None] / max(float(rate.max()), 1e-9)]
    if drivers.loaded:
        found.append(hats(drivers.load, 3))
    return np.vstack(found)


def columns(problem: Problem, states: list[State]) -> dict[str, Array]:
    """By mechanism, what one sigma of each deviation from its formula adds to the reading; the first state counts."""
    found: dict[str, Array] = {}
    ways = factors(problem.drivers)
    for state in states:
        for act in state.acts:
            if act not in problem.included and act.id not in found:
                found[act.id] = SIGMA * effect(problem, state, act.id) * ways
    return found
