"""Stand-ins for what named effects leave: each acts in the simulator from then on, like a dimension, and is no name.

A drive's transmission errs by the place. Where no stand-in takes up that error, effects are named that only imitate
its shape.

Source: Björck, Numerical Methods for Least Squares Problems, 1996.
"""

from dataclasses import replace

import numpy as np

from ...ground.kinematics import Array
from ..choice.cross_validation import STRETCHES
from ..choice.outcome import Study
from ..fit.calibrate import calibrate
from ..fit.problem import Act, Problem, State
from ..mechanisms.interface import Mechanism, Nonlinear

NAMED = ("explained", "ambiguous")  # verdicts after which something can be left of what is named
FORETOLD = 0.9  # of the named effects' error on left-out stretches: a curve that leaves more may be chance


def with_stand_ins(study: Study) -> Problem | None:
    """The problem with stand-ins in its simulator for what named effects leave; None where no stand-in foretells it."""
    problem, acting = study.problem, {act.id for act in study.best.acts}
    taken: list[Act] = []
    for mechanism in problem.library.values() if study.verdict in NAMED else ():
        if mechanism.id not in acting:
            taken += [
                fitted(study, mechanism, nonlinear)
                for nonlinear in mechanism.beside(problem.drivers)
                if left_by(problem, study.best, columns(problem, mechanism, nonlinear)) < FORETOLD
            ]
    return replace(problem, included=(*problem.included, *taken), beside=tuple(taken)) if taken else None


def columns(problem: Problem, mechanism: Mechanism, nonlinear: Nonlinear) -> Array:
    """What a stand-in can add to the reading, in the rows that a fit sees. Shape (columns, rows), in any unit."""
    signals = [term.signal for term in problem.terms(mechanism, nonlinear) if not callable(term.signal)]
    return np.array(signals)[:, : problem.rows]


def left_by(problem: Problem, state: State, table: Array) -> float:
    """The rms error with added columns on left-out stretches, divided by the error of the state alone.

    `table` has the shape (columns, rows), in any unit.
    """
    residual = (problem.measured - problem.simulate(state))[: problem.rows]
    table = np.vstack([table, np.ones(problem.rows)])
    with_it, alone = 0.0, 0.0
    for rows in np.array_split(np.arange(problem.rows), STRETCHES):
        fit = np.delete(np.arange(problem.rows), rows)
        solution = np.linalg.lstsq(table[:, fit].T, residual[fit], rcond=None)[0]
        with_it += float(np.sum(np.square(residual[rows] - solution @ table[:, rows])))
        alone += float(np.sum(np.square(residual[rows] - np.median(residual[fit]))))
    return float(np.sqrt(with_it / alone)) if alone else 1.0


def fitted(study: Study, mechanism: Mechanism, nonlinear: Nonlinear) -> Act:
    """A stand-in, fitted together with what is named, the dimensions and the zeros."""
    problem = study.problem
    named = tuple(act for act in study.best.acts if act not in problem.included and act.id not in study.random)
    act = Act(mechanism.id, (nonlinear,), (0.0,) * len(problem.terms(mechanism, nonlinear)))
    begin = replace(study.best, acts=(*problem.included, *named))
    state = calibrate(problem, study.noise, begin, (*named, act))
    return next(each for each in state.acts if each.id == mechanism.id)


def clearer(again: Study, first: Study) -> bool:
    """Whether a study with stand-ins still names something, in no more explanations and no more effects in the best.

    A stand-in takes the place of effects that only bend into its shape. It is no reason to name further ones.
    """
    fewer = len(again.sets) <= len(first.sets) and len(again.best_ids) <= len(first.best_ids)
    return again.verdict in NAMED and fewer
