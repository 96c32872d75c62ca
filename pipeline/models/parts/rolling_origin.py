"""The known and the predicted points of strings: blocks inside strokes, and the last strokes.

Source: Tashman, "Out-of-sample tests of forecasting accuracy", International Journal of Forecasting 16, 2000.
"""

import pandas as pd

FOLDS = 4  # into which seen strokes are cut to be foreseen from each other
LEAST_STROKES = 4  # to foresee any
AHEAD = 3  # strokes that are foreseen, at most
RULE = f"strokes recorded - {LEAST_STROKES}, at most {AHEAD}"  # how many strokes ahead errors are measured, in words


def most_ahead(strokes: int) -> int:
    """For how many strokes ahead a string of that many strokes can measure errors."""
    return max(0, min(AHEAD, strokes - LEAST_STROKES))


def too_far(stroke: float, last: float, ahead: int, last_is: str = "the last recorded") -> str:
    """Say that a stroke is further after the last one than the `ahead` strokes for which errors were measured."""
    measured = f"up to {ahead} stroke{'s' * (ahead > 1)} ahead" if ahead else "in recorded strokes only"
    after = f"stroke {stroke:.0f} is {stroke - last:.0f} after {last:.0f}, {last_is}"
    return f"{after}; errors were measured {measured} ({RULE})"


def last_strokes(points: pd.DataFrame) -> dict[str, int]:
    """The last stroke of each string."""
    return {str(string): int(last) for string, last in points.groupby("string")["stroke"].max().items()}


def last_seen(points: pd.DataFrame, strokes: dict[str, int]) -> pd.Series:
    """The last seen stroke of each point's string, NaN where none was seen."""
    return points["string"].astype(str).map(strokes).astype(float)


def parts_of(points: pd.DataFrame) -> list[tuple[pd.DataFrame, pd.DataFrame]]:
    """Pairs of known and predicted points: blocks held out in turn, then last strokes after ever fewer strokes."""
    fold = (points["block"] + points["stroke"]).to_numpy() % FOLDS
    parts = (
        [(points[fold != number], points[fold == number]) for number in sorted(set(fold))] if len(set(fold)) > 1 else []
    )
    strokes = points.groupby("string")["stroke"]
    count = strokes.transform("nunique")
    before_last = count - strokes.rank("dense")
    for ahead in range(1, AHEAD + 1):
        enough = count - ahead >= LEAST_STROKES
        if enough.any():
            parts.append((points[~enough | (before_last >= ahead)], points[enough & (before_last == 0)]))
    return parts
