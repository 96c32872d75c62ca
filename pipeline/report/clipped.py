"""What the traditional model answers where the contraction is negative, in words beneath a figure that shows it."""

from collections.abc import Iterable

import pandas as pd


def clipped(windings: Iterable[pd.DataFrame], where: str) -> str:
    """A sentence on the spike of the inverse error at x = 0; empty where no shown stroke goes below it.

    `windings` hold a stroke each with the traditional model's `inverse_turns`; `where` names the panels.
    """
    below = [points.loc[points["displacement_mm"] < 0.0, "inverse_turns"] for points in windings]
    answers = pd.concat(below) if below else pd.Series(dtype=float)
    if answers.empty:
        return ""
    turns = f"{answers.median():.2g}".replace("-", "−")
    return (
        f"{where}: below x = 0 the string is longer than when its zero was set, and the inverse of the traditional "
        f"model would be the root of a negative number. That is taken as 0, so the model answers {turns} turns at "
        "every x < 0: hence the spike of its error at x = 0."
    )
