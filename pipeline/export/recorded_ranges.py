"""The recorded values of each condition, for the user of an export: its ranges are wider, and are checked one by one.

The header's first comment and the graphs' metadata hold the same sentences.
"""

from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from ..ground.kinematics import Array
from ..ground.units import unit_of
from ..models.parts.box import MARGIN, ROUNDED, SIZES, room
from ..models.parts.conditions import MEASURED
from ..models.parts.inside.recorded_pairs import Paired, pairs_of
from ..models.parts.inside.recorded_strokes import LOAD
from ..models.parts.rolling_origin import most_ahead
from .interface import Source

WHO_SAYS = "pipeline.predict"
WOUND = 0.5  # of the largest twist under a load: a stroke that was wound less far there is said apart
FEW = 4  # values of a condition that are named each
ALONE = (
    "Each number is checked alone: also a twist or a stroke that was never recorded around that value is answered "
    f"({WHO_SAYS} says of which)."
)


def twists_recorded(dataset: Path, last_stroke: int, string: str = "") -> pd.DataFrame:
    """String, twist and the measured columns of a dataset's points up to a stroke; empty where no dataset is there."""
    return points_to(dataset, last_stroke, ["string", "motor_turns", *MEASURED], string)


def values_recorded(points: pd.DataFrame) -> dict[str, str]:
    """For each measured column of `twists_recorded` that varies, its values with their twists, in words."""
    words = {}
    for name in MEASURED if len(points) else ():
        values = points[name].to_numpy(float)
        if np.isfinite(values).all() and values.max() > values.min():
            words[name] = _in_words(values, points, name)
    return words


def pairs_recorded(points: pd.DataFrame) -> tuple[Paired, ...] | None:
    """The recorded twists around each condition, from `twists_recorded`; None without a dataset."""
    return pairs_of(points) if len(points) else None


def strokes_foreseen(dataset: Path, string: str = "") -> tuple[int, int] | None:
    """The strokes of a dataset's longest string, and for how many ahead errors are measured; None where unknown.

    Of a `string` that is named it is that one's strokes.
    """
    points = _columns(dataset, ["string", "stroke"], string)
    if not len(points):
        return None
    strokes = int(points.groupby("string")["stroke"].nunique().max())
    return strokes, most_ahead(strokes)


def recorded(source: Source) -> str:
    """A sentence for each condition that the export takes or does not read: its recorded values."""
    ranges = {field.name: (field.low, field.high) for field in source.inputs.fields if field.name in MEASURED}
    origin = dict.fromkeys(source.inputs.assumed, "assumed")
    values = {name: source.values.get(name) or _unwidened(name, *ends) for name, ends in ranges.items()}
    sentences = [f"{name}: {origin.get(name, 'recorded')} were {words}{_room(name)}." for name, words in values.items()]
    return " ".join([*sentences, ALONE]) if sentences else ""


def unread(source: Source) -> str:
    """Conditions that varied in training and that the model does not read, with their recorded values; else empty."""
    varied = source.inputs.unread.items()
    words = [f"{name}, {source.values.get(name) or _unwidened(name, *ends)}" for name, ends in varied]
    sentences = [f"Varied in training, and this model does not read it: {'; '.join(words)}."] if words else []
    if "direction" in source.deaf:
        sentences.append(
            "This model does not read direction: winding and unwinding get one answer, though they differ."
        )
    if "stroke" in source.deaf:
        sentences.append("This model does not read stroke: every stroke gets one answer.")
    return " ".join(sentences)


def points_to(dataset: Path, last_stroke: int, names: list[str], string: str = "") -> pd.DataFrame:
    """The stroke and other columns, `string` among them, of a dataset's points up to a stroke; of one string if named.

    Empty where there is no such dataset.
    """
    points = _columns(dataset, ["stroke", *names], string)
    return points[points["stroke"] <= last_stroke] if len(points) else points


def _columns(dataset: Path, names: list[str], string: str = "") -> pd.DataFrame:
    """Columns of a dataset, which may be large, of one string if named; empty where there is no such dataset."""
    try:
        points = pq.read_table(dataset, columns=names).to_pandas()[names]
    except (OSError, pa.ArrowException, KeyError):
        return pd.DataFrame(columns=names)
    return points[points["string"].astype(str) == string] if string else points


def _in_words(values: Array, points: pd.DataFrame, name: str) -> str:
    """Values that lie together, and the twists recorded with them; all in one where they are too many.

    Of loads also the strokes.
    """
    order, unit = np.argsort(values, kind="stable"), f" {unit_of(name)}"
    values, turns, strokes = values[order], *(points[of].to_numpy(float)[order] for of in ("motor_turns", "stroke"))
    wide = room(name, float(values[0]), float(values[-1]))
    groups = np.split(np.arange(len(values)), np.flatnonzero(np.diff(values) > wide) + 1)
    if len(groups) > FEW:
        return f"{values[0]:.4g} to {values[-1]:.4g}{unit}"
    each = []
    for group in groups:
        with_them = f"twists {turns[group].min():.4g} to {turns[group].max():.4g} turns"
        if name == LOAD:
            with_them += f", {_strokes_in_words(strokes[group], turns[group])}"
        each.append(f"{_span(values[group])}{unit} ({with_them})")
    return " and ".join(each)


def _strokes_in_words(strokes: Array, turns: Array) -> str:
    """The strokes under a load, and apart from them those that were hardly wound there; both of shape (points,)."""
    farthest = pd.Series(turns).groupby(strokes).max()
    is_wound = farthest >= WOUND * turns.max()
    words = f"stroke{_numbers(farthest.index[is_wound])}"
    rest = farthest[~is_wound]
    return f"{words}, and stroke{_numbers(rest.index)} only to {rest.max():.3g} turns" if len(rest) else words


def _numbers(strokes: Iterable[float]) -> str:
    """Numbers of strokes from the first to the last, after the word `stroke`."""
    each = list(strokes)
    return f" {each[0]:.0f}" if len(each) == 1 else f"s {each[0]:.0f} to {each[-1]:.0f}"


def _span(values: Array) -> str:
    """From where to where values reach."""
    low, high = (f"{end:.4g}" for end in (values[0], values[-1]))
    return low if low == high else f"{low} to {high}"


def _unwidened(name: str, low: float, high: float) -> str:
    """The recorded range of a column by the range of the box, which has room on either side."""
    wide = MARGIN.get(name, 0.0) * (high - low) / (1.0 + 2.0 * MARGIN.get(name, 0.0))
    if name in SIZES and high > low:
        wide = ROUNDED * high / (1.0 + ROUNDED)
    return f"{low + wide:.4g} to {high - wide:.4g} {unit_of(name)}"


def _room(name: str) -> str:
    """How much wider than recorded a column's range is."""
    return f"; its range here is {MARGIN[name]:.0%} wider at either end" if name in MARGIN else ""
