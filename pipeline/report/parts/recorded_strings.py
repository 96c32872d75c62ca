"""The strings of a material's page: their sizes, their load, their runs and strokes."""

from collections.abc import Collection, Iterable
from pathlib import Path

import numpy as np
import pandas as pd
from markupsafe import Markup

from ...ground.kinematics import usual_stiffness
from ...ground.stored import schemas
from ..shown.run_strokes import strokes_of_runs
from ..shown.shown_strokes import listed, ranges
from ..web.page import paragraph, together
from ..web.sortable_table import table

HEAD = {  # by column of a dataset, a head of the table
    "load_n": "load (N)", "radius_mm": "radius (mm)", "length_mm": "length (mm)",
    "torsion_zone_mm": "torsion zone (mm)", "separator_mm": "separator (mm)",
    "stiffness_n_per_mm": "stiffness (N/mm)", "motor_turns": "twist (turns)",
}  # fmt: skip
SIZES = list(HEAD)
DIGITS = 4  # of a size
NOTHING = 1e-3  # of the largest: a twist so small is said as 0
ROWS = 1 << 16  # of a dataset that are held at once
FEW = 6  # strings that have a sentence each; more stand in a table
NOT_MEASURED = "not measured"
ONE_ANSWER = (
    "Asked single points, every model but calibrated has one answer for strings of the same sizes, that of all of them "
    "together, and their errors here are those of such fits: {}. predict --each-string fits a model to each string "
    "alone and answers for it; export --all-points --string does so for a controller."
)
TOLD_APART = [name for name in SIZES if name not in ("load_n", "motor_turns")]
NAMED = 4  # strings of the same sizes
NONE = "none"


def _ends(points: pd.DataFrame) -> pd.DataFrame:
    """Least and largest of every size, a row a run and stroke."""
    return points.groupby(["string", "run", "stroke"], sort=False)[SIZES].agg(["min", "max"])


def by_stroke(path: Path) -> pd.DataFrame:
    """Least and largest of every size of a dataset, a row a string, run and stroke; it is read piece by piece.

    Raises BadInput for a file that is no dataset.
    """
    parquet, columns = schemas.opened(path, schemas.DATASET), ["string", "run", "stroke", *SIZES]
    try:
        pieces = [_ends(batch.to_pandas()) for batch in parquet.iter_batches(ROWS, columns=columns)]
    finally:
        parquet.close(force=True)
    every = pd.concat(pieces)
    how = {column: column[1] for column in every.columns}
    return every.groupby(level=["string", "run", "stroke"], sort=False).agg(how)


def _span(low: float, high: float) -> str:
    """A size, or its least and largest: 20, 19.8 to 20.2; "none" if the rig lacks it."""
    if np.isnan(low):
        return NONE
    ends = [0.0 if abs(value) < NOTHING * abs(high) else value for value in (low, high)]
    return " to ".join(dict.fromkeys(f"{float(f'{value:.{DIGITS}g}'):,g}" for value in ends))


def _stiffness(own: pd.DataFrame) -> str:
    """The stiffness in words; a run without one is simulated with the usual one of a string of its size."""
    usual = usual_stiffness(own["radius_mm", "min"], own["length_mm", "min"])
    is_given = ~np.isclose(own["stiffness_n_per_mm", "min"], usual, rtol=1e-9)
    stiffness = own[is_given]["stiffness_n_per_mm"]
    return _span(stiffness["min"].min(), stiffness["max"].max()) if is_given.any() else NOT_MEASURED


def runs_of_strings(strokes: pd.DataFrame) -> dict[str, list[str]]:
    """The runs of each string, of `by_stroke`, in order of recording."""
    groups = strokes.groupby(level="string", sort=False)
    return {str(string): _runs(own) for string, own in groups}


def _runs(own: pd.DataFrame) -> list[str]:
    """The runs of one string, in order of recording."""
    return [str(run) for run in dict.fromkeys(own.index.get_level_values("run"))]


def rows(strokes: pd.DataFrame) -> Iterable[list[str]]:
    """A row of words a string, of `by_stroke`."""
    for string, own in strokes.groupby(level="string", sort=False):
        words = {name: _span(own[name, "min"].min(), own[name, "max"].max()) for name in SIZES}
        words["stiffness_n_per_mm"] = _stiffness(own)
        numbers = sorted({int(number) for number in own.index.get_level_values("stroke")})
        yield [str(string), ", ".join(_runs(own)), *words.values(), ranges(numbers)]


def sentence(row: list[str]) -> str:
    """A row in words: "String a-01 (run a-01): load 20 N, radius 0.4 mm, …; strokes 1 to 9"."""
    string, runs, *sizes, strokes = row
    named = [
        f"{head.partition(' (')[0]} {size}{'' if size == NOT_MEASURED else ' ' + head.partition(' (')[2].rstrip(')')}"
        for head, size in zip(HEAD.values(), sizes, strict=True)
        if size != NONE
    ]
    strokes_named = f"stroke{'s' * (not strokes.isdigit())} {strokes}"
    return f"String {string} (run{'s' * (', ' in runs)} {runs}): {', '.join(named)}; {strokes_named}."


def recorded_strings(strokes: pd.DataFrame, material: str, tared: Collection[str] | None = None) -> Markup:
    """The strings of a material's page, from `by_stroke`: two sentences a string, or a table of many.

    `tared` names the runs whose run.yaml says `tare: run`, None where that is not known.
    """
    of_strings = list(rows(strokes))
    if len(of_strings) <= FEW:
        by_string = [own for _, own in strokes.groupby(level="string", sort=False)]
        words = [(sentence(row), strokes_of_runs(own, tared)) for row, own in zip(of_strings, by_string, strict=True)]
        return together([*(paragraph(" ".join(filter(None, sentences))) for sentences in words), _one_answer(strokes)])
    head = ["string", "runs", *HEAD.values(), "strokes"]
    every = table(head, of_strings, f"The strings of {material}", (0, 1), paged=True)
    return together([every, _one_answer(strokes)])


def _one_answer(strokes: pd.DataFrame) -> Markup:
    """That strings of the same sizes have one answer, and which they are; empty where no two are alike."""
    by_sizes: dict[tuple[str, ...], list[str]] = {}
    for string, own in strokes.groupby(level="string", sort=False):
        sizes = tuple(_span(own[name, "min"].min(), own[name, "max"].max()) for name in TOLD_APART)
        by_sizes.setdefault(sizes, []).append(str(string))
    groups = [
        f"{', '.join(alike[:NAMED])} and {len(alike) - NAMED} more" if len(alike) > NAMED else listed(alike)
        for alike in by_sizes.values()
        if len(alike) > 1
    ]
    return paragraph(ONE_ANSWER.format("; ".join(groups))) if groups else Markup("")
