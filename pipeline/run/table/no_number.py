"""Cells that are no numbers: refused with the mend; or, if they are few, their rows are left out and named by line."""

import re
from pathlib import Path

import numpy as np
import pandas as pd

from ...formats.text_layout import DECIMAL_COMMA
from ...ground.errors import BadInput
from ...ground.input.complaint import short
from ...ground.input.text_file import TextFile
from ...ground.words.counts import counted
from .file_lines import Where, by_row, line_or_row, lines_of, named

MOST = 0.01  # of all rows: more that are damaged are no accident
SIGNED = re.compile(r"[+-]?\d+([.,' ]\d+)+([eE][+-]?\d+)?")  # digits with signs among them


def are_few(wrong: int, rows: int) -> bool:
    """Whether damaged rows are few enough to be left out."""
    return wrong <= MOST * rows


def _mend(cell: str, layout: TextFile) -> str:
    if DECIMAL_COMMA.fullmatch(cell) and layout.decimal != ",":
        return "write numbers with a decimal point" if layout.delimiter == "," else 'set file.decimal to ","'
    if SIGNED.fullmatch(cell):
        return f'write numbers with no other sign in them than the decimal sign "{layout.decimal}"'
    return ""


def no_number(
    column: pd.Series, wrong: np.ndarray, first: int, layout: TextFile, path: Path, name: str, by: Where = by_row
) -> BadInput:  # fmt: skip
    """The message on a raw column whose cells `wrong`, of shape (rows,) and without a unit, are no numbers.

    `first` is the number of its first row in the file's table, from 0; `by` names a row of no file's line.
    """
    place, count = int(np.argmax(wrong)), int(wrong.sum())
    cell = column.iloc[place]
    lines = lines_of(path, layout, [first + place])
    what = "line" if lines else "row"
    more = f"; so do {counted(count - 1, f'more {what}')}" if count > 1 else ""
    mend = f"remove these {what}s, or name the column that is meant" if count > 1 else f"remove that {what}"
    where = f"line {lines[first + place][0]}" if lines else by(first - (layout.rows or (0, 0))[0] + place)
    problem = f"{where} holds {short(cell)}, not a number{more}"
    return BadInput(path, name, problem, _mend(str(cell).strip(), layout) or mend)


def without_damaged(samples: pd.DataFrame, path: Path, layout: TextFile) -> tuple[pd.DataFrame, list[int], str]:
    """Samples without the few rows that lack a number, the numbers of these rows in the file, and a sentence on them.

    The index of the samples keeps the numbers of their rows, from 0. The sentence is empty where no row is damaged.
    Where there are too many, all stay, and the door refuses them.
    """
    wrong = samples.isna().any(axis=1).to_numpy()
    if not wrong.any() or not are_few(int(wrong.sum()), len(samples)):
        return samples, [], ""
    first = (layout.rows or (0, 0))[0]
    rows = [first + int(row) for row in np.flatnonzero(wrong)]
    sentence = f"{path}: {counted(len(rows), f'damaged {line_or_row(path)}')} left out: {named(path, layout, rows)}"
    return samples[~wrong], rows, sentence
