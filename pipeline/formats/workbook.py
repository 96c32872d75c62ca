"""A sheet of an Excel workbook (.xlsx), as a table."""

import contextlib
import datetime
import itertools
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pandas as pd

from ..ground.errors import BadInput
from ..ground.input.complaint import key_name, short
from ..ground.input.text_file import TextFile
from ..ground.stored.regular_file import open_regular
from ..ground.words.counts import counted
from .interface import Format
from .unpacked import IS_IT, NO_READINGS, is_bomb

MOST_BYTES, MOST_BESIDE = 700_000_000, 200_000_000  # of all parts, and of a part that is no sheet, unpacked
MOST_ROWS, MOST_COLUMNS = 1_048_576, 2_000  # a sheet's, and a recording's
LOOK = 50  # rows at the start by which the layout is judged
OLD = b"\xd0\xcf\x11\xe0"  # how a workbook of before 2007, or an encrypted one, begins
SAVE = "save it again as .xlsx, or its table as CSV"


def _check_parts(path: Path) -> None:
    """Raise BadInput for a zip file that is no workbook, or holds more than a recording can have."""
    with open_regular(path) as file:
        if file.read(len(OLD)) == OLD:
            mend = "save it as .xlsx without a password, or its table as CSV"
            raise BadInput(path, "file", "is an old Excel workbook, or one with a password", mend)
    try:
        with open_regular(path) as file, zipfile.ZipFile(file) as parts:
            sizes = {part.filename: part.file_size for part in parts.infolist()}
            packed = sum(part.compress_size for part in parts.infolist())
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError) as error:
        raise BadInput(path, "file", f"is not a readable workbook ({str(error)[:80]})", "copy it again") from None
    if not any(name.startswith("xl/") for name in sizes):
        kind = "an OpenDocument file" if "content.xml" in sizes else "a zip file and no Excel workbook"
        mend = SAVE if "content.xml" in sizes else "unpack it and give a file of it"
        raise BadInput(path, "file", f"is {kind}", mend)
    beside = max((size for name, size in sizes.items() if not name.startswith("xl/worksheets/")), default=0)
    if is_bomb(sum(sizes.values()), packed):
        raise BadInput(path, "file", NO_READINGS, IS_IT)
    if sum(sizes.values()) > MOST_BYTES or beside > MOST_BESIDE:
        raise BadInput(path, "file", f"has {sum(sizes.values()) / 1e6:.0f} MB of text", "save its table as CSV")


def _sheet(path: Path, book: Any, wanted: str | int | None) -> Any:
    """The sheet that `file.sheet` names, else the first; raises BadInput where it is not there."""
    sheets = {sheet.title: sheet for sheet in book.worksheets}
    titles = ", ".join(key_name(title) for title in list(sheets)[:12])
    if not sheets:
        raise BadInput(path, "file.sheet", "the workbook holds no sheet of cells", SAVE)
    if isinstance(wanted, int) and str(wanted) not in sheets:
        if not 0 <= wanted < len(sheets):
            problem = f"is {wanted}, but the workbook has {len(sheets)}, counted from 0: {titles}"
            raise BadInput(path, "file.sheet", problem, "name one of them")
        return list(sheets.values())[wanted]
    if wanted is not None and str(wanted) not in sheets:
        raise BadInput(path, "file.sheet", f"{short(wanted)} is not in the workbook, only {titles}", "name one of them")
    return sheets[str(wanted)] if wanted is not None else next(iter(sheets.values()))


def seconds(value: Any) -> Any:
    """A cell's date or time in seconds, from 1970 or from midnight; any other value as it stands."""
    if isinstance(value, datetime.datetime):
        return (value - datetime.datetime(1970, 1, 1)).total_seconds()
    if isinstance(value, datetime.timedelta):
        return value.total_seconds()
    if isinstance(value, datetime.time):
        return value.hour * 3600 + value.minute * 60 + value.second + value.microsecond / 1e6
    return value


def _rows(path: Path, sheet: Any) -> Iterator[tuple[int, list[Any]]]:
    """Rows of a sheet that hold a cell, after their numbers, without empty cells at their ends; raises BadInput."""
    sheet.reset_dimensions()  # what the file says of its own size can be wrong
    for number, row in enumerate(sheet.iter_rows(values_only=True)):
        if number >= MOST_ROWS or len(row) > MOST_COLUMNS:
            problem = f"has a cell beyond row {MOST_ROWS} or column {MOST_COLUMNS}"
            raise BadInput(path, "file.sheet", problem, SAVE)
        cells = [None if isinstance(cell, str) and not cell.strip() else cell for cell in row]
        while cells and cells[-1] is None:
            cells.pop()
        if cells:
            yield number, cells


def _check_start(path: Path, rows: list[list[Any]], layout: TextFile) -> None:
    """Raise BadInput where titles stand above the names, or units between them and the numbers."""
    of_numbers = (sum(not isinstance(cell, str | None) for cell in row) * 2 > len(row) > 1 for row in rows[:LOOK])
    first = next((number for number, is_number in enumerate(of_numbers) if is_number), 0)
    below = first - layout.header - layout.skip_below
    if below <= 0:
        return
    above = ", ".join(short(row) for row in rows[:first])[:200]
    problem = f"has {counted(first, 'row')} above its first row of numbers: {above}"
    if layout.header and len(rows[0]) == len(rows[first]):
        raise BadInput(path, "file.skip_below", problem, f"set file.skip_below to {first - 1}")
    more = f"set file.skip to {layout.skip + below}, if the names stand in the row above the numbers"
    raise BadInput(path, "file.skip", problem, more)


def _named(path: Path, rows: list[list[Any]], names: list[str], whole: bool) -> pd.DataFrame:
    """Rows as a table; raises BadInput for a row with more cells than there are names."""
    width = max(len(names), *(len(row) for row in rows))
    if whole and width > len(names):
        long = next(row for row in rows if len(row) > len(names))
        problem = f"has a row of {len(long)} cells, {short(long)}, under {len(names)} names"
        raise BadInput(path, "file.skip", problem, "set file.skip to the rows before the names, or name each column")
    filled = [[seconds(cell) for cell in row] + [None] * (width - len(row)) for row in rows]
    table = pd.DataFrame(filled)
    table.columns = pd.Index(names + [str(index) for index in range(len(names), width)])
    return table


@contextlib.contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """The workbook of a file, while it is read; raises BadInput where it is none."""
    import openpyxl

    _check_parts(path)
    try:
        with open_regular(path) as file:
            yield openpyxl.load_workbook(file, read_only=True, data_only=True, keep_links=False)
    except BadInput:
        raise
    except Exception as error:  # openpyxl raises whatever a damaged part leads it to
        reason = f"{type(error).__name__}: {str(error)[:80]}"
        raise BadInput(path, "file", f"is not a readable workbook ({reason})", SAVE) from None


def first_rows(path: Path, most: int) -> dict[str, list[tuple[int, list[Any]]]]:
    """The first rows of each sheet that hold a cell, after their numbers from 0; raises BadInput."""
    with _opened(path) as book:
        return {sheet.title: list(itertools.islice(_rows(path, sheet), most)) for sheet in book.worksheets}


def read_workbook(path: Path, layout: TextFile) -> pd.DataFrame:
    """Cells of a sheet under the names of its first row; raises BadInput for no workbook, no such sheet, no rows."""
    with _opened(path) as book:
        sheet = _sheet(path, book, layout.sheet)
        title = sheet.title
        rows = [
            row
            for number, row in _rows(path, sheet)
            if number >= layout.skip and not (layout.comment and str(row[0]).startswith(layout.comment))
        ]
    _check_start(path, rows, layout)
    names = ["" if cell is None else str(cell).strip() for cell in rows[0]] if layout.header and rows else []
    rows = rows[1 + layout.skip_below :] if layout.header else rows
    if not rows:
        raise BadInput(path, f"sheet {title!a}", "holds no rows", "name another under file.sheet")
    return _named(path, rows, names, layout.header)


FORMAT = Format(
    "an Excel workbook",
    (".xlsx", ".xlsm", ".xls"),
    (b"PK\x03\x04", OLD),
    frozenset({"sheet"}),
    read_workbook,
)
