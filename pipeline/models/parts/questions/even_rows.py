"""Rows of a csv of questions under its header: one with more or fewer fields is no question, the others are."""

import csv
import io
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

import pandas as pd

from ....formats.text import first_names
from ....formats.text_layout import LOOK, cells
from ....formats.text_lines import table_lines
from ....ground.errors import BadInput
from ....ground.input.text_file import TextFile
from ....ground.words.counts import counted
from .bad_rows import BadRow

COMMA = ","
OTHERS = {";": "';'", "\t": "tabulators", "|": "'|'"}  # that part columns elsewhere
LAYOUT = TextFile.model_validate({})


class EvenRows(NamedTuple):
    """A table with a row for each line below the header, and the rows with another number of fields.

    The row of a line with too many fields is empty: they may stand under any header.
    """

    table: pd.DataFrame
    longer: list[BadRow]
    shorter: list[BadRow]


def even_rows(path: Path, columns: Collection[str], words: Collection[str]) -> EvenRows:
    """The rows of a csv; columns of `words` are text. Raises BadInput for a file that is no table."""
    lines = [line for _, line in table_lines(path, LAYOUT)]
    header = cells(lines[0], COMMA) if lines else []
    if len(header) == 1 and (other := next((mark for mark in OTHERS if mark in header[0]), None)):
        mend = "part the columns by commas, and write numbers with a point: 3.5"
        raise BadInput(path, "columns", f"are parted by {OTHERS[other]}", mend)
    if not lines or not set(header) <= set(columns):  # else it is a table of questions, whatever its rows are
        first_names(path, LAYOUT, list(enumerate(lines[:LOOK])), len(lines))
    if len(lines) < 2:
        raise BadInput(path, "rows", "there are none", "write a header, and one question a line")
    rows, longer, shorter = [], list[BadRow](), list[BadRow]()
    for number, line in enumerate(lines[1:], start=1):
        fields = cells(line, COMMA)
        has, instead = f"has {counted(len(fields), 'field')}", f", and the header has {len(header)}"
        if any(fields[len(header) :]):
            mend = "write numbers with a point (3.5), and take out the fields that are too many"
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
