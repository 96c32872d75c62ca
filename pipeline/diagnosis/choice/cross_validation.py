"""Cross-validation of a tie: the smallest explanation that predicts left-out stretches about as well comes first.

Source: Stone, "Cross-validatory choice and assessment of statistical predictions", Journal of the Royal Statistical
Society B 36, 1974.
"""

import numpy as np

from ..fit.linear import Linear
from ..numerics.bounded import boxed
from ..numerics.recursions import whiten
from .search import Explanation

STRETCHES = 5  # of the recording, each left out once
FUTURE = 2  # stretches at its end, left out together: an explanation that would run away shows there
LEAST_SEEN = 1e-6  # of a column's square: with less in the fitted stretches its coefficient stays unknown
AS_WELL = 1.35  # times the best error: up to this a prediction counts as equally good


def left_out_errors(linear: Linear, sets: list[Explanation]) -> list[float]:
    """Error (rms) of each explanation on stretches left out of the fit of its coefficients; nonlinear ones are held."""
    wanted = np.unique(np.concatenate([explanation.fit.columns for explanation in sets])).astype(int)
    place = {int(column): number for number, column in enumerate(wanted)}
    table = np.ascontiguousarray(linear.table[[*wanted, -1]])
    first = linear.problem.drivers.first[: linear.rows]
    white = whiten(table, linear.noise.ar, first) / linear.noise.innovation
    prior = np.diag(linear.gram)[wanted] - np.einsum("ij,ij->i", white[:-1], white[:-1])  # exact: what was added
    whole = white @ white.T
    squares, count = np.zeros(len(sets)), 0
    stretches = np.array_split(np.arange(linear.rows), STRETCHES)
    for rows in [*stretches, np.concatenate(stretches[-FUTURE:])]:
        count += len(rows)
        part = white[:, rows]
        products = whole - part @ part.T
        for number, explanation in enumerate(sets):
            own = np.array([place[int(column)] for column in explanation.fit.columns])
            gram = products[np.ix_(own, own)] + np.diag(np.maximum(prior[own], 0.0))
            low, high = linear.low[explanation.fit.columns], linear.high[explanation.fit.columns]
            start = linear.begin[explanation.fit.columns]
            unseen = np.diag(gram) <= LEAST_SEEN * np.diag(whole)[own]  # its number stays 0
            gram[unseen], gram[:, unseen], low[unseen], high[unseen], start[unseen] = 0.0, 0.0, 0.0, 0.0, 0.0
            gram[unseen, unseen] = 1.0
            solution = boxed(np.ascontiguousarray(gram), products[own, -1].copy(), low, high, start)
            squares[number] += float(np.sum(np.square(table[-1, rows] - solution @ table[np.ix_(own, rows)])))
    return [float(np.sqrt(square / count)) for square in squares]


def by_prediction(linear: Linear, sets: list[Explanation]) -> list[Explanation]:
    """The sets: first the smallest that predicts about as well as the best, then the others as given."""
    if len(sets) < 2:
        return sets
    errors = left_out_errors(linear, sets)
    enough = [number for number, error in enumerate(errors) if error <= AS_WELL * min(errors)]
    first = min(enough, key=lambda number: (len(sets[number].ids), errors[number]))
    return [sets[first], *(explanation for number, explanation in enumerate(sets) if number != first)]
