"""The errors of a model on unseen points, in a sentence: those of its own split, and on whole later strokes.

The fit of the split `later` beside the model answers for strokes ahead: the same model, fitted without the last ones.
"""

from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from ..ground.command import program_name
from ..models.interface import Model, make_model
from ..models.parts.fitted_to import apart
from ..models.parts.questions.foreseen import MAPS
from ..models.parts.thinned import thinned

LEFT_OUT = {
    "within": "blocks inside strokes that the fit left out",
    "later": "whole last strokes that the fit left out",
}
ANEW = (
    f"{program_name('predict')} without --saved fits the model anew, to all points: its answers may differ from these "
    "by about as much as these errors, which can be more than its interval."
)
MOST_SPANS = 4  # spans of strokes that are told, each with its strings
UNKNOWN = (
    "How large the errors are was not measured: no dataset with points that the fit left out lies beside the model."
)


def errors_of(file: Path, name: str, model: Model, dataset: Path, string: str | None) -> str:
    """The errors of a file's model on the held-out points of its dataset, and those of its kind on later strokes.

    `string` is the one that alone is asked, None where all are. Raises nothing for what is not there: that is said.
    Empty where the dataset has other points than the model was fitted to.
    """
    split, _, seed = file.stem.partition("-")
    sentences, untold = [], list[str]()
    if apart(file, dataset):
        return ""
    whole = split == "all"  # nothing was left out: its like without them answer
    for of in ("within", "later") if whole else dict.fromkeys((split, "later")):
        like_file = file.with_name(f"{of}-{seed}.model")
        if of != split and (older := apart(like_file, dataset)):
            untold = [f"Errors on {LEFT_OUT[of]} are not told, for {older.sentence}"]
            break
        points = _held_out(dataset, of, string)
        try:
            like = model if of == split else make_model(name)
            if of != split:
                like.load(like_file)
            if len(points):
                sentences.append(_sentence(like, points, of, split))
        except Exception:  # whatever a file beside it that is no such model makes its loaders stumble over
            continue
    with_rest = [*sentences, *([] if whole else [ANEW])] if sentences else []
    return " ".join([*with_rest, *untold]) or UNKNOWN


def _sentence(model: Model, points: pd.DataFrame, of: str, own: str) -> str:
    """The errors of both maps on held-out points, with unit."""
    parts = []
    for wanted, map_ in MAPS.items():
        error = np.asarray(getattr(model, map_)(points.assign(**{wanted: np.nan})), float) - points[wanted].to_numpy()
        if not np.isfinite(error).all():
            raise ValueError("an answer is not a number")
        unit = "mm" if wanted == "displacement_mm" else "turns"
        parts.append(f"{map_} {np.sqrt(np.mean(error**2)):.2g} {unit} rms, at most {np.abs(error).max():.2g} {unit}")
    fitted = "" if of == own else ", by a fit of this model without them"
    return f"Errors on {LEFT_OUT[of]} ({_strokes(points)}){fitted}: {'; '.join(parts)}."


def _strokes(points: pd.DataFrame) -> str:
    """The strokes of held-out points; where strings differ in them those of each: strokes 14 to 18 of string a."""
    spans = points.groupby(points["string"].astype(str))["stroke"].agg(["min", "max"]).astype(int)
    strings_by_span = spans.groupby(["min", "max"]).groups
    if len(strings_by_span) > MOST_SPANS:
        return f"of {len(spans)} strings, of which each has its own"
    words = []
    for (first, last), strings in strings_by_span.items():
        span = f"stroke {first}" if first == last else f"strokes {first} to {last}"
        whose = f" of string{'s' * (len(strings) > 1)} {' and '.join(strings)}" if len(strings_by_span) > 1 else ""
        words.append(span + whose)
    return ", ".join(words)


def _held_out(dataset: Path, split: str, string: str | None) -> pd.DataFrame:
    """The points of a dataset that a split holds out; an empty table where there is no such dataset."""
    if split not in LEFT_OUT:
        return pd.DataFrame()
    try:
        points = pq.read_table(dataset, filters=[(split, "==", "test")]).to_pandas()
    except (OSError, pa.ArrowException, KeyError, ValueError):
        return pd.DataFrame()
    points = points if string is None else points[points["string"].astype(str) == string]
    return thinned(points)
