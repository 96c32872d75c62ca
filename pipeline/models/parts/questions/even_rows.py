"""Rows of a file of questions under its header: one with more or fewer fields is no question, the others are."""

import csv
import io
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

import pandas as pd

from ....ground.errors import BadInput
from ....ground.words.counts import counted
from .bad_rows import BadRow
from .question_cells import COMMA, question_cells


class EvenRows(NamedTuple):
    """A table with a row for each line below the header, and the rows with another number of fields.

    The row of a line with too many fields is empty: they may stand under any header.
    """

    table: pd.DataFrame
    longer: list[BadRow]
    shorter: list[BadRow]


def even_rows(path: Path, columns: Collection[str], words: Collection[str]) -> EvenRows:
    """The rows of a file; columns of `words` are text. Raises BadInput for a file that is no table."""
    (header, *lines), mark = question_cells(path, columns, words)
    if not lines:
        raise BadInput(path, "rows", "there are none", "write a header, and one question a line")
    with_point = "write numbers with a point (3.5), and " * (mark == COMMA)
    rows, longer, shorter = [], list[BadRow](), list[BadRow]()
    for number, fields in enumerate(lines, start=1):
        has, instead = f"has {counted(len(fields), 'field')}", f", and the header has {len(header)}"
        if any(fields[len(header) :]):
            mend = f"{with_point}take out the fields that are too many"
            longer.append(BadRow(number, "", has, instead, mend))
            fields = []
        elif len(fields) < len(header):
            mend = f"write what is missing: {', '.join(header[len(fields) :])}"
            shorter.append(BadRow(number, "", has, instead, mend))
        rows.append([*fields, *[""] * len(header)][: len(header)])
    return EvenRows(_read(header, rows, words), longer, shorter)


def _read(header: list[str], rows: list[list[str]], words: Collection[str]) -> pd.DataFrame:
    """The table of rows of cells, with numbers where a column has nothing else."""
    text = io.StringIO()
    csv.writer(text, quoting=csv.QUOTE_ALL).writerows(rows)
    text.seek(0)
    as_text: dict[int, type] = {place: str for place, name in enumerate(header) if name in words}
    table = pd.read_csv(text, header=None, index_col=False, dtype=as_text, skip_blank_lines=False, low_memory=False)
    table.columns = pd.Index(header)  # as they stand: pandas would number those that stand twice
    return table
