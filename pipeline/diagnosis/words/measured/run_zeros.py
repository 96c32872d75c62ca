"""The zeros of several runs that were diagnosed together, in words: there a sensor that was moved shows."""

import math
from collections.abc import Iterator

from ...document.content import Verdict
from ...document.made_keys import Interval
from ..language.quantity import listing
from ..language.vocabulary import Vocabulary

MANY = 8  # runs, where there are more: so many and the number of the others


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A sentence on by how much the zero of each run differs from the first one's; none of one run."""
    runs, moves = content["run"], list(_from_first(content, words))
    if isinstance(runs, str) or not moves:
        return []
    by_run = [f"{run} {_amount(move, words.unit)}" for run, move in zip(runs[1:], moves, strict=False)]
    more = [f"{len(by_run) - MANY} more runs (in diagnosis.json)"] if len(by_run) > MANY else []
    return [f"The zero of the reading, less that of {runs[0]} (90 % interval): {listing([*by_run[:MANY], *more])}."]


def fitted(content: Verdict, before: str, run: str, words: Vocabulary) -> str:
    """By how much a diagnosis of both finds the zero of a run to exceed that of the one before; else empty."""
    runs = content["run"]
    if isinstance(runs, str) or runs[0] != before or run not in runs:
        return ""
    moves = list(_from_first(content, words))
    at = runs.index(run) - 1
    return f"Fitted together with all effects it is {_amount(moves[at], words.unit)}." if at < len(moves) else ""


def _from_first(content: Verdict, words: Vocabulary) -> Iterator[Interval]:
    """What the zero of each later run exceeds the first one's by, as far as the file says it."""
    for number in range(2, len(content["run"]) + 1):
        zero = content["parameters"].get(f"zero_{number}_{words.ending}", {})
        if "from_first" not in zero:
            return
        yield zero["from_first"]


def _amount(move: Interval, unit: str) -> str:
    """A signed number with its interval, to the first digit of the interval's width."""
    width = move["high"] - move["low"]
    places = max(-math.floor(math.log10(width)), 0) if width > 0.0 else 3
    value, low, high = (
        f"{round(each, places) + 0.0:+.{places}f}" for each in (move["value"], move["low"], move["high"])
    )
    return f"{value} {unit} ({low} to {high})"
