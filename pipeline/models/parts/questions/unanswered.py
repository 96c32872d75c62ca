"""Why a question got no interval: which of its numbers is at fault, and its recorded range.

A question lies outside the box of the recordings, at a twist or in a stroke that was not recorded around its load, or
too many strokes ahead of the last recorded one of its string, or asks for a contraction that no recorded twist gives,
or its answer lies beyond all recorded contractions. One that lies between what was recorded, or in a recorded stroke
that errs more than others, is answered with a wider interval, and that is said too.
"""

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..box import MARGIN
from ..inside.assumed_stiffness import said_once
from ..inside.beyond_range import also, beyond, held, held_at
from ..inside.recorded_pairs import around
from ..inside.why import Kind, Why
from ..rolling_origin import too_far
from .prediction_intervals import Intervals
from .question_table import names_near
from .reached_contraction import reached_mm


def reasons(
    intervals: Intervals, points: pd.DataFrame, wanted: str, inside: NDArray[np.bool_], level: float
) -> list[Why]:
    """Why each question is not `inside`, or why its interval is wider than usual; else without a reason.

    `points` are the questions, of which `wanted` is asked, with intervals of the `level`; `inside` has the shape
    (points,), without unit.
    """
    whys, rows = [Why()] * len(points), np.flatnonzero(~inside)
    if len(rows):
        for row, sentence in zip(rows, _outside(intervals, points.iloc[rows], wanted, level), strict=True):
            whys[row] = Why().also(Kind.OUTSIDE, sentence)
    gaps_by_name = intervals.measure.gaps(points)
    for paired in intervals.pairs:
        gaps, rests_on = gaps_by_name[paired.name], intervals.between.said(paired)
        gaps = [also(gap, rests_on) if gap and within else gap for gap, within in zip(gaps, inside, strict=True)]
        whys = [why.also(Kind.BETWEEN, gap) for why, gap in zip(whys, gaps, strict=True)]
    for row, wider in zip(np.flatnonzero(inside), intervals.why_wider(points[inside], wanted, level), strict=True):
        whys[row] = whys[row].also(Kind.ERRS_MORE, wider)
    return whys


def _outside(intervals: Intervals, questions: pd.DataFrame, wanted: str, level: float) -> NDArray[np.object_]:
    """Why each of these questions has no interval; sentences of shape (questions,), without unit."""
    sentences = np.full(len(questions), "", object)
    forward = wanted == "displacement_mm"
    at_end = np.zeros(len(questions), bool)
    if forward:
        turns = questions["motor_turns"].to_numpy(float)
    else:
        turns, at_end = intervals.brought(questions, level)
    outside, last = intervals.outside(questions, wanted, turns), intervals.last_recorded(questions)
    apart = outside.pop("pairs", np.zeros(len(questions), bool))
    under = intervals.measure.under
    never = under.never(questions, turns) if under and "under" in outside else ()
    outside.pop("under", None)
    beyond_by = {name: [""] * len(questions) for name in outside}
    for name, mask in outside.items():
        for row, value, recorded in zip(np.flatnonzero(mask).tolist(), questions[name][mask], last[mask], strict=True):
            beyond_by[name][row] = _reason(intervals, name, value, float(recorded), intervals.ahead(wanted))
    for reasons_beyond in said_once(questions, beyond_by, intervals.measure.never_measured).values():
        sentences[:] = [also(*both) for both in zip(sentences, reasons_beyond, strict=True)]
    for row, reason in enumerate(never):
        sentences[row] = also(sentences[row], reason)
    if apart.any():
        apart_in_twist = apart if "motor_turns" not in outside else apart & ~outside["motor_turns"]
        for never_around in intervals.measure.never(questions, turns).values():
            for row, reason in enumerate(never_around):
                sentences[row] = also(sentences[row], reason if apart_in_twist[row] else "")
    for row in np.flatnonzero(at_end & (sentences != "")).tolist():
        sentences[row] = also(sentences[row], held_at(float(turns[row]), intervals.measure.whose))
    rows = np.flatnonzero(sentences == "")
    if wanted == "motor_turns" and len(rows):
        rest = questions.iloc[rows]
        twists, wrong = turns[rows], at_end[rows]
        least_mm, most_mm = reached_mm(intervals.model, rest, intervals.turns(rest))
        near = around(intervals.pairs, rest, twists)
        for place in np.flatnonzero(wrong):
            end, least, most = float(twists[place]), float(least_mm[place]), float(most_mm[place])
            conditions = [paired.name for paired in intervals.pairs]
            sentences[rows[place]] = held(end, least, most, conditions, near[place], intervals.measure.whose)
    if wanted == "displacement_mm" and len(rows):
        ends = intervals.box.low[wanted], intervals.box.high[wanted]
        for row, value in zip(rows.tolist(), intervals.model.forward(questions.iloc[rows]), strict=True):
            if not ends[0] <= value <= ends[1]:
                recorded = f"was recorded{intervals.measure.whose}"
                range_is = f"{recorded}, with {MARGIN[wanted]:.0%} to spare"
                reason = beyond(wanted, float(f"{value:.4g}"), *ends, range_is)
                sentences[row] = f"the answer is beyond all that {recorded}: {reason}"
    sentences[sentences == ""] = "how large an error is here could not be learnt"
    return sentences


def _reason(intervals: Intervals, name: str, value: object, last: float, ahead: int) -> str:
    """The fault of one number of a question."""
    measure = intervals.measure
    if name == "string":
        return f"string {value} has no recording here{names_near(str(value), list(intervals.strokes))}"
    if name == "material":
        return f"material {value} was not recorded; recorded: {', '.join(measure.box.materials)}"
    number = float(value)  # type: ignore[arg-type]
    if name == "stroke" and number > last:
        return too_far(number, last, ahead)
    if leaning := measure.leaning(name, number):
        return leaning
    box, whose = (measure.whole.box, "") if measure.whole else (measure.box, measure.whose)
    spare = f", with {MARGIN[name]:.0%} to spare" if name in MARGIN else ""
    return beyond(name, number, box.low[name], box.high[name], f"was recorded{whose}{spare}")
