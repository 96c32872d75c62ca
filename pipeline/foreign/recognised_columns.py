"""The content of a foreign file, as far as its header and numbers tell: its form, and the channel of each column."""

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from ..formats import read_foreign
from ..formats.text import Uneven, even_lines
from ..formats.text_layout import NUMBER
from ..ground.errors import BadInput
from ..ground.input.complaint import key_name, short
from ..ground.input.strict_yaml import write_yaml
from ..ground.input.text_file import TextFile
from ..ground.kinematics import Array
from ..ground.words.counts import counted
from ..run.table.file_lines import line_or_row, named
from ..run.table.no_number import are_few
from ..run.table.read_log import too_long
from ..systems import System
from .layout_guess import BY_HAND, guess_layout
from .roles import Role, find_roles, numbers

THOUSANDS = r"[+-]?\d{1,3}(?:[.']\d{3})+(?:,\d*)?|[+-]?\d{1,3}(?:,\d{3})+(?:\.\d*)?"


@dataclass(frozen=True)
class Recognised:
    """How a file is written, its columns of numbers, and the channels that they are.

    A column, of shape (rows,), is in its own unit. `words` has what stands in the other columns, by name. `uneven` and
    `foot` say what the import does about lines with fields too many and about those below the numbers, each on a line
    of its own; they are empty without such.
    """

    layout: TextFile
    columns: dict[str | int, Array]
    roles: dict[str, Role]
    uneven: str
    words: dict[str, str]
    foot: str


def layout_yaml(layout: TextFile) -> str:
    """The keys of `file:` that are not as usual, as YAML on one line; empty where all are."""
    default = TextFile.model_validate({})
    settings = {key: value for key, value in layout.model_dump().items() if value != getattr(default, key)}
    return write_yaml(settings, flow=True) if settings else ""


def _table(path: Path, layout: TextFile) -> tuple[pd.DataFrame, str]:
    """The file's table, and what the import does about lines with fields too many, on a line of its own.

    Raises BadInput where there is no table.
    """
    try:
        return read_foreign(path, layout), ""
    except Uneven as error:  # the draft can be made all the same
        table, count = even_lines(path, layout), counted(len(error.lines), "line")
        if are_few(len(error.lines), len(table)):
            return table, f"\n{count} with fields too many, which the import leaves out: {too_long(error.lines)}"
        return table, f"\nbut as it is the import will refuse it: {error}"
    except BadInput as error:
        if not error.mend.startswith("set file."):
            raise
        begins = f"file: {layout_yaml(layout) or '{}'}"
        mend = f"--guess cannot: write the mapping by hand (docs/import.md), with {begins}, and there {error.mend}"
        raise BadInput(error.file, error.field, error.problem, mend) from None


def _refuse_thousands(path: Path, table: pd.DataFrame, columns: dict[str | int, Array]) -> None:
    """Raise BadInput where a column is no numbers since a sign parts their thousands."""
    for place, name in enumerate(table.columns):
        column = table.iloc[:, place]
        if name in columns or place in columns or column.dtype.kind in "fiu":
            continue
        words = column.dropna().astype(str).str.strip()
        parted = words[words.str.fullmatch(THOUSANDS)]
        if len(parted) and (words.str.fullmatch(THOUSANDS) | words.str.fullmatch(NUMBER)).mean() > 0.5:
            problem = f"has numbers such as {parted.iloc[0]}, with a sign between thousands"
            mend = "save it again without that sign (in Excel: the cells' format, Number, without separator)"
            raise BadInput(path, key_name(name), problem, mend)


def _without_foot(layout: TextFile, columns: dict[str | int, Array]) -> tuple[TextFile, dict[str | int, Array]]:
    """How a file is written, and its columns, without the rows at its end that have no number at all."""
    if len({len(values) for values in columns.values()}) != 1:
        return layout, columns
    numbered = np.flatnonzero(np.isfinite(np.column_stack([*columns.values()])).any(axis=1))
    end, count = int(numbered[-1]) + 1, len(next(iter(columns.values())))
    if end == count:
        return layout, columns
    kept = {column: values[:end] for column, values in columns.items()}
    return layout.model_copy(update={"rows": (0, end)}), kept


def _foot(path: Path, layout: TextFile, end: int, rows: int) -> str:
    """What the import does about the rows of a table from `end` on, below its numbers; empty without such."""
    if end >= rows:
        return ""
    which = named(path, layout, list(range(end, rows)))
    return f"\n{counted(rows - end, line_or_row(path))} below the numbers, which the import leaves out: {which}"


def _words(table: pd.DataFrame, columns: Collection[str | int], end: int) -> dict[str, str]:
    """The content of each column that is none of numbers, in the table's rows up to `end`."""
    words = {}
    for place, name in enumerate(table.columns):
        if name not in columns and place not in columns:
            full = table.iloc[:end, place].dropna().astype(str).str.strip()
            full = full[full != ""]
            words[key_name(name)] = f"no numbers, but such as {short(full.iloc[0])}" if len(full) else "empty"
    return words


def _roles(
    system: System, columns: dict[str | int, Array], units: dict[str | int, str], behind: list[str]
) -> dict[str, Role]:
    """The channels that were found; `behind` are names of columns that the file has only by place."""
    if not behind:
        return find_roles(system, columns, units)
    place_by_name = {behind[place]: place for place in columns if isinstance(place, int) and place < len(behind)}
    if len(place_by_name) != len(columns):
        return find_roles(system, columns, units)
    roles = find_roles(system, {name: columns[place] for name, place in place_by_name.items()}, {})
    for role in roles.values():
        name = str(role.column)
        role.column = place_by_name[name]
        role.why = [f"a remark calls it {name}", *role.why]
    return roles


def recognise(path: Path, system: System) -> Recognised:
    """What a file of a kind of rig holds; raises BadInput for a file that is not read, or holds no numbers."""
    guessed = guess_layout(path)
    table, uneven = _table(path, guessed.layout)
    columns = numbers(table, guessed.layout.decimal == ",")
    _refuse_thousands(path, table, columns)
    if not columns:
        raise BadInput(path, "file", "holds no column of numbers", BY_HAND)
    layout, columns = _without_foot(guessed.layout, columns)
    end = layout.rows[1] if layout.rows else len(table)
    words, foot = _words(table, columns, end), _foot(path, guessed.layout, end, len(table))
    named = dict(zip([*table.columns], guessed.units, strict=False))
    units = {column: named.get(column if isinstance(column, str) else table.columns[column], "") for column in columns}
    return Recognised(layout, columns, _roles(system, columns, units, guessed.behind), uneven, words, foot)
