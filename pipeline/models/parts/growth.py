"""Laws for the change of a string over its strokes, and the choice among them by leaving the last strokes out.

Which law a material follows is not known beforehand, and they part mostly beyond the strokes that were seen: so each is
fitted without the last strokes of every string and judged by how well it foresees them, and by how well it follows all
strokes once it has seen them. By foresight of a stroke or two alone, laws that part soon after are too much alike.

Source: Tashman, "Out-of-sample tests of forecasting accuracy", International Journal of Forecasting 16, 2000.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from ...ground.words.progress import steps

FAMILIES: dict[str, Callable[[Array, float], Array]] = {
    "logarithm": lambda stroke, before: np.log(before + stroke),
    "power": lambda stroke, exponent: stroke**exponent,
    "saturating": lambda stroke, strokes: -np.exp(-stroke / strokes),
}
LEAST_STROKES = 4  # to leave any out
LEFT_OUT = 0.3  # of a string's strokes


@dataclass(frozen=True)
class Law:
    """A law of growth with its one parameter, shifted and scaled to mean 0 and spread 1 over training points."""

    family: str = "logarithm"
    parameter: float = 1.0
    mean: float = 0.0
    std: float = 1.0

    def of(self, stroke: Array) -> Array:
        """Growth at each stroke n ≥ 1, without unit; both of any shape."""
        return (FAMILIES[self.family](np.asarray(stroke, float), self.parameter) - self.mean) / self.std

    def standardised(self, stroke: Array) -> "Law":
        """The law scaled to the strokes of training points; with one stroke only it is 0 there.

        `stroke` counts from 1, shape (points,); the law has no unit.
        """
        raw = FAMILIES[self.family](np.asarray(stroke, float), self.parameter)
        spread = float(raw.std())
        return Law(self.family, self.parameter, float(raw.mean()), spread if spread > 1e-9 else 1.0)


CANDIDATES = (
    *(Law("logarithm", before) for before in (1.0, 0.0, 3.0)),
    *(Law("power", exponent) for exponent in (0.2, 0.35, 0.5, 0.75, 1.0)),
    *(Law("saturating", strokes) for strokes in (0.7, 1.0, 1.5, 2.0, 2.5, 3.0, 3.7, 4.5, 5.5, 7.0)),
)


def early_and_late(points: pd.DataFrame) -> tuple[pd.DataFrame, pd.DataFrame]:
    """The points without and with the last strokes of each string; a string of few strokes counts as early only."""
    strokes = points.groupby("string")["stroke"]
    rank, count = strokes.rank("dense").to_numpy(), strokes.transform("nunique").to_numpy()
    late = (count >= LEAST_STROKES) & (rank > count - np.maximum(np.round(LEFT_OUT * count), 1))
    return points[~late], points[late]


def chosen(points: pd.DataFrame, error_of: Callable[[Law, pd.DataFrame, pd.DataFrame], float]) -> Law:
    """The law with the least squares over early and late strokes together, standardised to the points.

    `error_of(law, known, asked)` fits by a law on known points and returns its root mean square on the asked ones.
    Where no string has enough strokes the first candidate is taken.
    """
    early, late = early_and_late(points)
    every = points["stroke"].to_numpy()
    if late.empty:
        return CANDIDATES[0].standardised(every)
    first = early["stroke"].to_numpy()
    squares = [
        len(late) * error_of(law.standardised(first), early, late) ** 2
        + len(points) * error_of(law.standardised(every), points, points) ** 2
        for law in steps(CANDIDATES, "law of growth")
    ]
    return CANDIDATES[int(np.argmin(squares))].standardised(every)
