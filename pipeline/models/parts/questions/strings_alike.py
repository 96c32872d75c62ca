"""Strings that a model does not tell apart: who asks about one of them gets the answer for all."""

import numpy as np
import pandas as pd

from ....ground.counts import counted
from ..conditions import MEASURED, Conditions

SIZES = tuple(name for name in MEASURED if name != "load_n")  # a load is told by each question
NAMED = 4  # strings that are named


def strings_alike(dataset: pd.DataFrame) -> list[str]:
    """The strings of a dataset that no size and no material sets apart from another one, sorted."""
    conditions = Conditions.of(dataset, SIZES)
    by_sizes: dict[tuple[float, ...], list[str]] = {}
    for string, points in dataset.groupby("string"):
        sizes = np.median(conditions.table(points), axis=0)
        by_sizes.setdefault(tuple(np.round(sizes, 6)), []).append(str(string))
    return sorted(string for alike in by_sizes.values() if len(alike) > 1 for string in alike)


def one_answer(model: str, strings: list[str]) -> str:
    """That a model of a name has one answer for strings that are alike; empty where none are."""
    if not strings:
        return ""
    more = f" and {counted(len(strings) - NAMED, 'more string')}" if len(strings) > NAMED else ""
    return (
        f"beware: {model} does not tell strings of the same sizes apart: {', '.join(strings[:NAMED])}{more} have one "
        "answer, that of all of them together. For answers of one string alone give its runs a material of their own."
    )
