"""The strokes that a panel of the life's page shows: from the first one seen to where its interval ends."""

import numpy as np

from .forecast.life_questions import Answer


def span_of_strokes(answers: list[Answer], level: float) -> tuple[float, float] | None:
    """The first and the last stroke that both questions show, so that one stroke stands in one line.

    None where nothing is foretold.
    """
    foretold = [answer for answer in answers if answer.left.choice and answer.left.band is not None]
    ends = [
        float(answer.n[-1]) + farthest(answer.left.span(level).high, float(answer.n[-1]), answer.left.horizon)
        for answer in foretold
    ]
    first = min((float(answer.n[0]) for answer in answers if len(answer.n)), default=0.0)
    return (first, max(ends)) if ends else None


def farthest(high: float, seen: float, horizon: float) -> float:
    """How many strokes ahead are drawn: the whole interval if it ends, else to the horizon of the forecast."""
    return max(1.15 * high, 0.375 * seen) if np.isfinite(high) else horizon
