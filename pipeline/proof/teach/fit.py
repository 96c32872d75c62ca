"""Lessons → a judge: the weights under which what was hidden is likeliest, held small by a normal prior."""

from dataclasses import replace

import numpy as np
from scipy.optimize import minimize

from ...diagnosis.numerics.judge import SIZES, Judge, Weighed, none_of
from ...diagnosis.numerics.recogniser import Recogniser
from ...diagnosis.numerics.recogniser import signs as signature_signs
from ...diagnosis.numerics.recogniser import written as recogniser_written
from ...ground.kinematics import Array
from .lesson import Lesson
from .recognise import taught

QUANTILES = (0.02, 0.35, 0.65, 0.98)  # of a sign over all explanations: knots of its ramps
PRIOR = 1.0  # one over the variance of a weight
STAYS = 10.0  # the same of how far a weight may go from that of a judge before
NONE = len(none_of([Weighed((), {"left_share": 0.0, "mismatch_floors": 0.0})]))  # weights of "none of them"


def explanations(lesson: Lesson, recogniser: Recogniser | None) -> list[Weighed]:
    """A lesson's explanations as a judge with this recogniser sees them."""
    alike = recogniser.likenesses(lesson.signature) if recogniser else {}
    return [
        Weighed(ids, {**signs, **signature_signs(alike, ids)})
        for ids, signs in zip(lesson.ids, lesson.signs, strict=True)
    ]


def by_others(lessons: list[Lesson]) -> dict[str, Recogniser | None]:
    """For each author a recogniser that the others taught, as a stranger's recordings meet one; none without others."""
    authors = {lesson.author for lesson in lessons}
    return {
        author: taught([lesson for lesson in lessons if lesson.author != author]) if len(authors) > 1 else None
        for author in sorted(authors)
    }


def blank(cases: list[list[Weighed]], recogniser: Recogniser | None) -> Judge:
    """A judge that knows the signs and names of the explanations of some cases, and holds all alike."""
    every = [candidate.signs for case_explanations in cases for candidate in case_explanations]
    knots = {}
    for name in every[0]:
        knots_there = np.unique(np.round(np.quantile([signs[name] for signs in every], QUANTILES), 5))
        if len(knots_there) > 1:
            knots[name] = knots_there.tolist()
    names = sorted({id_ for case_explanations in cases for candidate in case_explanations for id_ in candidate.ids})
    without = Judge(knots, names, np.zeros(0), np.zeros(0), recogniser)
    return replace(
        without, weights=np.zeros(without.basis(cases[0]).shape[1]), of_none=np.zeros(len(none_of(cases[0])))
    )


def onwards(before: Judge, recogniser: Recogniser | None) -> Judge:
    """A judge that knows what one before it knew, and asks another recogniser."""
    straight = replace(before, recogniser=recogniser).straight
    more = 0 if before.straight else len(straight)
    names, sizes = len(before.names), 1 + len(SIZES)
    blocks = before.weights.reshape(sizes, -1)
    widened = np.hstack([blocks[:, : blocks.shape[1] - names], np.zeros((sizes, more)), blocks[:, -names:]])
    of_none = np.append(before.of_none, np.zeros(NONE - len(before.of_none)))
    return replace(before, weights=widened.ravel(), of_none=of_none, recogniser=recogniser)


def fitted(all_lessons: list[Lesson], before: Judge | None = None) -> Judge:
    """The judge whose softmax makes the right answers of some lessons likeliest, with the recogniser of all of them.

    "None of them" is right where none is, and so is a set without physics of the library. Each lesson's signature is
    recognised by one whom its author did not teach: else the judge would trust the recogniser too much. The weights are
    held near those of a judge `before` it, if there is one, and near 0 otherwise.
    """
    lessons, others = [lesson for lesson in all_lessons if lesson.ids], by_others(all_lessons)
    seen = [explanations(lesson, others[lesson.author]) for lesson in lessons]
    recogniser = taught(all_lessons)
    judge, prior = (onwards(before, recogniser), STAYS) if before else (blank(seen, recogniser), PRIOR)
    table = np.vstack([judge.basis(case_explanations) for case_explanations in seen])
    none = np.array([none_of(case_explanations) for case_explanations in seen])
    starts = np.cumsum([0, *map(len, seen)])[:-1]
    case = np.repeat(np.arange(len(seen)), [len(case_explanations) for case_explanations in seen])
    right = np.concatenate([np.array(lesson.answers, float) for lesson in lessons])
    named = np.array([any(lesson.right) for lesson in lessons])
    count = table.shape[1]

    first = np.concatenate([judge.weights, judge.of_none])

    def surprise(weights: Array) -> tuple[float, Array]:
        scores, of_none = table @ weights[:count], none @ weights[count:]
        top = np.maximum(np.maximum.reduceat(scores, starts), of_none)
        odds, none_odds = np.exp(scores - top[case]), np.exp(of_none - top)
        whole = np.add.reduceat(odds, starts) + none_odds
        good = np.add.reduceat(odds * right, starts) + np.where(named, 0.0, none_odds)
        slope = odds / whole[case] - right * odds / good[case]
        none_slope = none_odds / whole - np.where(named, 0.0, none_odds / good)
        gradient = np.concatenate([table.T @ slope, none.T @ none_slope])
        moved = weights - first
        return float(-np.sum(np.log(good / whole)) + 0.5 * prior * moved @ moved), gradient + prior * moved

    solution = minimize(surprise, first, jac=True, method="L-BFGS-B", options={"maxiter": 500}).x
    return replace(judge, weights=solution[:count], of_none=solution[count:])


def content(judge: Judge) -> dict[str, object]:
    """A judge as the content of its file."""
    return {
        "knots": judge.knots,
        "names": judge.names,
        "weights": [float(f"{value:.4g}") for value in judge.weights],
        "of_none": [float(f"{value:.4g}") for value in judge.of_none],
        **({"recogniser": recogniser_written(judge.recogniser)} if judge.recogniser else {}),
    }
