"""The rows of a foreign table that are its recording, with words among the numbers, and the row of their names."""

import re
from typing import Any

from ..formats.text_layout import NUMBER
from ..formats.time_stamps import is_stamp
from ..ground.input.header_units import header_unit, unit_word
from .roles import WORDS

Rows = list[tuple[int, list[Any]]]  # the cells of each row that has some, after its number in the file
LEAST = 2  # numbers in a row of a recording
MOST_ABOVE, FAR_ABOVE = 5, 20  # rows between which and the numbers the names stand: as a rule, and at most


def is_number(cell: Any) -> bool:
    """Whether a cell is a number or a time of day."""
    return bool(NUMBER.fullmatch(cell)) or is_stamp(cell) if isinstance(cell, str) else cell is not None


def _full(cell: Any) -> bool:
    return cell is not None and cell != ""


def places_of_numbers(rows: Rows) -> set[int]:
    """Places at which most rows have a number, for rows with three, or with two and no more words than numbers."""
    likely = []
    for _, row in rows:
        count, full = sum(is_number(cell) for cell in row if _full(cell)), sum(map(_full, row))
        if count > LEAST or (count == LEAST and full <= 2 * LEAST):
            likely.append(row)
    widths = [len(row) for row in likely]
    usual = [row for row in likely if len(row) == max(set(widths), key=widths.count)]
    return {
        place
        for place in range(len(usual[0]) if usual else 0)
        if 2 * sum(_full(row[place]) and is_number(row[place]) for row in usual) > len(usual)
    }


def of_recording(row: list[Any], places: set[int]) -> bool:
    """Whether a row has numbers at more than half of the places of numbers, two or more, and a word at none of them."""
    cells = [row[place] for place in places if place < len(row) and _full(row[place])]
    return len(cells) >= max(LEAST, len(places) // 2 + 1) and all(map(is_number, cells))


def share(row: list[Any]) -> float:
    """The share of a row's cells that are numbers: a delimiter that splits numbers leaves words."""
    full = [cell for cell in row if _full(cell)]
    return sum(map(is_number, full)) / len(full)


def names_told(row: list[Any]) -> int:
    """How many channels the cells of a row name; 0 for a row of numbers or of units."""
    words = [str(cell) for cell in row if _full(cell)]
    if any(map(is_number, words)) or all(unit_word(word) and not header_unit(word) for word in words):
        return 0
    return sum(any(re.search(pattern, word.lower()) for word in words) for pattern in WORDS.values())


def names_at(rows: Rows, first: int) -> int | None:
    """Which row, by its place, has the names of the numbers that begin at place `first`; None where none has.

    It is the top one of those right above the numbers that are as wide. Where another one calls two channels or more
    by their names, and this one does not, it is that one, though titles stand around it.
    """
    width, top = len(rows[first][1]), first
    while top > 0 and first - top < MOST_ABOVE and len(rows[top - 1][1]) == width:
        top -= 1
    wide = [place for place in range(max(0, first - FAR_ABOVE), first) if len(rows[place][1]) == width]
    best = max(wide, key=lambda place: (names_told(rows[place][1]), -place), default=None)
    if best is not None and names_told(rows[best][1]) >= LEAST and names_told(rows[top][1]) < LEAST:
        return best
    return top if top < first else None


def units_in(rows: Rows) -> list[str]:
    """The cells of the row that has most units, of those between names and numbers; none without a row."""
    words = [[str(cell) if _full(cell) else "" for cell in row] for _, row in rows]
    return max(words, key=lambda row: sum(unit_word(word) is not None for word in row if word), default=[])
