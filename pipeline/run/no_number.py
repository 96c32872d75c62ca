"""Cells that are no numbers: refused with the mend, or, where they are few, the rows that they cost, by their lines."""

import re
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pandas as pd

from ..formats import format_of
from ..formats.text_layout import DECIMAL_COMMA, cells
from ..formats.text_lines import table_lines
from ..ground.complaint import short
from ..ground.counts import counted
from ..ground.errors import BadInput
from ..ground.text_file import TextFile

MOST = 0.01  # of all rows: more that are damaged are no accident
NAMED = 5  # damaged rows that are named
SIGNED = re.compile(r"[+-]?\d+([.,' ]\d+)+([eE][+-]?\d+)?")  # digits with signs among them


def are_few(wrong: int, rows: int) -> bool:
    """Whether so many damaged rows of all are left out, and do not speak against the file."""
    return wrong <= MOST * rows


def _mend(held: str, layout: TextFile) -> str:
    if DECIMAL_COMMA.fullmatch(held) and layout.decimal != ",":
        return "write numbers with a decimal point" if layout.delimiter == "," else 'set file.decimal to ","'
    if SIGNED.fullmatch(held):
        return f'write numbers with no other sign in them than the decimal sign "{layout.decimal}"'
    return ""


def no_number(column: pd.Series, wrong: np.ndarray, first: int, layout: TextFile, path: Path, name: str) -> BadInput:
    """What is said of a raw column with cells that are no numbers, `wrong`, of shape (rows,) and without a unit.

    `first` is the number of its first row in the file's table, from 0.
    """
    place, count = int(np.argmax(wrong)), int(wrong.sum())
    held = column.iloc[place]
    more = f"; so do {counted(count - 1, 'more row')}" if count > 1 else ""
    rows = "remove these rows, or name the column that is meant" if count > 1 else "remove that row"
    line = lines_of(path, layout, [first + place]).get(first + place)
    where = f" (line {line[0]} of the file)" if line and line[0] != first + place + 1 else ""
    row = first - (layout.rows or (0, 0))[0] + place + 1
    problem = f"row {row} holds {short(held)}, not a number{where}{more}"
    return BadInput(path, name, problem, _mend(str(held).strip(), layout) or rows)


def lines_of(path: Path, layout: TextFile, rows: Iterable[int], even: bool = False) -> dict[int, tuple[int, str]]:
    """Number in the file, from 1, and text of the lines of some rows, which count from 0; nothing of other formats.

    `even`: lines that have more fields than the first one are no rows.
    """
    if not path.is_file() or path.suffix == ".frames" or ".csv" not in format_of(path).suffixes:
        return {}
    wanted, by_row, row, width = set(rows), {}, -1 - layout.header, 0
    for number, line in table_lines(path, layout):
        width = width or len(cells(line, layout.delimiter))
        if even and len(cells(line, layout.delimiter)) > width:
            continue
        row += 1
        if row in wanted:
            by_row[row] = (number + 1, line.strip())
        if len(by_row) == len(wanted):
            break
    return by_row


def named(path: Path, layout: TextFile, rows: list[int], even: bool = False) -> str:
    """Some rows, which count from 0, by their lines: "line 1504, '75,0#;;'"; by their numbers where none is text."""
    lines = lines_of(path, layout, rows[:NAMED], even)
    words = [
        f"line {lines[row][0]}, {short(lines[row][1])}" if row in lines else f"row {row + 1}" for row in rows[:NAMED]
    ]
    more = [f"and {counted(len(rows) - NAMED, 'more row')}"] if len(rows) > NAMED else []
    return "; ".join([*words, *more])


def without_damaged(samples: pd.DataFrame, path: Path, layout: TextFile) -> tuple[pd.DataFrame, str]:
    """Samples without the few rows that lack a number, and a sentence on them, empty where there is none.

    Where there are too many, all stay, and the door refuses them.
    """
    wrong = samples.isna().any(axis=1).to_numpy()
    if not wrong.any() or not are_few(int(wrong.sum()), len(samples)):
        return samples, ""
    first = (layout.rows or (0, 0))[0]
    rows = [first + int(row) for row in np.flatnonzero(wrong)]
    sentence = f"{path}: {counted(len(rows), 'damaged row')} left out: {named(path, layout, rows)}"
    return samples[~wrong].reset_index(drop=True), sentence
