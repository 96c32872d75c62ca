"""A file of questions, read strictly: every cell under its header, every column known, nothing guessed."""

import difflib
from collections.abc import Collection
from pathlib import Path

import numpy as np
import pandas as pd

from ....ground.errors import BadInput
from ....ground.input.cell_numbers import cell_numbers
from ....ground.input.complaint import key_name, short
from ....ground.units import unit_of
from ..box import SIZES
from .bad_rows import BadRow, of_mask
from .even_rows import EvenRows, even_rows

IN_WORDS = {  # of run.yaml, which questions have not: the field here, and the mend
    "file.delimiter": ("columns", "part the columns by commas, and write numbers with a point: 3.5"),
    "file.encoding": ("file", "save it as CSV in UTF-8"),
    "file.skip": ("file", "begin with the header"),
    "file.skip_below": ("file", "write the first question below the header"),
}
SHEET = "save its sheet of questions as CSV, with commas between the columns"
ALIKE = 0.7  # from there on a name is a misspelt one: `note` is no `stroke`, `stroek` is
NAMED = 30  # strings that are named where a file names none
MOST = 10  # wrong columns that are named
OTHER_NAMES = {  # of a column's quantity, without unit
    "displacement_mm": {"contraction", "displacement", "shortening", "x"},
    "motor_turns": {"twist", "turns", "twists", "revolutions", "rotations"},
}
WORDS = {"direction": "write 1 for winding, -1 for unwinding"}  # the mend of a word where a number belongs


def question_table(path: Path, columns: Collection[str], words: Collection[str]) -> EvenRows:
    """Rows of a csv or a workbook with a header whose columns are among the known, those of `words` as text.

    Raises BadInput naming the column.
    """
    try:
        rows = even_rows(path, columns, words)
    except BadInput as error:
        if "holds no samples" in error.problem:
            raise BadInput(path, "rows", "there are none", "write a header, and one question a line") from None
        if not path.is_file() or error.field in ("columns", "rows"):
            raise
        mend = "part columns by commas, write numbers with a point (3.5), and one question a line below a header"
        field, mend = IN_WORDS.get(error.field, (error.field, SHEET if "workbook" in error.problem else mend))
        raise BadInput(path, field, error.problem, mend) from None
    known_columns(rows.table, path, columns)
    return rows


def known_columns(cells: pd.DataFrame, path: Path, columns: Collection[str]) -> pd.DataFrame:
    """The table unchanged, if each of its columns is known and occurs once; raises BadInput naming the column."""
    wrong = [name for name in cells.columns if name not in columns]
    if wrong:
        are = "are not columns that are read" if len(wrong) > 1 else "is not a column that is read"
        raise BadInput(path, ", ".join(map(key_name, wrong[:MOST])), are, _all_meant(wrong[:MOST], columns))
    twice = cells.columns[cells.columns.duplicated()]
    if len(twice):
        raise BadInput(path, twice[0], "is a column twice", "keep one")
    return cells


def bad_cells(cells: pd.Series, recorded: pd.Series, numeric: bool, may_be_empty: bool = False) -> list[BadRow]:
    """Rows of a column with words or infinite numbers in place of numbers, or empty where recordings have a value."""
    name, bad = str(cells.name), []
    empty = cells.isna().to_numpy()
    if recorded.notna().all() and not may_be_empty:
        what = "is empty or nan" if numeric else "is empty"
        bad += of_mask(empty, name, what, "", "fill it in, or take the row out")
    if not numeric:
        return bad
    numbers = cell_numbers(cells)
    if cells.dtype.kind not in "iuf":
        wrong = ~empty & (numbers.isna() | cells.map(_is_bool)).to_numpy()
        for row in np.flatnonzero(wrong):
            cell = str(cells.iloc[row])
            mend = (
                "write a point for the decimal comma" if _has_comma(cell) else WORDS.get(name, "write a number alone")
            )
            bad.append(BadRow(int(row) + 1, name, f"is {short(cell)}", ", no number", mend))
    endless = np.isinf(numbers.to_numpy(np.float64))
    bad += of_mask(endless, name, "is without end", "", "write a number")
    none = (numbers <= 0.0).to_numpy() & (name in SIZES)
    each = [f"is {number:g}" for number in numbers[none]]
    return bad + of_mask(none, name, each, ", no size of a string", f"write it in {unit_of(name)}, above 0")


def missing_columns(path: Path, recorded: pd.DataFrame, told_by: pd.DataFrame) -> BadInput:
    """The complaint on the columns that are missing, of which `recorded` has the recorded values.

    `told_by` are the recorded sizes by which a new string is told instead of by its name, each a column.
    """
    each = {name: recorded_values(recorded[name]) for name in recorded if name not in told_by.columns}
    if "string" in each and len(told_by.columns):
        sizes = " and ".join(f"{name} ({recorded_values(told_by[name])})" for name in told_by)
        each["string"] += f", or of a new string {sizes}"
    several = len(each) > 1
    listed = "; ".join(f"{name}, {values}" if several else values for name, values in each.items())
    problem = f"{'are missing, and vary' if several else 'is missing, and varies'} in the recordings"
    return BadInput(path, ", ".join(each), problem, f"add the column{'s' * several}: {listed}")


def string_meant(name: str, recorded: Collection[str]) -> str:
    """The question after the recorded string that a misspelt name is near to, in brackets; empty where none is.

    One of another number is another string, and not misspelt.
    """
    alike = {string.lower(): string for string in recorded if _digits(string) == _digits(name)}
    near = difflib.get_close_matches(name.lower()[:60], list(alike), n=1)
    meant = alike[near[0]] if near else ""
    return f" (did you mean {meant}?)" if meant else ""


def names_near(name: str, recorded: Collection[str]) -> str:
    """The recorded strings whose names are near to a new one's, behind its own; empty where none is.

    Where no number differs it is the question after the one that is meant, as of `string_meant`.
    """
    near = sorted(difflib.get_close_matches(name[:60], sorted(recorded)))
    return string_meant(name, recorded) or (f", recorded are {', '.join(near)}" if near else "")


def recorded_values(recorded: pd.Series) -> str:
    """The recorded values of a column, as a help for filling it in."""
    if recorded.dtype.kind in "iuf":
        unit = unit_of(str(recorded.name)).replace("1", "")
        return f"recorded are {recorded.min():.4g} to {recorded.max():.4g} {unit}".rstrip()
    values = sorted(set(map(str, recorded)))
    more = f" and {len(values) - NAMED} more" if len(values) > NAMED else ""
    return f"recorded are {', '.join(values[:NAMED])}{more}"


def _all_meant(names: list[str], columns: Collection[str]) -> str:
    """The right name for each of several wrong columns; for one without a near name, all names."""
    if len(names) == 1:
        return _meant(names[0], columns)
    near = {name: column for name in names if (column := _nearest(name, columns))}
    mends = [f"{column} for {key_name(name)}" for name, column in near.items()]
    others = ", ".join(key_name(name) for name in names if name not in near)
    far_mend = [f"known are {', '.join(columns)}: take {others} out, or write one of them"] * bool(others)
    return "; ".join([f"write {', '.join(mends)}"] * bool(mends) + far_mend)


def _renamed(name: str, columns: Collection[str]) -> str:
    """The known column for a name with the same meaning; empty where there is none."""
    words = {name.lower(), name.lower().rpartition("_")[0]}
    return next((column for column, others in OTHER_NAMES.items() if others & words and column in columns), "")


def _nearest(name: str, columns: Collection[str]) -> str:
    """The known column for a misspelt or shortened name; empty where none or several fit."""
    if renamed := _renamed(name, columns):
        return renamed
    begun = [column for column in columns if len(name) > 2 and column.startswith(name)]
    close = begun if len(begun) == 1 else difflib.get_close_matches(name[:60], list(columns), n=1, cutoff=ALIKE)
    return close[0] if close else ""


def _meant(name: str, columns: Collection[str]) -> str:
    """The known column nearest to a misspelt name, with its unit; or all of them."""
    if renamed := _renamed(name, columns):
        return f"rename it: {renamed}? That is in {unit_of(renamed)}"
    nearest = _nearest(name, columns)
    if not nearest:
        return f"take it out; known are {', '.join(columns)}"
    unit = unit_of(nearest)
    return f"did you mean {nearest!r}?" + ("" if unit == "1" else f" It is in {unit}")


def _digits(name: str) -> str:
    """The digits of a name, in their order."""
    return "".join(filter(str.isdecimal, name))


def _is_bool(cell: object) -> bool:
    """Whether a cell is true or false, which pandas takes for 1 and 0."""
    return isinstance(cell, bool | np.bool_)


def _has_comma(cell: str) -> bool:
    """Whether a cell is a number with a decimal comma."""
    try:
        float(cell.replace(",", ".", 1))
    except ValueError:
        return False
    return "," in cell
