"""The traditional model's answer where the contraction is negative, in words beneath a figure that shows it."""

from collections.abc import Iterable

import pandas as pd


def clipped(windings: Iterable[pd.DataFrame], where: str) -> str:
    """A sentence on the inverse error at x < 0; empty where no shown stroke goes below it.

    `windings` hold a stroke each with the traditional model's `inverse_turns`; `where` names the panels.
    """
    below = [points[points["displacement_mm"] < 0.0] for points in windings]
    points = pd.concat(below) if below else pd.DataFrame()
    if points.empty:
        return ""
    turns = f"{points['inverse_turns'].median():.2g}".replace("-", "−")
    errors = (points["inverse_turns"] - points["motor_turns"]).abs()
    return (
        f"{where}: below x = 0 the string is longer than the traditional model has it at any twist. There the model's "
        f"equation has the root of a negative number. The root of 0 is taken in its place, so the model answers {turns}"
        f" turns at every x < 0, and errs there by up to {errors.max():.2g} turns."
    )
