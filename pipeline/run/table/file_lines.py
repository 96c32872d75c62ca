"""The line of a file that a row of a recording stands in, for a person who mends the file."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from ...formats import format_of
from ...formats.text_layout import cells
from ...formats.text_lines import table_lines
from ...ground.input.complaint import short
from ...ground.input.text_file import TextFile
from ...ground.words.counts import counted

NAMED = 5  # damaged rows that are named
Where = Callable[[int], str]  # of a row, which counts from 0: "line 504", or "row 504" where its file has no lines


def line_or_row(path: Path) -> str:
    """The unit of a file that a person counts: lines of a text file, else rows."""
    return "line" if path.is_file() and path.suffix != ".frames" and ".csv" in format_of(path).suffixes else "row"


def by_row(row: int) -> str:
    """A row, counted from 0, whose line is unknown: "row 1"."""
    return f"row {row + 1}"


def called(where: str) -> str:
    """What a place is called alone: "line" of "line 504", "row" of any other."""
    return "line" if where.startswith("line ") else "row"


def lines_of(path: Path, layout: TextFile, rows: Iterable[int]) -> dict[int, tuple[int, str]]:
    """Number in the file, from 1, and text of the lines of rows, counted from 0; empty for other formats.

    Lines that have more fields than the first one are no rows.
    """
    if line_or_row(path) == "row":
        return {}
    wanted, lines, row, width = set(rows), {}, -1 - layout.header, 0
    for number, line in table_lines(path, layout):
        width = width or len(cells(line, layout.delimiter))
        if len(cells(line, layout.delimiter)) > width:
            continue
        row += 1
        if row in wanted:
            lines[row] = (number + 1, line.strip())
        if len(lines) == len(wanted):
            break
    return lines


def named(path: Path, layout: TextFile, rows: list[int]) -> str:
    """Some rows, counted from 0, by their lines: "line 1504, '75,0#;;'"; by their numbers if the file is no text."""
    lines = lines_of(path, layout, rows[:NAMED])
    words = [f"line {lines[row][0]}, {short(lines[row][1])}" if row in lines else by_row(row) for row in rows[:NAMED]]
    more = [f"and {counted(len(rows) - NAMED, f'more {line_or_row(path)}')}"] if len(rows) > NAMED else []
    return "; ".join([*words, *more])


@dataclass(frozen=True)
class FileLines:
    """The lines in which the rows of a table stand in its file.

    `numbers` are the rows' own numbers among all of the file, from 0, where some were left out.
    """

    path: Path
    layout: TextFile
    numbers: list[int] | None = None

    @classmethod
    def of(cls, path: Path, layout: TextFile, table: pd.DataFrame) -> "FileLines":
        """The lines of a table whose index has the numbers of its rows, those that `file.rows` asks for."""
        return cls(path, layout, table.index.tolist())

    def __call__(self, row: int) -> str:
        """A row, counted from 0, as "line 504"; as "row 504" if the file is no text."""
        number = (row if self.numbers is None else self.numbers[row]) + (self.layout.rows or (0, 0))[0]
        lines = lines_of(self.path, self.layout, [number])
        return f"line {lines[number][0]}" if number in lines else by_row(number)
