"""A recorded state to begin with: a stroke with the load, and the other conditions, of its recording.

The middles of the ranges are no such state: of stroke 1 under 20 N and stroke 5 under 30 N nothing lies at 25 N.
"""

from pathlib import Path

import pandas as pd

from ..models.parts.conditions import MEASURED
from ..models.parts.inside.recorded_strokes import LOAD
from .c_text import function, real
from .inputs import Field, Inputs
from .interface import Source
from .recorded_ranges import points_to

USAGE = "tsa_start() gives a state to begin with: {}."


def start_values(dataset: Path, inputs: Inputs, string: str = "") -> dict[str, float]:
    """Of a dataset's first stroke, of one string if named, the median of each field, in its unit.

    Empty where no such dataset is there.
    """
    conditions = [name for name in inputs.names if name in MEASURED]
    points = points_to(dataset, inputs.last_stroke, ["string", *conditions], string)
    points = points[points["stroke"] >= inputs.fields[0].low] if len(points) else points
    if not len(points):
        return {}
    first = points.sort_values(["stroke", "string"], kind="stable").iloc[0]
    stroke = points[(points["stroke"] == first["stroke"]) & (points["string"] == first["string"])]
    values = {"stroke": float(first["stroke"])} | {name: float(stroke[name].median()) for name in conditions}
    return {name: value for name, value in values.items() if not pd.isna(value)}


def usage(source: Source) -> str:
    """A line of the first comment: what the state to begin with is."""
    if not source.start:
        return USAGE.format("the first stroke, and the middle of each other range")
    return USAGE.format(f"stroke {source.start['stroke']:.0f} as it was recorded")


def start_state(source: Source) -> str:
    """The function `tsa_start` in C, and what was recorded of each condition as a text."""
    lines = [f"state.{field.name} = {_value(field, source.start)};" for field in source.inputs.fields]
    differed = sorted(set(source.values) & set(source.inputs.names), key=lambda name: (name != LOAD, name))
    assumed = source.inputs.assumed
    text = "; ".join(f"{name}{' (assumed)' * (name in assumed)} {source.values[name]}" for name in differed)
    defined = f'#define TSA_RECORDED "{text}" /* of each field that differed */\n\n' if text else ""
    return defined + function("tsa_state", "tsa_start(void)", "tsa_state state;", *lines, "return state;")


def _value(field: Field, start: dict[str, float]) -> str:
    """A field's number in C: the recorded one if in its range; else the first stroke, winding, or the middle."""
    if field.name == "direction":
        return "TSA_DIRECTION_MAX"
    if field.name not in start:
        name = field.name.upper()
        return f"TSA_{name}_MIN" if field.whole else f"(TSA_{name}_MIN + TSA_{name}_MAX) / 2"
    value = min(max(start[field.name], field.low), field.high)
    return str(round(value)) if field.whole else real(value)
