"""Questions about several strings, each answered by what its own string was fitted to."""

from collections.abc import Callable
from pathlib import Path

import pandas as pd

from ....ground.errors import BadInput

NAMED = 8  # strings that a complaint names
Answer = Callable[[pd.DataFrame, str], pd.DataFrame]  # of questions, and the column that they tell


def by_string(answer_of: Callable[[str], Answer]) -> Answer:
    """What answers questions about any string: `answer_of` gives what answers those about one, and is asked once."""
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


def check_recorded(strings: pd.Series, dataset: pd.DataFrame, asked_in: Path) -> None:
    """Raise BadInput where questions of a file are about strings without points, so that nothing answers for them."""
    recorded = sorted(set(dataset["string"].astype(str)))
    if strange := sorted(set(strings.astype(str)) - set(recorded)):
        problem = f"is {', '.join(strange[:NAMED])}, of which there is no recording to answer for that string alone"
        more = f" and {len(recorded) - NAMED} more" * (len(recorded) > NAMED)
        raise BadInput(asked_in, "string", problem, f"ask about {', '.join(recorded[:NAMED])}{more}")
