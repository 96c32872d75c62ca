"""Rows of cells → the lines of a table, its columns under one another."""

import textwrap

from ....ground.words.wrapped_lines import WIDE

UNKNOWN, GAPS = "–", (3, 2)  # what an older file does not hold; spaces between columns, and where a page is too narrow
ROOM, IN_A_STEP = WIDE - 2, 3  # letters of a line, for a section indents its lines; by how much more a step does


def aligned(rows: list[list[str]], room: int = ROOM) -> list[str]:
    """Rows with their cells under each other, nearer to each other where there is no room."""
    wide = [max(map(len, column)) for column in zip(*rows, strict=True)]
    usual, narrow = GAPS
    gap = usual if sum(wide) + usual * (len(wide) - 1) <= room else narrow
    return [(" " * gap).join(map(str.ljust, row, wide)).rstrip() for row in rows]


def wrapped_cells(rows: list[list[str]]) -> list[str]:
    """As `aligned`, but no wider than a page: the words of the widest column go on in lines of their own."""
    columns = list(zip(*rows, strict=True))
    wide = [max(map(len, column)) for column in columns]
    over = sum(wide) + GAPS[1] * (len(wide) - 1) - ROOM
    if over <= 0:
        return aligned(rows)
    place = wide.index(max(wide))
    most = max(wide[place] - over, *(len(word) for cell in columns[place] for word in cell.split()))
    lines = []
    for row in rows:
        first, *others = textwrap.wrap(row[place], most, break_long_words=False, break_on_hyphens=False) or [""]
        lines.append([first if at == place else cell for at, cell in enumerate(row)])
        lines += [[other if at == place else "" for at in range(len(row))] for other in others]
    return aligned(lines)


def within(rows: list[list[str]], cell: int) -> list[str]:
    """As `aligned`, but no wider than a page: where the cell at place `cell` is too long, it gets a line of its own."""
    others = [max(map(len, column)) for place, column in enumerate(zip(*rows, strict=True)) if place != cell]
    most = ROOM - sum(others) - GAPS[1] * len(others)
    shortened = [[text if place != cell or len(text) <= most else "" for place, text in enumerate(row)] for row in rows]
    lines = []
    for row, line in zip(rows, aligned(shortened), strict=True):
        lines += [line] if len(row[cell]) <= most else [row[cell], line]
    return lines
