"""Strings that a model cannot tell apart: a question about one of them gets the answer for all."""

import numpy as np
import pandas as pd

from ....ground.words.counts import counted
from ..box import SIZES
from ..conditions import Conditions

NAMED = 4  # strings that are named
ANSWER_OF = "answer_of"  # the column that says of which strings together an answer is


def strings_alike(dataset: pd.DataFrame) -> dict[str, str]:
    """Each string of a dataset with others of the same size and material: those alike, in words."""
    conditions = Conditions.of(dataset, SIZES)
    by_sizes: dict[tuple[float, ...], list[str]] = {}
    for string, points in dataset.groupby("string"):
        sizes = np.median(conditions.table(points), axis=0)
        by_sizes.setdefault(tuple(np.round(sizes, 6)), []).append(str(string))
    return {string: _named(alike) for alike in by_sizes.values() if len(alike) > 1 for string in alike}


def one_answer(model: str, alike: dict[str, str], options: str) -> str:
    """The remark that a model has one answer for strings that are alike; empty where none are.

    The `options` are those of the command that answers for each string alone.
    """
    if not alike:
        return ""
    groups = "; ".join(dict.fromkeys(alike.values()))
    return (
        f"beware: {model} does not tell strings of the same sizes apart: {groups} have one answer, that of all of them "
        f"together (column `{ANSWER_OF}`). For answers of one string alone: {options}."
    )


def with_whom(answers: pd.DataFrame, strings: pd.Series, alike: dict[str, str]) -> pd.DataFrame:
    """Answers with a column of the strings that each is for; unchanged where no strings are alike.

    `strings` are those that were asked about, with the answers' index; an answer of one string alone has an empty cell.
    """
    if alike:
        whom = strings.astype(str).map(alike).reindex(answers.index).fillna("")
        answers.insert(list(answers.columns).index("inside"), ANSWER_OF, whom)
    return answers


def _named(strings: list[str]) -> str:
    """The first of some strings, and how many more they are."""
    more = f" and {counted(len(strings) - NAMED, 'more string')}" if len(strings) > NAMED else ""
    return f"{', '.join(sorted(strings)[:NAMED])}{more}"
