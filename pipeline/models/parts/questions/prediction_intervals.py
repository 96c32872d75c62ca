"""Prediction intervals, forward and inverse, from a model's errors on last strokes that it had not seen.

Conformal in kind: no law of the errors is assumed. The model is fitted without the last strokes, then without fewer,
and each time asked about those that follow (rolling origin). Errors are counted in units of the local scatter, which
depends on twist and direction, and the quantiles of these scores are the intervals' half widths. Strokes that were seen
get the scores of blocks held out inside strokes, strokes ahead those of as many strokes ahead. The model that is asked
knows more than those that were tried: what their errors have above the noise is taken to fall with the points, and
ahead with the square of the strokes. Between recorded loads an interval is wider (`between.py`), and so is
one in a recorded stroke that errs more than others (`stroke_errors.py`). A point outside the
model's box, at a twist that was not recorded around its load (`recorded_pairs.py`), or farther ahead than could be
tried, gets no interval: low and high are infinite and it is flagged. So does one whose stroke was not recorded around
its load as far as its twist (`recorded_strokes.py`), and a contraction that lies beyond all recorded ones with its
whole interval.

Source: Vovk, Gammerman and Shafer, Algorithmic Learning in a Random World, 2005 (conformal prediction); Tashman, "Out-
of-sample tests of forecasting accuracy", International Journal of Forecasting 16, 2000 (rolling origin).
"""

from collections.abc import Callable
from copy import copy

import numpy as np
import pandas as pd

from ....ground.kinematics import Array, Mask
from ....ground.words.progress import steps
from ...interface import Model
from ..box import Box
from ..inside.measure import measures
from ..inside.recorded_pairs import Paired, turns_at
from ..rolling_origin import FOLDS, last_seen, last_strokes, parts_of
from .between import Between
from .foreseen import GIVEN, foreseen
from .reached_contraction import brought
from .scatter import Scatter, quantile
from .stroke_errors import StrokeErrors, after_break, by_stroke, errs_more, fitted_scores, groups


class TooFew(ValueError):
    """Raised for too few points to learn a model's errors from."""


class Intervals:
    """A fitted model with its error statistics; `make` returns an unfitted model of its kind."""

    def __init__(self, make: Callable[[], Model]) -> None:
        self.make = make

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Fit the model on all points, and on parts of them to measure its errors on the rest.

        Raises TooFew where the points are all of one block.
        """
        parts = parts_of(points)
        if not parts:
            raise TooFew("are all of one block, so nothing can be foreseen from the rest")
        self.model = self.make()
        self.between = Between(self.make, points, seed)
        self.strokes, error_tables = last_strokes(points), []
        for part in steps([None, *parts], "fit"):
            if part is None:
                self.model.fit(points, seed)
            else:
                error_tables.append(foreseen(self.make, *part, seed))
        errors = pd.concat(error_tables, ignore_index=True)
        count = int(points.groupby("string")["stroke"].nunique().max())
        self.scatter: dict[str, Scatter] = {}
        self.scores: dict[str, dict[int, Array]] = {}
        self.stroke_errors: dict[str, StrokeErrors] = {}
        self.after_break = after_break(points)
        for wanted in GIVEN:
            seen = errors[errors["ahead"] == 0]
            columns = (seen[f"{wanted}_at"].to_numpy(), seen["direction"].to_numpy(), seen[wanted].to_numpy())
            self.scatter[wanted] = Scatter.of(*columns)
            # a fit of p weights to N points errs by noise (1 - p/N) on them and by noise (1 + p/N) on others
            inner, outer = float(np.mean(seen[f"{wanted}_fitted"])), float(np.mean(seen[wanted] ** 2))
            noise = min(2.0 * inner * outer / (inner + outer), outer)
            self.scores[wanted] = {}
            for ahead, rows in errors.groupby("ahead", sort=True):
                size = self.scatter[wanted].at(rows[f"{wanted}_at"].to_numpy(), rows["direction"].to_numpy())
                square = float(np.mean(rows[wanted] ** 2))
                above = max(square - noise, 0.0)
                less = (1.0 - 1.0 / FOLDS) if ahead == 0 else (1.0 - float(ahead) / count) ** 2
                shrunk = np.sqrt((square - above * (1.0 - less)) / square)
                scores = np.abs(rows[wanted].to_numpy()) / size * shrunk
                self.scores[wanted][int(ahead)] = np.sort(scores)
                if ahead == 0:
                    fitted = by_stroke(points, fitted_scores(self.model, self.scatter[wanted], points, wanted))
                    self.stroke_errors[wanted] = StrokeErrors(by_stroke(rows, scores), fitted)

        self.measures = measures(points, self.ahead("displacement_mm"))
        self.measure = self.measures[""]

    def of_string(self, string: str) -> "Intervals":
        """The same, with what is inside measured by the recordings of a string; of all, if it has none."""
        measured = copy(self)
        measured.measure = self.measures.get(string, self.measures[""])
        return measured

    @property
    def box(self) -> Box:
        """The recorded ranges that are the measure."""
        return self.measure.box

    @property
    def pairs(self) -> tuple[Paired, ...]:
        """The recorded pairs of conditions and twist that are the measure."""
        return self.measure.pairs

    def forward(self, points: pd.DataFrame, level: float) -> pd.DataFrame:
        """Contraction in mm with an interval that holds it with probability `level`: value, low, high, inside."""
        return self._predicted(points, "displacement_mm", level)

    def inverse(self, points: pd.DataFrame, level: float) -> pd.DataFrame:
        """Twist in turns with an interval that holds it with probability `level`: value, low, high, inside."""
        return self._predicted(points, "motor_turns", level)

    def quantile(self, wanted: str, ahead: int, level: float) -> float:
        """Half width, in units of the scatter, so many strokes ahead of those seen; infinite where never measured."""
        width_by_ahead = {n: quantile(values, level) for n, values in self.scores[wanted].items() if len(values)}
        numbers = sorted(width_by_ahead)
        if ahead > numbers[-1]:
            return float("inf")
        return float(np.interp(ahead, numbers, np.maximum.accumulate([width_by_ahead[n] for n in numbers])))

    def why_wider(self, points: pd.DataFrame, wanted: str, level: float) -> list[str]:
        """That a question's stroke errs more than others, and how much wider its interval is; empty where it is not."""
        factors = self._factors(points, wanted, level).tolist()
        return [
            errs_more(group, factor, group[:2] in self.after_break)
            for group, factor in zip(groups(points), factors, strict=True)
        ]

    def outside(self, points: pd.DataFrame, wanted: str, turns: Array) -> dict[str, Mask]:
        """Which questions lie outside the recorded range, by the column at fault: masks of shape (points,).

        `pairs` are those whose twist was not recorded around their load, or what else differs, `under` those whose
        stroke was not, as far as their twist in turns, which was asked with or answered; of shape (points,).
        """
        last, stroke = self.last_recorded(points), points["stroke"].to_numpy()
        far = (stroke - last.to_numpy() > self.ahead(wanted)) | (stroke < self.box.low["stroke"])
        wrong = self.box.outside(points, GIVEN[wanted]) | {"stroke": far, "string": last.isna().to_numpy()}
        if wanted == "displacement_mm":
            low, high = self.turns(points)
            wrong["pairs"] = (turns < low) | (turns > high)
        if under := self.measure.under:
            wrong["under"] = np.array([bool(reason) for reason in under.never(points, turns)])
        return {name: np.asarray(mask, bool) for name, mask in wrong.items() if mask.any()}

    def turns(self, points: pd.DataFrame) -> tuple[Array, Array]:
        """The range of recorded twists around each question's conditions, with its room, in turns; shape (points,)."""
        return turns_at(self.pairs, points, (self.box.low["motor_turns"], self.box.high["motor_turns"]))

    def brought(self, points: pd.DataFrame, level: float) -> tuple[Array, Mask]:
        """Twists in turns, within the recorded ones, and which are held at an end; each of shape (points,).

        Held is one whose contraction is further from the asked one than the interval of the level.
        """
        ends = self.turns(points)
        return brought(self.model, points, ends, lambda at: self._half(points, "displacement_mm", at, level))

    def last_recorded(self, points: pd.DataFrame) -> pd.Series:
        """The last recorded stroke of each question's string, NaN where none was; of shape (points,)."""
        return last_seen(points, self.strokes)

    def ahead(self, wanted: str) -> int:
        """For how many strokes after the last recorded one there is an interval."""
        return max(number for number, values in self.scores[wanted].items() if len(values))

    def _predicted(self, points: pd.DataFrame, wanted: str, level: float) -> pd.DataFrame:
        if wanted == "displacement_mm":
            value, wrong = self.model.forward(points), np.zeros(len(points), bool)
            turns = points["motor_turns"].to_numpy(float)
        else:
            value, wrong = self.brought(points, level)
            turns = value
        half = self._half(points, wanted, turns, level)
        low, high = self.between.widened(self.model, points, self.pairs, wanted, turns, level, value, half)
        if wanted == "displacement_mm":  # further than recorded by more than the interval
            wrong = (low > self.box.high[wanted]) | (high < self.box.low[wanted])
        inside = np.isfinite(half) & ~np.any([wrong, *self.outside(points, wanted, turns).values()], axis=0)
        low, high = np.where(inside, low, -np.inf), np.where(inside, high, np.inf)
        return pd.DataFrame({"value": value, "low": low, "high": high, "inside": inside})

    def _half(self, points: pd.DataFrame, wanted: str, turns: Array, level: float) -> Array:
        """Half widths at twists in turns, in the wanted column's unit; each of shape (points,)."""
        last = self.last_recorded(points)
        ahead, place = np.unique(np.maximum(points["stroke"] - last, 0).fillna(0).to_numpy(int), return_inverse=True)
        size = self.scatter[wanted].at(turns, points["direction"].to_numpy())
        size = size * self._factors(points, wanted, level)
        return np.asarray(size * np.array([self.quantile(wanted, int(n), level) for n in ahead])[place])

    def _factors(self, points: pd.DataFrame, wanted: str, level: float) -> Array:
        """How many times as wide an interval is for its stroke; of shape (points,), without unit."""
        return self.stroke_errors[wanted].factors(points, self.quantile(wanted, 0, level), level)
