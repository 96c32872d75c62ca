"""Lessons → a judge: the weights under which the hidden effects are likeliest, kept small by a normal prior.

Source: McFadden, "Conditional logit analysis of qualitative choice behavior", in Zarembka, Frontiers in Econometrics,
1974; Byrd, Lu, Nocedal and Zhu, "A limited memory algorithm for bound constrained optimization", SIAM Journal on
Scientific Computing 16, 1995.
"""

from dataclasses import replace

import numpy as np
from scipy.optimize import minimize

from ...diagnosis.numerics.judge import OF_SIGNATURE, Judge, JudgeJson, Weighed, none_of, signature_table
from ...diagnosis.numerics.recogniser import OF_ALL, OF_EXPLANATION, Recogniser
from ...diagnosis.numerics.recogniser import signs as signature_signs
from ...diagnosis.numerics.recogniser import written as recogniser_written
from ...ground.kinematics import Array
from .lesson import Lesson
from .recognise import taught

QUANTILES = (0.02, 0.35, 0.65, 0.98)  # of a sign over all explanations: knots of its ramps
PRIOR = 1.0  # one over the variance of a weight
PRIOR_ONWARDS = 10.0  # the same about the weight of an earlier judge


def explanations(lesson: Lesson, recogniser: Recogniser | None = None) -> list[Weighed]:
    """A lesson's explanations as a judge with this recogniser sees them."""
    alike = recogniser.likenesses(lesson.signature) if recogniser else {}
    return [
        Weighed(ids, {**signs, **signature_signs(alike, ids)})
        for ids, signs in zip(lesson.ids, lesson.signs, strict=True)
    ]


def blank(lessons: list[Lesson], before: Judge | None = None) -> Judge:
    """A judge that knows the signs and names of some lessons, and gives all explanations the same probability.

    After an earlier judge it keeps that one's knots and weights; what that one did not know weighs nothing yet.
    """
    every = [signs for lesson in lessons for signs in lesson.signs]
    knots = dict(before.knots) if before else {}
    for name in [name for name in every[0] if name not in (*OF_EXPLANATION, OF_ALL, *knots)]:
        knots_there = np.unique(np.round(np.quantile([signs[name] for signs in every], QUANTILES), 5))
        if len(knots_there) > 1:
            knots[name] = knots_there.tolist()
    names = sorted(
        {id_ for lesson in lessons for ids in lesson.ids for id_ in ids} | set(before.names if before else ())
    )
    weight_by_column = dict(zip(before.columns, before.weights.tolist(), strict=True)) if before else {}
    judge = Judge(knots, names, np.zeros(0), before.of_none if before else np.zeros(5))
    return replace(judge, weights=np.array([weight_by_column.get(column, 0.0) for column in judge.columns]))


def fitted(lessons: list[Lesson], before: Judge | None = None) -> Judge:
    """The judge whose softmax makes the right answers of some lessons likeliest.

    "None of them" is right where none is, and so is a set without physics of the library. Weights are held small, or
    near those of an earlier judge.
    """
    judge = blank(lessons, before)
    centre = np.concatenate([judge.weights, judge.of_none])
    prior = PRIOR_ONWARDS if before else PRIOR
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
        gradient, moved = np.concatenate([table.T @ slope, none.T @ none_slope]), weights - centre
        return float(-np.sum(np.log(good / whole)) + 0.5 * prior * moved @ moved), gradient + prior * moved

    solution = minimize(surprise, centre, jac=True, method="L-BFGS-B", options={"maxiter": 500}).x
    return Judge(judge.knots, judge.names, solution[:count], solution[count:])


def by_others(lessons: list[Lesson]) -> dict[str, Recogniser | None]:
    """For each author a recogniser taught by the others, as with recordings of a stranger; none without others."""
    authors = {lesson.author for lesson in lessons}
    return {
        author: taught([lesson for lesson in lessons if lesson.author != author]) if len(authors) > 1 else None
        for author in sorted(authors)
    }


def listening(judge: Judge, lessons: list[Lesson]) -> Judge:
    """The judge with a recogniser of all lessons' signatures, and weights of its signs; all other weights stay.

    Each lesson's signature is recognised by one whom its author did not teach: else the judge would trust it too much.
    """
    others = by_others(lessons)
    deaf = replace(judge, recogniser=None, of_signature=np.zeros(len(OF_SIGNATURE)))
    cases = []
    for lesson in lessons:
        if lesson.ids and others[lesson.author]:
            seen = explanations(lesson, others[lesson.author])
            right = np.append(np.array(lesson.answers, float), 0.0 if any(lesson.right) else 1.0)
            cases.append((np.log(deaf.probabilities(seen) + 1e-12), signature_table(seen), right))

    def surprise(weights: Array) -> tuple[float, Array]:
        whole, gradient = 0.5 * weights @ weights, weights.copy()
        for log_odds, table, right in cases:
            odds = np.exp(log_odds + table @ weights)
            shares, good = odds / odds.sum(), odds * right / (odds @ right)
            whole -= np.log(odds @ right / odds.sum())
            gradient += table.T @ (shares - good)
        return float(whole), gradient

    weights = minimize(surprise, np.zeros(len(OF_SIGNATURE)), jac=True, method="L-BFGS-B").x
    return replace(deaf, recogniser=taught(lessons), of_signature=weights)


def content(judge: Judge) -> JudgeJson:
    """A judge as the content of its file."""
    entries: JudgeJson = {
        "knots": judge.knots,
        "names": judge.names,
        "weights": [float(f"{value:.4g}") for value in judge.weights],
        "of_none": [float(f"{value:.4g}") for value in judge.of_none],
    }
    if judge.recogniser:
        entries["of_signature"] = [float(f"{value:.4g}") for value in judge.of_signature]
        entries["recogniser"] = recogniser_written(judge.recogniser)
    return entries
