"""Questions about several strings, each answered by the model of its own string."""

from collections.abc import Callable

import pandas as pd

Answer = Callable[[pd.DataFrame, str], pd.DataFrame]  # of questions, and the column that they tell


def by_string(answer_of: Callable[[str], Answer]) -> Answer:
    """A function that answers questions about any string; `answer_of` gives that for one string, and is called once."""
    of_string: dict[str, Answer] = {}

    def answer(points: pd.DataFrame, from_column: str) -> pd.DataFrame:
        """The answers in the order of the questions, which are numbered from 0."""
        tables = []
        for name, own in points.groupby(points["string"].astype(str), sort=False):
            string = str(name)
            if string not in of_string:
                of_string[string] = answer_of(string)
            tables.append(of_string[string](own.reset_index(drop=True), from_column).set_axis(own.index, axis=0))
        return pd.concat(tables).sort_index()

    return answer
