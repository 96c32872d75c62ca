"""Deviations of a text recording from `file:`: lines before the table, rows of another length, a cut end."""

import csv
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.input.complaint import short
from ..ground.input.text_file import TextFile
from ..ground.words.counts import counted
from .time_stamps import is_stamp

DELIMITERS = {";": "';'", "\t": r'"\t"', ",": "','", "|": "'|'", " ": "' ', which is any white space"}
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?|nan", re.IGNORECASE)
DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+([eE][+-]?\d+)?")
LOOK = 50  # lines at the start by which the layout is judged
MOST_BELOW = 5  # lines of units, ranges and the like under the names


def cells(line: str, delimiter: str) -> list[str]:
    """Cells of a line, without the white space around them."""
    if delimiter == " ":
        return line.split()
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter, skipinitialspace=True))]
    except (csv.Error, StopIteration):
        return []


def with_point(cell: Any) -> Any:
    """A cell with a decimal point where it is a number with a decimal comma, any other as it stands."""
    return cell.replace(",", ".") if isinstance(cell, str) and DECIMAL_COMMA.fullmatch(cell.strip()) else cell


def _of_numbers(line: str, delimiter: str) -> bool:
    """Whether a line is a row of a recording: two cells or more, most of them numbers or times of day."""
    words = cells(line, delimiter)
    return len(words) > 1 and 2 * sum(bool(NUMBER.fullmatch(cell)) or is_stamp(cell) for cell in words) > len(words)


def other_delimiter(lines: list[str], delimiter: str) -> str | None:
    """Another delimiter that splits the first lines, or a later row of numbers, where the given one does not."""
    rows = [lines[:2], lines[-3:-1] if len(lines) > 3 else []]
    if any(_of_numbers(line, delimiter) for line in lines):
        return None
    if not any(len(cells(line, delimiter)) > 1 for line in rows[0]):
        for other in DELIMITERS:
            widths = {len(cells(line, other)) for line in rows[0]}
            if other != delimiter and len(widths) == 1 and widths.pop() > 1 and (
                len(lines) <= 3 or any(_of_numbers(line, other) for line in rows[1])
            ):  # fmt: skip
                return other
    return next(
        (other for other in DELIMITERS if rows[1] and all(_of_numbers(line, other) for line in rows[1])),
        None,
    )


def check_start(path: Path, lines: list[tuple[int, str]], layout: TextFile) -> None:
    """Raise BadInput where titles stand before the table; `lines` are its first ones, and how many are before each."""
    first = cells(lines[0][1], layout.delimiter)
    row = next((i for i, (_, line) in enumerate(lines) if _of_numbers(line, layout.delimiter)), None)
    if row is None or row <= layout.header:
        return
    width = len(cells(lines[row][1], layout.delimiter))
    if len({cell for cell in first if cell}) == width:
        if layout.header and not layout.skip_below and row <= MOST_BELOW:  # names, and what is said of them
            problem = f"has {short(lines[1][1].strip())} between its names and its rows of numbers"
            raise BadInput(path, "file.skip_below", problem, f"set file.skip_below to {row - 1}")
        return  # names, whatever stands below them
    before, start = lines[row - layout.header]
    problem = f"begins with {short(lines[0][1].strip())}, which has not the {width} fields of its rows of numbers"
    what = f"the names, {short(start.strip())}" if layout.header else "the numbers"
    raise BadInput(path, "file.skip", problem, f"set file.skip to {before}: so many lines stand before {what}")


def is_half(before: str, last: str, delimiter: str) -> bool:
    """Whether the last line of a file was cut off; both lines have their ends, and the last one has none if so."""
    if not _of_numbers(before.rstrip("\n"), delimiter):
        return False
    ended = last.endswith("\n")
    row, last_row = (cells(line.rstrip("\n"), delimiter) for line in (before, last))
    short_row = len(last_row) < len(row) and (not ended or all(NUMBER.fullmatch(cell) for cell in last_row))
    half_number = not ended and len(last_row) == len(row) and row[-1][-1:].isdigit() and not last_row[-1][-1:].isdigit()
    return short_row or half_number


def uneven(lines: Iterator[tuple[int, str]], delimiter: str) -> tuple[str, int, list[tuple[int, str]]] | None:
    """A table's lines with more fields than its first line; None where no line has more.

    What the first of them has in words, how many there are, and number in the file, from 1, and text of the first
    `LOOK` of them. `lines` are those of the table, each after how many lines of the file.
    """
    (_, first), worst, count = next(lines), "", 0
    longer: list[tuple[int, str]] = []
    width = len(cells(first, delimiter))
    for number, line in lines:
        fields = len(cells(line, delimiter))
        if fields > width:
            first_has = f"its first line {short(first.rstrip())} has {width}"
            worst = worst or f"{short(line.rstrip())} has {counted(fields, 'field')}, {first_has}"
            longer += [(number + 1, line.strip())] * (count < LOOK)
            count += 1
    return (worst, count, longer) if worst else None
