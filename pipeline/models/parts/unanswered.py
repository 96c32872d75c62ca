"""Why a question got no interval: which number it gives, and what was recorded of that.

A question lies outside the box of the recordings, or too many strokes ahead of the last recorded one of its string.
"""

import pandas as pd

from ...ground.units import unit_of
from .box import Box
from .prediction_intervals import Intervals

SHOWN = 5  # questions of which the reason is printed; the file flags all


def reasons(intervals: Intervals, points: pd.DataFrame, wanted: str) -> list[str]:
    """Of the first questions that have no interval, a sentence each that says why, numbered by their row.

    `points` are the questions, of which `wanted` is asked.
    """
    outside, last = intervals.outside(points, wanted), intervals.last_recorded(points)
    box, ahead = intervals.box, intervals.ahead(wanted)
    sentences: list[str] = []
    for place in range(len(points)):
        columns = [name for name, mask in outside.items() if mask[place]]
        if columns and len(sentences) < SHOWN:
            why = "; ".join(_reason(name, points.iloc[place], box, float(last.iloc[place]), ahead) for name in columns)
            sentences.append(f"row {place + 1}: {why}")
    return sentences


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
    unit = unit_of(name)
    recorded = f"{box.low[name]:.4g} to {box.high[name]:.4g}{'' if unit == '1' else f' {unit}'}"
    return f"{name} {question[name]:g}: recorded are {recorded}"
