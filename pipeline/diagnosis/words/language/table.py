"""Rows of cells → the lines of a table, its columns under one another."""

from .sections import WIDE

UNKNOWN, GAPS = "–", (3, 2)  # what an older file does not hold; spaces between columns, and where a page is too narrow
ROOM = WIDE - 5  # letters of a line: a section indents its lines, and a step those that belong to it


def aligned(rows: list[list[str]]) -> list[str]:
    """Rows with their cells under each other."""
    wide = [max(map(len, column)) for column in zip(*rows, strict=True)]
    usual, narrow = GAPS
    gap = usual if sum(wide) + usual * (len(wide) - 1) <= ROOM else narrow
    return [(" " * gap).join(map(str.ljust, row, wide)).rstrip() for row in rows]
