"""A csv of questions as it stands: every cell where its header says, every column known, nothing guessed."""

from collections.abc import Collection
from pathlib import Path

import numpy as np
import pandas as pd

from ...formats.text import read_text
from ...ground.complaint import key_name, meant
from ...ground.errors import BadInput
from ...ground.text_file import TextFile

IN_WORDS = {  # of run.yaml, which questions have not: the field here, and the mend
    "file.delimiter": ("columns", "part the columns by commas"),
    "file.encoding": ("file", "save it as CSV in UTF-8"),
}


def question_table(path: Path, known: Collection[str]) -> pd.DataFrame:
    """Table of a csv with a header whose columns are among the known; raises BadInput naming the column."""
    try:
        cells = read_text(path, TextFile.model_validate({}))
    except BadInput as error:
        if "holds no samples" in error.problem:
            raise BadInput(path, "rows", "there are none", "write a header, and one question a line") from None
        field, mend = IN_WORDS.get(error.field, (error.field, "give a csv with a header, one question a line"))
        raise BadInput(path, field, error.problem, mend) from None
    for name in cells.columns:
        if name not in known:
            raise BadInput(path, key_name(name), "is not a column that is read", meant(name, known))
    twice = cells.columns[cells.columns.duplicated()]
    if len(twice):
        raise BadInput(path, twice[0], "is a column twice", "keep one")
    return cells


def refuse_cells(path: Path, cells: pd.Series, recorded: pd.Series, numeric: bool) -> None:
    """Raise BadInput for a column with words, an infinite number, or a gap where the recorded ones have none."""
    name = str(cells.name)
    empty = cells.isna()
    if empty.any() and recorded.notna().all():
        raise BadInput(path, name, f"is empty in row {int(np.argmax(empty)) + 1}", "fill it in")
    if numeric and cells.dtype.kind not in "iuf":
        raise BadInput(path, name, "is not a number everywhere", "correct it")
    if numeric and np.isinf(cells.to_numpy(np.float64)).any():
        raise BadInput(path, name, "is not a number everywhere: one is without end", "correct it")
