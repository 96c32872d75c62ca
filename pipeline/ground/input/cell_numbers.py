"""Cells of a column as numbers, whatever stands in them."""

import pandas as pd

TOO_LARGE = 10**308  # a whole number from there on is infinite: pandas converts none that is beyond a float


def cell_numbers(cells: pd.Series) -> pd.Series:
    """Cells as numbers, in the column's unit: NaN where one is none, infinite where one is beyond what a float holds.

    Both of shape (rows,).
    """
    try:
        return pd.to_numeric(cells, errors="coerce")
    except OverflowError:  # a whole number of more than 308 digits, which pandas reads as Python's own
        return pd.to_numeric(cells.map(_within_a_float), errors="coerce")


def _within_a_float(cell: object) -> object:
    """A cell as it is; a whole number that no float holds as an infinite one."""
    if isinstance(cell, int) and abs(cell) >= TOO_LARGE:
        return float("inf") if cell > 0 else float("-inf")
    return cell
