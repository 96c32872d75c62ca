"""The errors of models in a models.csv, and the model to take by them.

Errors are RMSEs on all points of a split, `within` or `later`, by model and split: forward ones in mm.
"""

import csv
from collections.abc import Iterable, Mapping
from pathlib import Path

from .model_names import FLOORS, USUAL

LESS = 1.1  # times as large: from there on an error is told to be larger
APART = "other_conditions"  # the column of errors on strokes under a load or a twist that few learnt strokes have
NEEDS_MOTION = "needs_motion"  # the column that marks models which answer along a whole motion alone
Errors = Mapping[tuple[str, str], float]


def errors_in(path: Path, way: str = "forward") -> dict[tuple[str, str], float]:
    """Errors by which models of a models.csv are compared, forward in mm, inverse in turns; none without the file.

    Errors on strokes under other conditions than most learnt ones are not among them: they are no errors of age alone.
    Nor are those of models that need a whole motion: none can be taken. A file of an earlier version marks none.
    """
    rows = [row for row in _rows(path) if row["column"] == "all" and row["map"] == way]
    rows = [row for row in rows if not (is_apart(row) or needs_motion(row))]
    return {(row["model"], row["split"]): float(row["median"]) for row in rows if row["model"] not in FLOORS}


def is_apart(row: Mapping[str, str | float]) -> bool:
    """Whether a row of a models.csv is on strokes under other conditions than most learnt ones."""
    return str(row.get(APART)) == "True"


def needs_motion(row: Mapping[str, str | float]) -> bool:
    """Whether a row of a models.csv is of a model that answers along a whole motion alone."""
    return str(row.get(NEEDS_MOTION)) == "True"


def has_apart(path: Path) -> bool:
    """Whether a models.csv has errors on strokes under other conditions than most learnt ones."""
    return any(map(is_apart, _rows(path)))


def _rows(path: Path) -> list[dict[str, str]]:
    if not path.is_file():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def floor_in(path: Path) -> float:
    """The noise of held-out points in mm, the least floor in a models.csv; 0 where it is not known."""
    return floor_of(_rows(path))


def floor_of(rows: Iterable[Mapping[str, str | float]]) -> float:
    """The noise of held-out points in mm, the least floor in the rows of a models.csv; 0 where none is there."""
    held_out = [row for row in rows if (row["column"], row["split"], row["map"]) == ("all", "within", "forward")]
    return min((float(row["median"]) for row in held_out if row["model"] in FLOORS), default=0.0)


def chosen_of(models: Iterable[str], errors_mm: Errors) -> str:
    """The model to take among some that answer single questions; empty where there is none.

    It is the one of the least error on later strokes, or on held-out points where no later stroke is left out; the
    spline, if its error is at most `LESS` times that. Without errors it is the spline, if it is among them.
    """
    named = sorted(set(models))
    for split in ("later", "within"):
        errors = {model: errors_mm[model, split] for model in named if (model, split) in errors_mm}
        if errors:
            least = min(errors, key=lambda model: errors[model])
            return USUAL if USUAL in errors and errors[USUAL] <= LESS * errors[least] else least
    return USUAL if USUAL in named else named[0] if named else ""
