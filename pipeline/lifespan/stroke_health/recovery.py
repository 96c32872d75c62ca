"""A model's error that falls back at a break between two runs: what a string takes back at rest is no wear.

A string that creeps under load is shorter again after a rest, and creeps anew in the next run. So what came back in the
breaks of a string comes back in the next one too, and does not grow from run to run as wear does.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from .at_rest import LAST, LEAST_MM, SURE, scatter
from .indicators import REFERENCE

COLUMN = "model_error_mm"
FIRST = 2  # strokes of a run that tell where it begins: of one a bad stroke would decide
GOOD_SHARE = 1 / 3  # of what had grown in the run before: a break that takes back so much has recovered
CALIBRATED = REFERENCE  # strokes after a break that are like those of the calibration: their error tells no growth
USABLE = 9  # later ones at least that tell
TELLING = 2  # breaks at least that tell recovery from a zero or a chance


@dataclass(frozen=True)
class Break:
    """A break after which run `run` begins with stroke `stroke`, and the model's error before it and after it."""

    run: str
    stroke: int
    before_mm: float
    after_mm: float


@dataclass(frozen=True)
class Recovery:
    """The `breaks` that took a good part of the model's error back, of `count` breaks between compared strokes.

    `since` counts each compared stroke from the run's first stroke
    after such a break, 1 for that one; shape (strokes,).
    """

    breaks: list[Break]
    count: int
    since: Array  # (strokes,), in strokes

    @property
    def is_known(self) -> bool:
        """Whether the breaks tell recovery; a single one may be a chance, or a zero that was read wrongly."""
        return self.is_usual and int((self.since > CALIBRATED).sum()) >= USABLE

    @property
    def is_usual(self) -> bool:
        """Whether several breaks took a part back, and more than half of all."""
        return len(self.breaks) >= TELLING and 2 * len(self.breaks) > self.count

    @property
    def middle_mm(self) -> float:
        """By how much the error fell in those breaks, in the median; NaN where there is none."""
        return float(np.median([each.before_mm - each.after_mm for each in self.breaks])) if self.breaks else np.nan


def recovery(strokes: pd.DataFrame) -> Recovery:
    """The breaks at which a model's error fell back.

    `strokes` has a row a stroke, in order: run, stroke, `model_error_mm` and its `_error`.
    """
    table = strokes.dropna(subset=[COLUMN])
    runs, breaks, since = [part for _, part in table.groupby("run", sort=False)], list[Break](), list[Array]()
    if not runs:
        return NO_BREAK
    errors_mm = table[COLUMN].to_numpy(float)
    noise_mm = float(np.nanmedian(table[f"{COLUMN}_error"]))
    if len(errors_mm) > 1:
        noise_mm = max(noise_mm, scatter(np.diff(errors_mm)) / np.sqrt(2.0))
    begun_mm, first_stroke = 0.0, int(runs[0]["stroke"].iloc[0])
    numbers = runs[0]["stroke"].to_numpy(float)
    since.append(numbers - first_stroke + 1.0)
    for before, after in pairwise(runs):
        before_mm = float(before[COLUMN].iloc[-LAST:].median())
        after_mm = float(after[COLUMN].iloc[:FIRST].mean())
        fell_mm = before_mm - after_mm
        if fell_mm > max(LEAST_MM, SURE * noise_mm, GOOD_SHARE * (before_mm - begun_mm)):
            first_stroke = int(after["stroke"].iloc[0])
            breaks.append(Break(str(after["run"].iloc[0]), first_stroke, before_mm, after_mm))
        begun_mm = after_mm
        since.append(after["stroke"].to_numpy(float) - first_stroke + 1.0)
    return Recovery(breaks, len(runs) - 1, np.concatenate(since))


NO_BREAK = Recovery([], 0, np.zeros(0))  # of strokes that no break parts
