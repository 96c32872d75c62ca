"""A text recording, plain or gzipped, as a table of numbers: read line by line, never endless and never guessed."""

import io
import re
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, TypedDict

import pandas as pd

from ..ground.errors import BadInput
from ..ground.input.text_file import TextFile
from ..ground.stored import schemas
from ..ground.words.counts import counted
from .interface import Format
from .text_layout import DELIMITERS, cells, check_start, other_delimiter, uneven
from .text_lines import IMPORT, TableFile, table_lines

MOST_COLUMNS = 2_000
FEW = 20  # lines with fields too many: slips of a logger; more of them are another layout


class Reading(TypedDict):
    """Arguments of pandas."""

    sep: str
    header: int | None
    skipinitialspace: bool
    index_col: Literal[False]
    decimal: str
    engine: Literal["c"]


def read_text(path: Path, layout: TextFile) -> pd.DataFrame:
    """Text table of numbers as it stands in the file; columns have their header's names or indices from 0.

    Raises BadInput for a file that is empty, is not text, or holds something else than numbers.
    """
    pieces = list(text_pieces(path, layout))
    return pieces[0] if len(pieces) == 1 else pd.concat(pieces, ignore_index=True)


def text_pieces(path: Path, layout: TextFile) -> Iterator[pd.DataFrame]:
    """What `read_text` gives, in pieces of some rows, at least one; raises BadInput as it does."""
    with TableFile(path, layout) as lines:
        names = first_names(path, layout, lines.first, lines.count)
        rows = 0
        for table in _tables(path, layout, lines):
            if layout.header:  # as they stand: pandas would number those that stand twice
                own = [str(name).strip() for name in table.columns]
                table.columns = [name or own[i] for i, name in enumerate(names)] if len(names) == len(own) else own
            rows += len(table)
            yield table.reset_index(drop=True)
        count = lines.count - layout.header
        if rows != count:  # a quote that is left open takes the lines up to the next one with it
            problem = f"has {count} lines of samples, of which {rows} can be told apart"
            raise BadInput(path, "file", problem, "remove the quotation mark that is left open in one of its lines")


def first_names(path: Path, layout: TextFile, first: list[tuple[int, str]], count: int) -> list[str]:
    """Cells of a table's first line; raises BadInput where its beginning is not as `file:` says.

    `first` are its first lines, each after how many lines of the file, and `count` how many it has as far as is known.
    """
    begin = first[0][1].lstrip() if first else ""
    if begin.startswith(("{", "[", "<")):
        if begin[0] == "<":
            raise BadInput(path, "file", "is a page of the web, not a table", "save its table as CSV")
        raise BadInput(path, "file", "is JSON, not a table", f"name it .json and {IMPORT}")
    if count <= layout.header:
        raise BadInput(path, "file", "holds no samples", "record again; nothing was written by the logger")
    other = other_delimiter([line for _, line in first], layout.delimiter)
    if other:
        problem, mend = f"is {layout.delimiter!r}, which parts no line", f"set file.delimiter to {DELIMITERS[other]}"
        raise BadInput(path, "file.delimiter", problem, mend)
    names = cells(first[0][1], layout.delimiter)
    if len(names) > MOST_COLUMNS:
        problem = f"has {len(names)} columns in its first line"
        raise BadInput(path, "file", problem, "check file.delimiter; a recording has one column a channel")
    check_start(path, first, layout)
    return names


def _tables(path: Path, layout: TextFile, lines: TableFile) -> Iterator[pd.DataFrame]:
    """Tables of so many rows as a row group has, as pandas reads them; raises BadInput for what is no table."""
    try:
        reader = pd.read_csv(io.BufferedReader(lines), chunksize=schemas.ROW_GROUP, **_as_written(layout))
        while (table := _next(reader)) is not None and lines.error is None:
            yield table
    except (ValueError, OverflowError, pd.errors.ParserWarning) as error:
        if lines.error is None:
            raise _no_table(path, layout, error) from None
    if lines.error is not None:
        raise lines.error


class Uneven(BadInput):
    """Some `lines`, by number from 1 and text, have fields too many: the others are a table."""

    lines: list[tuple[int, str]]


def _no_table(path: Path, layout: TextFile, error: Exception) -> BadInput:
    """What is wrong with lines that pandas makes no table of, by the first line that has fields too many."""
    mend = "check file.delimiter, file.skip and file.comment"
    longer = uneven(table_lines(path, layout), layout.delimiter)
    if longer is None:
        reason = re.sub(r"\s+", " ", str(error)).strip()[:200]
        return BadInput(path, "file", f"is not a table ({reason})", f"{mend}, and the line that it names")
    what, count, several = longer
    number = several[0][0]
    more = f"; so have {counted(count - 1, 'more line')}" if count > 1 else ""
    problem = f"is not a table (line {number}, {what}{more})"
    if count > FEW:
        return BadInput(path, "file", problem, mend)
    lines = f"line {number}" if count == 1 else f"line {number} and the others"
    error = Uneven(path, "file", problem, f"take the fields that are too many out of {lines}, or the whole line")
    error.lines = several
    return error


def even_lines(path: Path, layout: TextFile) -> pd.DataFrame:
    """The table of a file without the lines that have fields too many."""
    lines = [line for _, line in table_lines(path, layout)]
    width = len(cells(lines[0], layout.delimiter))
    text = "".join(line for line in lines if len(cells(line, layout.delimiter)) <= width)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pd.errors.DtypeWarning)  # a word among numbers is found later
        table = pd.read_csv(io.StringIO(text), **_as_written(layout))
    if layout.header:  # as they stand: pandas would number those that stand twice
        table.columns = cells(lines[0], layout.delimiter)
    return table


def _as_written(layout: TextFile) -> Reading:
    """How pandas is to read the table."""
    return {
        "sep": r"\s+" if layout.delimiter == " " else layout.delimiter,
        "header": 0 if layout.header else None,
        "skipinitialspace": True,
        "index_col": False,
        "decimal": layout.decimal,
        "engine": "c",
    }


def _next(reader: Iterator[pd.DataFrame]) -> pd.DataFrame | None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pd.errors.DtypeWarning)  # a word among numbers is found later
        warnings.simplefilter("error", pd.errors.ParserWarning)  # a row with a field too many is cut otherwise
        return next(reader, None)


FORMAT = Format("text", (".csv", ".txt", ".tsv", ".dat", ".log", ".asc"), (), frozenset(), read_text)
