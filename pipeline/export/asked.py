"""Questions answered by a saved model in Python, within the ranges of its export: the answers of header and graphs.

They check each number alone. A pair of numbers around which nothing was recorded they answer, and so they do a stroke
that is further ahead than errors were measured: both are flagged here.
"""

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..models.interface import about
from ..models.parts.box import MARGIN
from ..models.parts.inside.assumed_stiffness import said_once
from ..models.parts.inside.beyond_range import also, beyond, held, with_unit
from ..models.parts.inside.measure import Measure
from ..models.parts.inside.why import Kind, Why
from ..models.parts.questions.foreseen import MAPS
from ..models.parts.questions.question_table import string_meant
from ..models.parts.questions.reached_contraction import reached_mm, unreached
from ..models.parts.rolling_origin import too_far
from .inputs import ANSWER, SAME, WIDE, Field
from .interface import Source

NEAR = 1e-6  # of the range: a twist that was brought to its end
UNCHECKED = "the export answers, as it checks each number alone (in C tsa_recorded says of which pairs)"
NAMELESS = "the export answers, as it reads no name"
FURTHER = "the export answers, by the model's law of n (in C tsa_recorded says so)"


def answers(
    source: Source,
    points: pd.DataFrame,
    from_column: str,
    file: Path,
    measure: Measure,
    strokes: Mapping[str, int],
) -> pd.DataFrame:
    """The value of each question, in the answer's unit, whether it is `inside`, and `why` not, a `Why` each.

    Inside is what the export would answer and what was recorded: an export checks each number alone, the `measure`
    knows the recorded pairs and what the questions' string was recorded under, `strokes` the last one of each string,
    after which errors were measured so many strokes ahead.
    `points` have the dataset's columns, of which `from_column` is the twist or the contraction that is asked about.
    Raises BadInput for a column that the model reads and the dataset of the `file` lacks.
    """
    value = np.asarray(getattr(source.model, MAPS[ANSWER[from_column]])(points), float)
    why = np.full(len(points), "", object)
    refused_by = {}
    for field in source.inputs.columns(from_column):
        reasons = refused_by[field.name] = [""] * len(points)
        for row in np.flatnonzero(_outside(source, field, points, file)).tolist():
            reason = _reason(source, field, points[field.name].iloc[row])
            reasons[row] = f"{reason}; TSA_BAD_{field.name.upper()})"
    for sentences in said_once(points, refused_by, measure.never_measured).values():
        why[:] = [also(*both) for both in zip(why, sentences, strict=True)]
    for name, baked in _baked(source).items():
        other = np.abs(points[name].to_numpy(float) - baked) > (WIDE / 2.0 if name == "load_n" else SAME) * abs(baked)
        for row in np.flatnonzero(other).tolist():
            reason = f"{with_unit(name, float(points[name].iloc[row]))}: the export has {baked:.4g} baked in"
            why[row] = also(why[row], reason)
    pairs, under = measure.pairs, measure.under
    if from_column == "displacement_mm":
        ends = source.inputs.motor_turns
        rows = np.flatnonzero(_held(source, points, value) & (why == ""))
        value[rows] = np.clip(value[rows], *ends)
        reached = reached_mm(source.model, points.iloc[rows], ends) if len(rows) else ((), ())
        for row, least_mm, most_mm in zip(rows, *reached, strict=True):
            conditions = [paired.name for paired in pairs]
            why[row] = f"{held(value[row], float(least_mm), float(most_mm), conditions)} (TSA_HELD)"
    turns = points["motor_turns"].to_numpy(float) if from_column == "motor_turns" else value
    refused = why != ""
    for row, string in enumerate(points["string"].astype(str)):
        if string not in strokes:
            new = f"string {string} is none that it was fitted to{string_meant(string, list(strokes))}"
            why[row] = why[row] or f"{new}; {NAMELESS}"
    for sentences in measure.never(points, turns).values():
        for row, reason in enumerate(sentences):
            why[row] = why[row] or (f"{reason}; {UNCHECKED}" if reason else "")
    for row, reason in enumerate(under.never(points, turns) if under else ()):
        why[row] = also(why[row], f"{reason}; {UNCHECKED}") if reason and not refused[row] else why[row]
    for name in measure.ends:
        numbers = turns if name == "motor_turns" else points[name].to_numpy(float)
        for row in np.flatnonzero(~refused & ((name, from_column) != ("displacement_mm", "motor_turns"))).tolist():
            reason = measure.leaning(name, float(numbers[row]))
            why[row] = also(why[row], f"{reason}; {NAMELESS}" if reason else "")
    for row, reason in _too_far(source, points, strokes):
        why[row] = why[row] if refused[row] else also(why[row], f"{reason}; {FURTHER}")
    whys = [Why().also(Kind.OUTSIDE, sentence) for sentence in why]
    for sentences in measure.gaps(points).values():
        whys = [each.also(Kind.BETWEEN, gap) for each, gap in zip(whys, sentences, strict=True)]
    return pd.DataFrame({ANSWER[from_column]: value, "inside": why == "", "why": whys})


def _too_far(source: Source, points: pd.DataFrame, strokes: Mapping[str, int]) -> Iterator[tuple[int, str]]:
    """Places and reasons of the questions further ahead than errors were measured."""
    if source.foreseen is None:
        return
    trained, ahead = source.inputs.last_stroke, source.foreseen[1]
    for row, (string, stroke) in enumerate(zip(points["string"].astype(str), points["stroke"], strict=True)):
        last = min(strokes.get(string, trained), trained)
        if stroke > last + ahead:
            yield row, too_far(stroke, last, ahead, "the last that the model was fitted to")


def _reason(source: Source, field: Field, value: object) -> str:
    """What is wrong with one number of a question, and what the limit is; a bracket is left open."""
    if field.name == "material":
        return f"material {value} is none that the export takes ({', '.join(source.inputs.materials)}"
    number = float(value)  # type: ignore[arg-type]
    return f"{beyond(field.name, number, field.low, field.high, 'the export takes')} ({_limit(field, number)}"


def _limit(field: Field, number: float) -> str:
    """The origin of a range's end that a number exceeds: not always all recorded points, as for a new fit."""
    if field.name == "stroke":
        return f"{'twice the last' if number > field.high else 'the first'} stroke that it was fitted to"
    spare = f", with {MARGIN[field.name]:.0%} to spare" if field.name in MARGIN else ""
    return f"of the points that it was fitted to{spare}"


def _baked(source: Source) -> dict[str, float]:
    """Values that are fixed in the export but may be given otherwise; a calibrated string has its own dimensions."""
    apart = about(source.name).each_string_apart
    kept = {name: value for name, value in source.inputs.baked.items() if name not in source.inputs.unread}
    return {name: value for name, value in kept.items() if name == "load_n" or not apart}


def _outside(source: Source, field: Field, points: pd.DataFrame, file: Path) -> NDArray[np.bool_]:
    """Which questions lie outside the range of one input of the export; shape (points,)."""
    if field.name == "material":
        return ~points["material"].isin(source.inputs.materials).to_numpy(bool)
    if field.name not in points:
        raise BadInput(file, field.name, "is read by the model, and the dataset lacks it", "say the right dataset")
    return ~points[field.name].between(field.low, field.high).to_numpy(bool)


def _held(source: Source, points: pd.DataFrame, turns: Array) -> NDArray[np.bool_]:
    """Which twists are held at an end of the range, since none inside gives the contraction; shape (points,)."""
    low, high = source.inputs.motor_turns
    at_end = (turns <= low + NEAR * (high - low)) | (turns >= high - NEAR * (high - low))
    return (turns < low) | (turns > high) | (at_end & unreached(source.model, points, (low, high)))
