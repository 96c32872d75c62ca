"""Recalibration in disguise: a named effect must do something in the recording that moved dimensions could not.

Source: Stark and Parker, "Bounded-variable least squares: an algorithm and applications", Computational Statistics 10,
1995 (the moved dimensions that come closest to an effect).
"""

import numpy as np
from scipy.optimize import lsq_linear

from ...ground.kinematics import Array
from ..fit import discrepancy
from ..fit.linear import Linear
from ..fit.problem import Problem, State
from ..mechanisms.interface import Term, physics
from ..mechanisms.library import mechanisms
from .search import Explanation

TAKEN_BACK = 1000.0  # times its part that dimensions cannot imitate: a larger effect is another set of dimensions
STRAIGHT = 1e-3  # of a signal: a line that leaves less is the signal
IDLE, OUTSIDE, DIMENSIONS = "idle", "outside", "dimensions"  # why an explanation is no name
Why = tuple[str, tuple[str, ...]]  # that, and of which of its mechanisms
LINES = {"twist": 1, "radius": 0, "length": 0}  # degree in the motion that a dimension could have, by port


def outside(problem: Problem, terms: list[Term]) -> bool:
    """Whether a mechanism's corner lies outside the recording, so that only a shift or a line of it is seen.

    Its first twist, say, is taken up below the lowest twist that was recorded.
    """
    return bool(terms) and all(_line(problem, term) for term in terms)


def _line(problem: Problem, term: Term) -> bool:
    """Whether a term is only a constant, or at the twist port only a straight line, in the rows that a fit sees."""
    if callable(term.signal) or term.port not in LINES:
        return False
    rows = slice(0, problem.rows)
    motion = problem.drivers.motion[rows]
    signal = np.broadcast_to(term.signal, len(problem.drivers.motion))[rows]
    off_the_line = signal - np.polyval(
        np.polyfit(motion - motion.mean(), signal, LINES[term.port]), motion - motion.mean()
    )
    return bool(np.sqrt(np.mean(off_the_line**2)) <= STRAIGHT * np.sqrt(np.mean(signal**2)))


def only_calibration(effect: Array, dimensions: Linear) -> bool:
    """Whether dimensions, each moved within its limits, imitate all but a little of an effect.

    `dimensions` is the simulator linearised with nothing acting in it. Shape (samples,), in the reading's unit.
    """
    beyond_dimensions = beyond(effect, dimensions)
    return bool(np.sqrt(np.mean(effect**2)) > TAKEN_BACK * np.sqrt(np.mean(beyond_dimensions**2)))


def beyond(effect: Array, dimensions: Linear) -> Array:
    """The part of an effect that dimensions, each moved within its limits, cannot imitate.

    Both of shape (samples,), in the reading's unit.
    """
    own = dimensions.calibration
    reach = np.maximum(dimensions.high[own] - dimensions.low[own], 1e-12)
    columns = dimensions.table[own].T
    moves = lsq_linear(columns, effect, (-reach, reach), method="bvls").x
    return np.asarray(effect - columns @ moves)


def in_disguise(linear: Linear, explanation: Explanation, dimensions: Linear) -> Why | None:
    """Why an explanation is calibration in disguise, by the linearised simulator; None where it is not."""
    at = len(linear.calibration)
    effects: dict[str, Array] = {}
    for key in explanation.keys:
        columns, nonlinear = linear.index[key], linear.catalogue[key[0]][key[1]]
        if outside(linear.problem, linear.problem.terms(mechanisms()[key[0]], nonlinear)):
            return OUTSIDE, (key[0],)
        moved = explanation.fit.coefficients[at : at + len(columns)] @ linear.table[columns]
        effects[key[0]] = effects.get(key[0], 0.0) + moved
        at += len(columns)
    of = tuple(id_ for id_, effect in effects.items() if only_calibration(effect, dimensions))
    return (DIMENSIONS, of) if of else None


def no_name(problem: Problem, state: State, dimensions: Linear) -> Why | None:
    """Why the acts of a simulator can be no explanation: no strength, or calibration in disguise.

    None where it can. A simulator in which nothing acts names nothing and is none.
    """
    acts = [act for act in state.acts if act not in problem.included]
    at_work = tuple(act.id for act in acts if any(act.coefficients))
    if physics(tuple(act.id for act in acts)) and not physics(at_work):
        return IDLE, ()
    beyond = [act.id for act in acts if outside(problem, [term for term, value in problem.act_terms(act) if value])]
    if beyond:
        return OUTSIDE, tuple(beyond)
    of = tuple(
        id_ for id_ in at_work if only_calibration(discrepancy.effect(problem, state, id_)[: problem.rows], dimensions)
    )
    return (DIMENSIONS, of) if of else None
