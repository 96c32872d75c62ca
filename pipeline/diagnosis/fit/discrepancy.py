"""Model discrepancy: how an effect may differ from its formula, since no formula is exactly right.

Source: Kennedy and O'Hagan, "Bayesian calibration of computer models", Journal of the Royal Statistical Society B 63,
2001.
"""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .generic import hats
from .problem import Problem, State

SIGMA = 0.1  # of the effect, in each of the ways below
MEMORIES = (0.02, 0.08, 0.25)  # half-widths of plays, of the range of motion: how an effect may turn at reversals


def effect(problem: Problem, state: State, id_: str) -> Array:
    """The part of the prediction that comes from the acts of one mechanism. Shape (samples,), in the reading's unit."""
    rest = State(state.values, state.zeros, tuple(act for act in state.acts if act.id != id_))
    return problem.simulate(state) - problem.simulate(rest)


def bumps(signal: Array, weight: Array, count: int) -> Array:
    """Piecewise linear bumps over a signal; between two knots lie equal shares of the weight.

    Shape (bumps, samples), shares of 1.
    """
    order = np.argsort(signal, kind="stable")
    share = np.cumsum(weight[order])
    if share[-1] <= 0.0:
        return np.zeros((0, len(signal)))
    knots = np.unique(np.interp(np.linspace(0.01, 0.99, count) * share[-1], share, signal[order]))
    if len(knots) < 2:
        return np.zeros((0, len(signal)))
    return np.array([np.interp(signal, knots, row) for row in np.eye(len(knots))])


def factors(drivers: Drivers, acting: Array) -> Array:
    """Smooth factors of an effect, each about 1 at most, shape (factors, samples).

    Over twist, time, load, rate and direction, and finest where the effect is at work.
    Without a unit; `acting`, shape (samples,), in the reading's unit.
    """
    rate, energy = np.abs(drivers.rate), np.square(acting)
    all_factors = [
        hats(drivers.motion, 6),
        bumps(drivers.motion, energy, 6),
        bumps(drivers.elapsed_s, energy, 5),
        rate[None] / max(float(rate.max()), 1e-9),
        *(drivers.directed(width * drivers.span)[None] for width in MEMORIES),
    ]
    if drivers.loaded:
        all_factors.append(hats(drivers.load, 3))
    return np.vstack(all_factors)


def columns(problem: Problem, states: list[State]) -> dict[str, Array]:
    """One sigma of each deviation from a mechanism's formula, as it adds to the reading; the first state counts.

    Where the reading has a true zero no deviation is a constant: that would be physics of its own.
    Shape (columns, samples), in the reading's unit.
    """
    column_by_name: dict[str, Array] = {}
    for state in states:
        for act in state.acts:
            if act not in problem.included and act.id not in column_by_name:
                acting = effect(problem, state, act.id)
                deviations = SIGMA * acting * factors(problem.drivers, acting)
                column_by_name[act.id] = (
                    deviations if problem.system.free_zero else deviations - deviations.mean(axis=1, keepdims=True)
                )
    return column_by_name
