"""Lessons → a judge: the weights under which what was hidden is likeliest, held small by a normal prior."""

import numpy as np
from scipy.optimize import minimize

from ...diagnosis.numerics.judge import SIZES, Judge, Weighed, none_of
from ...ground.kinematics import Array
from .lesson import Lesson

QUANTILES = (0.02, 0.35, 0.65, 0.98)  # of a sign over all explanations: knots of its ramps
PRIOR = 1.0  # one over the variance of a weight


def explanations(lesson: Lesson) -> list[Weighed]:
    """A lesson's explanations as the judge sees them."""
    return [Weighed(ids, signs) for ids, signs in zip(lesson.ids, lesson.signs, strict=True)]


def blank(lessons: list[Lesson]) -> Judge:
    """A judge that knows the signs and names of some lessons, and holds all alike."""
    every = [signs for lesson in lessons for signs in lesson.signs]
    knots = {}
    for name in every[0]:
        knots_there = np.unique(np.round(np.quantile([signs[name] for signs in every], QUANTILES), 5))
        if len(knots_there) > 1:
            knots[name] = knots_there.tolist()
    names = sorted({id_ for lesson in lessons for ids in lesson.ids for id_ in ids})
    ramps = sum(len(positions) - 1 for positions in knots.values())
    return Judge(knots, names, np.zeros((1 + len(SIZES)) * (1 + ramps + len(names))), np.zeros(5))


def fitted(lessons: list[Lesson], prior: float = PRIOR) -> Judge:
    """The judge whose softmax makes the right answers of some lessons likeliest.

    "None of them" is right where none is, and so is a set without physics of the library.
    """
    judge = blank(lessons)
    seen = [explanations(lesson) for lesson in lessons]
    table = np.vstack([judge.basis(case_explanations) for case_explanations in seen])
    none = np.array([none_of(case_explanations) for case_explanations in seen])
    starts = np.cumsum([0, *map(len, seen)])[:-1]
    case = np.repeat(np.arange(len(seen)), [len(case_explanations) for case_explanations in seen])
    right = np.concatenate([np.array(lesson.answers, float) for lesson in lessons])
    named = np.array([any(lesson.right) for lesson in lessons])
    count = table.shape[1]

    def surprise(weights: Array) -> tuple[float, Array]:
        scores, of_none = table @ weights[:count], none @ weights[count:]
        top = np.maximum(np.maximum.reduceat(scores, starts), of_none)
        odds, none_odds = np.exp(scores - top[case]), np.exp(of_none - top)
        whole = np.add.reduceat(odds, starts) + none_odds
        good = np.add.reduceat(odds * right, starts) + np.where(named, 0.0, none_odds)
        slope = odds / whole[case] - right * odds / good[case]
        none_slope = none_odds / whole - np.where(named, 0.0, none_odds / good)
        gradient = np.concatenate([table.T @ slope, none.T @ none_slope])
        return float(-np.sum(np.log(good / whole)) + 0.5 * prior * weights @ weights), gradient + prior * weights

    solution = minimize(
        surprise, np.zeros(count + none.shape[1]), jac=True, method="L-BFGS-B", options={"maxiter": 500}
    ).x
    return Judge(judge.knots, judge.names, solution[:count], solution[count:])


def content(judge: Judge) -> dict[str, object]:
    """A judge as the content of its file."""
    return {
        "knots": judge.knots,
        "names": judge.names,
        "weights": [float(f"{value:.4g}") for value in judge.weights],
        "of_none": [float(f"{value:.4g}") for value in judge.of_none],
    }
