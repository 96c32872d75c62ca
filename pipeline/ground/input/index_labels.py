"""Rows of a table in memory, by the labels of its index: the ones that `DataFrame.drop` takes."""

from collections.abc import Callable

import pandas as pd

from .complaint import key_name


def row_label(index: pd.Index, row: int) -> str:
    """The label of a row, counted from 0; its place, `iloc 778`, where others have the same label."""
    return key_name(index[row]) if index.is_unique else f"iloc {row}"


def by_index(index: pd.Index) -> Callable[[int], str]:
    """Where a row stands, as a function of its number from 0: "the row of index 778"."""
    named = "the row of index" if index.is_unique else "the row of"
    return lambda row: f"{named} {row_label(index, row)}"
