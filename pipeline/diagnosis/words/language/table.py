"""Rows of cells → the lines of a table, its columns under one another."""

UNKNOWN, GAP = "–", 3  # what an older file does not hold; spaces between columns


def aligned(rows: list[list[str]]) -> list[str]:
    """Rows with their cells under each other."""
    wide = [max(map(len, column)) + GAP for column in zip(*rows, strict=True)]
    return ["".join(cell.ljust(width) for cell, width in zip(row, wide, strict=True)).rstrip() for row in rows]
