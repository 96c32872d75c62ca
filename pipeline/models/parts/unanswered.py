"""Why a question got no interval: which number it gives, and what was recorded of that.

A question lies outside the box of the recordings, or too many strokes ahead of the last recorded one of its string.
"""

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ...ground.units import unit_of
from .box import Box
from .prediction_intervals import Intervals

SHOWN = 5  # questions of which the reason is printed; the file flags all


def reasons(intervals: Intervals, points: pd.DataFrame, wanted: str, inside: NDArray[np.bool_]) -> list[str]:
    """Of the first questions that are not `inside`, a sentence each that says why, numbered by their row.

    `points` are the questions, of which `wanted` is asked; `inside` has the shape (points,), without unit.
    """
    rows = first_rows(inside)
    questions = points.iloc[rows]
    outside, last = intervals.outside(questions, wanted), intervals.last_recorded(questions)
    box, ahead = intervals.box, intervals.ahead(wanted)
    sentences = []
    for place, row in enumerate(rows):
        columns = [name for name, mask in outside.items() if mask[place]]
        why = [_reason(name, questions.iloc[place], box, float(last.iloc[place]), ahead) for name in columns]
        sentences.append(f"row {row + 1}: {'; '.join(why) or 'how large an error is here could not be learnt'}")
    return sentences


def first_rows(inside: NDArray[np.bool_]) -> list[int]:
    """Rows of the first questions that are not `inside`, which has the shape (points,), without unit."""
    return [int(row) for row in np.flatnonzero(~inside)[:SHOWN]]


def ranged(low: float, high: float, unit: str) -> str:
    """A range in words; both ends in the unit, which is 1 for a number without."""
    return f"{low:.4g} to {high:.4g}{'' if unit == '1' else f' {unit}'}"


def _reason(name: str, question: pd.Series, box: Box, last: float, ahead: int) -> str:
    """What is wrong with one number of a question."""
    if name == "string":
        return f"string {question[name]} has no recording here"
    if name == "reach":
        return f"no twist that was recorded gives {question['displacement_mm']:g} mm in this state"
    if name == "material":
        return f"material {question[name]}: recorded are {', '.join(box.materials)}"
    if name == "stroke":
        far = f"{last:.0f} strokes were recorded, and {ahead} further ones have intervals"
        return f"stroke {question[name]:.0f}: {far}"
    return f"{name} {question[name]:g}: recorded are {ranged(box.low[name], box.high[name], unit_of(name))}"
