"""The bar on the limit's line of a panel: from which stroke to which it is passed, in words where no curve runs."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..ground.kinematics import Array
from .forecast.life_questions import Answer
from .words.percent import percent
from .words.stroke_counts import at_least, strokes_at_least, strokes_at_most

ROOM = 0.05  # of the strokes shown, beyond the last one: a bar without an end has its arrow there
TIP = 0.03  # of the strokes shown, from the last one to the arrow's tip
LETTER, TALL, GAP = 0.0088, 0.18, 0.03  # of a panel's width and height: a letter, two lines, and what parts them
PLACES = 80  # of the words along the strokes that are tried
Curve = tuple[Array, Array]  # strokes, and values in the panel's unit; each of shape (points,)


def interval(axes: Axes, answer: Answer, level: float, end: float, height: float, curves: Sequence[Curve]) -> None:
    """The interval of the stroke that passes the limit, on the limit's line; an arrow where it has no end.

    `height` is the limit in the panel's unit, `end` the last stroke shown. Words lie beside it, off the `curves`.
    """
    left_span, seen = answer.left.span(level), float(answer.n[-1])
    low, high, wide = seen + left_span.low, seen + left_span.high, end - float(answer.n[0])
    tip = high if high <= end else end + TIP * wide
    bar: dict[str, Any] = {"color": "k", "lw": 2.2, "solid_capstyle": "butt", "zorder": 4}
    axes.plot([low, tip], [height, height], **bar)
    axes.plot([low], [height], marker="|", ms=11, mew=2.0, color="k", zorder=4)
    axes.plot(
        [tip], [height], marker="|" if high <= end else ">", ms=11 if high <= end else 6, mew=2.0, color="k", zorder=4
    )
    count = f"{at_least(left_span.low)} to {strokes_at_most(left_span.high)}" if left_span.state == "interval" else (
        f"{'more than' if left_span.state == 'censored' else 'at least'} {strokes_at_least(left_span.low)}"
    )  # fmt: skip
    words = f"{count} left\nin {percent(level)} of the futures"
    place = words_place(words, axes, (seen, end), (low, height), curves)
    axes.annotate(
        words, place, xytext=(2, 0), textcoords="offset points", fontsize=8, va="bottom",
        bbox={"facecolor": "w", "edgecolor": "none", "alpha": 0.7, "pad": 0.8},
    )  # fmt: skip


def words_place(
    words: str, axes: Axes, ends: tuple[float, float], bar: tuple[float, float], curves: Sequence[Curve]
) -> tuple[float, float]:
    """The lower left corner for words of two lines, close above or below the beginning of a bar, off the curves.

    `ends` are the first and the last stroke between which they may lie, `bar` the stroke and the height where it
    begins. Where no place is free it is the one that covers the least of a curve.
    """
    lower, upper = axes.get_ylim()
    tall, gap = TALL * (upper - lower), GAP * (upper - lower)
    wide = LETTER * max(map(len, words.split("\n"))) * (ends[1] * (1.0 + ROOM) - axes.dataLim.x0)
    begins = np.linspace(ends[0], max(ends[1] - wide, ends[0]), PLACES)
    feet = (bar[1] + gap, bar[1] - gap - tall)
    places = [(from_n, foot) for foot in feet for from_n in begins.tolist()]
    tried = []
    for at, (from_n, foot) in enumerate(places):
        until_n = from_n + wide
        covered = _covered(curves, (from_n, until_n), (foot, foot + tall))
        tried.append((covered, max(from_n - bar[0], bar[0] - until_n, 0.0), at))
    return places[min(tried)[-1]]


def _covered(curves: Sequence[Curve], strokes: tuple[float, float], heights: tuple[float, float]) -> int:
    """How many points of the curves lie in a rectangle, both ends of which are given in strokes and in height."""
    count = 0
    for n, values in curves:
        at = np.linspace(max(strokes[0], float(n[0])), min(strokes[1], float(n[-1])), PLACES)
        if at[-1] <= at[0]:
            continue
        height = np.interp(at, n, values)
        high, low = np.maximum(height[1:], height[:-1]), np.minimum(height[1:], height[:-1])
        count += int(((high >= heights[0]) & (low <= heights[1])).sum())
    return count
