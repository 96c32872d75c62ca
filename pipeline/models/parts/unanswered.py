"""Why a question got no interval: which number it gives, and what was recorded of that.

A question lies outside the box of the recordings, or too many strokes ahead of the last recorded one of its string, or
asks for a contraction that no recorded twist gives.
"""

from collections.abc import Sequence

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from .beyond import also, beyond, held
from .prediction_intervals import Intervals
from .reach import reached_mm

SHOWN = 5  # questions of which the reason is printed; the file has all


def reasons(intervals: Intervals, points: pd.DataFrame, wanted: str, inside: NDArray[np.bool_]) -> list[str]:
    """Why each question is not `inside`, a sentence each; empty for one that is.

    `points` are the questions, of which `wanted` is asked; `inside` has the shape (points,), without unit.
    """
    sentences = np.full(len(points), "", object)
    rows = np.flatnonzero(~inside)
    if not len(rows):
        return list(sentences)
    questions = points.iloc[rows]
    outside, last = intervals.outside(questions, wanted), intervals.last_recorded(questions)
    reach = outside.pop("reach", np.zeros(len(rows), bool))
    for name, mask in outside.items():
        of_name = questions[name][mask]
        for row, value, recorded in zip(rows[mask], of_name, last[mask], strict=True):
            reason = _reason(intervals, name, value, float(recorded), intervals.ahead(wanted))
            sentences[row] = also(sentences[row], reason)
    at_end = reach & (sentences[rows] == "")
    if at_end.any():
        turns = intervals.turns
        answer = np.clip(intervals.model.inverse(questions[at_end]), *turns)
        numbers = zip(rows[at_end], answer, *reached_mm(intervals.model, questions[at_end], turns), strict=True)
        for row, end, least_mm, most_mm in numbers:
            sentences[row] = held(float(end), float(least_mm), float(most_mm))
    sentences[rows[sentences[rows] == ""]] = "how large an error is here could not be learnt"
    return list(sentences)


def first_of(sentences: Sequence[str]) -> list[str]:
    """The first sentences that say something, each with the number of its row."""
    numbered = [f"row {number}: {sentence}" for number, sentence in enumerate(sentences, start=1) if sentence]
    left = len(numbered) - SHOWN
    return numbered[:SHOWN] + ([f"and {left} more, each with its reason in the column `why`"] if left > 0 else [])


def _reason(intervals: Intervals, name: str, value: object, last: float, ahead: int) -> str:
    """What is wrong with one number of a question."""
    box = intervals.box
    if name == "string":
        return f"string {value} has no recording here"
    if name == "material":
        return f"material {value} was not recorded; recorded: {', '.join(box.materials)}"
    number = float(value)  # type: ignore[arg-type]
    if name == "stroke" and number > last:
        return f"stroke {number:.0f} is {number - last:.0f} after {last:.0f}, the last recorded; {_measured(ahead)}"
    return beyond(name, number, box.low[name], box.high[name], "was recorded")


def _measured(ahead: int) -> str:
    """How many strokes after the last recorded one an error could be measured."""
    if not ahead:
        return "errors were measured in recorded strokes only"
    return f"errors were measured up to {ahead} stroke{'s' * (ahead > 1)} ahead"
