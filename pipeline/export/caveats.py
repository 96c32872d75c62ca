"""Facts on an export that its numbers cannot tell: the zero, the strokes ahead, the fit.

The header's first comment and the graphs' metadata hold the same sentences.
"""

import math
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
from pydantic import JsonValue

from ..ground.words.counts import counted
from ..models.interface import about, settings_of
from ..models.parts.rolling_origin import RULE
from ..models.parts.settings import values
from .interface import Source
from .recorded_ranges import recorded, unread

AMOUNTS = ("epochs", "blocks", "width", "layers", "bins", "steps", "degree")  # less of these than usual: a small fit
SAME = "The quick job (ci.yaml) fits this model in full too: of what it exports only network models are smaller."
MOST_STRINGS = 3  # whose zero is named


def facts(source: Source) -> dict[str, str]:
    """Sentences by topic: `zero`, `strokes`, `fit`; if any `older`, `errors`, `trained`, `recorded`, `unread`."""
    always = {"zero": _zero(source), "strokes": _strokes(source), "fit": fit(source.name, source.model)}
    more = {"older": source.older, "errors": source.errors, "trained": source.trained}
    more |= {"recorded": recorded(source), "unread": unread(source)}
    return always | {name: text for name, text in more.items() if text}


def zeroed_runs(dataset: Path, string: str = "") -> tuple[str, ...]:
    """For each string of a dataset, the run whose first rest set its sensor's zero; none if there are too many strings.

    Of a `string` that is named its run alone. None as well where no such dataset is there.
    """
    columns = ["string", "run", "stroke"]
    try:
        table = pq.read_table(dataset, columns=columns, read_dictionary=columns[:2])  # these alone: it may be large
        points = table.to_pandas()[columns]
    except (OSError, pa.ArrowException, KeyError):
        return ()
    points = points[points["string"].astype(str) == string] if string else points
    first = points.sort_values("stroke", kind="stable").groupby("string", observed=True, sort=True)["run"].first()
    return tuple(f"{string} in run {run}" for string, run in first.items()) if len(first) <= MOST_STRINGS else ()


def _zero(source: Source) -> str:
    """The meaning of contraction 0, and for which runs."""
    inputs, baked = source.inputs, source.inputs.baked
    if inputs.pair:
        value = "0 mm at 0 turns"
    elif {"torsion_zone_mm", "separator_mm"} <= set(baked) and not about(source.name).each_string_apart:
        value = f"{math.hypot(baked['torsion_zone_mm'], baked['separator_mm']) - baked['torsion_zone_mm']:.3f} mm"
        value += " at 0 turns"
    else:
        value = "sqrt(d^2 + b^2) - d at 0 turns, d being torsion_zone_mm and b separator_mm as measured"
    jumped = f" In these recordings: {source.jumped}" if source.jumped else ""
    law = "the equation of a twisted pair" if inputs.pair else "eq. 4"
    runs = f" It was set so for string {', for string '.join(source.zeroed)}." if source.zeroed else ""
    return (
        f"On the rest before a new string's first stroke, displacement_mm is what {law} gives at that twist: {value}. "
        f"Set your sensor's zero so, once a string, and never in between: what later rests read is wear.{runs} "
        "A run that says `tare: run` was set anew: to where the string had rested before it and what it took back, or, "
        f"where the two rest under other loads or at other twists, to what {law} gives.{jumped}"
    )


def _strokes(source: Source) -> str:
    """How many strokes after the training strokes errors were measured."""
    trained = f"Strokes to {source.inputs.last_stroke} were trained on."
    trained += "" if "stroke" in source.deaf else " Beyond, the model's law of n goes on."
    if source.foreseen is None:
        return f"{trained} So many strokes ahead errors are measured, and pipeline.predict gives intervals: {RULE}."
    strokes, ahead = source.foreseen
    most = f"{RULE}, and the longest string of this dataset has {counted(strokes, 'stroke')}"
    reach = f"further than {ahead} stroke{'s' * (ahead > 1)} ahead" if ahead else "of strokes ahead"
    return f"{trained} Errors {reach} were never measured ({most}). Further on pipeline.predict gives no interval."


def fit(name: str, model: Any) -> str:
    """Whether a fitted model's settings are the usual ones, and if not, whether it is a small fit."""
    settings, same = settings_of(name), "" if about(name).needs_torch else f" {SAME}"
    if settings is None:
        return f"This model has no settings.{same}"
    mine, usual = values(model.settings), values(settings())
    apart = [setting for setting in usual if mine[setting] != usual[setting]]
    words = ", ".join(f"{setting} {mine[setting]} instead of {usual[setting]}" for setting in apart)
    if not apart:
        return f"Made with the usual settings of this model.{same}"
    small = any(setting in AMOUNTS and _less(mine[setting], usual[setting]) for setting in apart)
    return f"{'Small fit, not a result' if small else 'Settings of your own'}: {words}."


def _less(mine: JsonValue, usual: JsonValue) -> bool:
    """Whether a setting is smaller than usual."""
    return isinstance(mine, int | float) and isinstance(usual, int | float) and mine < usual
