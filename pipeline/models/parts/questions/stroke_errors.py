"""Recorded strokes that err more than others, such as the first after a break, and how much wider their intervals are.

Intervals come from the errors of all recorded strokes together. A stroke of which clearly fewer left-out points lie in
them than the level says, winding or unwinding, has an interval of its own errors. Clearly is what an exact binomial
test says of all strokes and both directions together (Bonferroni), and what makes the interval wider by a tenth. It
must be so of the model that is asked, too: one that has seen all points may fit a stroke that the others missed.

Source: Vovk, "Conditional validity of inductive conformal predictors", Proceedings of Machine Learning Research 25,
2012 (each group has the quantile of its own scores); Clopper and Pearson, "The use of confidence or fiducial limits
illustrated in the case of the binomial", Biometrika 26, 1934.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pandas as pd
from scipy import special

from ....ground.kinematics import Array
from ...interface import Model
from ..inside.measure import WAYS
from .foreseen import MAPS
from .scatter import Scatter, quantile

Group = tuple[str, float, float]  # string, stroke, direction
CHANCE = 0.01  # that any stroke of strokes that err alike is taken to err more
CLEAR = 1.1  # the least factor that is worth a word


@dataclass(frozen=True)
class StrokeErrors:
    """Sorted scores of one map by string, stroke and direction: errors in units of the scatter.

    `unseen` are those on left-out points, `asked` those of the model that is asked, on the points of its fit.
    """

    unseen: Mapping[Group, Array]  # each (points,), without unit
    asked: Mapping[Group, Array]  # each (points,), without unit

    def factors(self, points: pd.DataFrame, width: float, level: float) -> Array:
        """How many times as wide the interval of each question is; of shape (points,), without unit, 1 where usual.

        `width` is the usual half width in units of the scatter.
        """
        each = groups(points)
        factor_by_group = {group: self._factor(group, width, level) for group in set(each)}
        return np.array([factor_by_group[group] for group in each])

    def _factor(self, group: Group, width: float, level: float) -> float:
        unseen = self.unseen.get(group)
        if unseen is None or np.ceil(level * (len(unseen) + 1)) > len(unseen):  # too few for a quantile of their own
            return 1.0
        factor = quantile(unseen, level) / width
        is_clear = factor >= CLEAR and all(
            self._is_short(scores, width, level) for scores in (unseen, self.asked[group])
        )
        return factor if is_clear else 1.0

    def _is_short(self, scores: Array, width: float, level: float) -> bool:
        """Whether fewer of the scores than the level says are within a width, and not by chance.

        Scores have the shape (scores,), without unit.
        """
        within = int(np.searchsorted(scores, width, side="right"))
        return bool(special.bdtr(within, len(scores), level) < CHANCE / len(self.unseen))


def fitted_scores(model: Model, scatter: Scatter, points: pd.DataFrame, wanted: str) -> Array:
    """Errors of a model on the points that it was fitted to, in units of the scatter; of shape (points,)."""
    value = getattr(model, MAPS[wanted])(points)
    turns = value if wanted == "motor_turns" else points["motor_turns"].to_numpy(float)
    return np.asarray(
        np.abs(value - points[wanted].to_numpy(float)) / scatter.at(turns, points["direction"].to_numpy())
    )


def by_stroke(points: pd.DataFrame, scores: Array) -> dict[Group, Array]:
    """Sorted scores, of shape (points,) and without unit, by the stroke of each point."""
    scores_by_group: dict[Group, list[float]] = {}
    for group, score in zip(groups(points), scores.tolist(), strict=True):
        scores_by_group.setdefault(group, []).append(score)
    return {group: np.sort(own) for group, own in scores_by_group.items()}


def groups(points: pd.DataFrame) -> list[Group]:
    """The string, the stroke and the direction of each point."""
    columns = points["string"].astype(str), points["stroke"].astype(float), points["direction"].astype(float)
    return list(zip(*columns, strict=True))


def after_break(points: pd.DataFrame) -> set[tuple[str, float]]:
    """The first stroke of each run of a string but its first run, with the string."""
    first = points.groupby([points["string"].astype(str), "run"])["stroke"].min()
    is_later = first > first.groupby(level=0).transform("min")
    return {(string, float(stroke)) for (string, _), stroke in first[is_later].items()}


def errs_more(group: Group, factor: float, is_after_break: bool) -> str:
    """Say that a stroke errs more than others, by the factor on its interval; empty where the factor is 1."""
    if factor == 1.0:
        return ""
    _, stroke, direction = group
    first = ", the first after a break," if is_after_break else ""
    more = f"stroke {stroke:.0f}{first} errs more {WAYS[direction]} than others"
    return f"{more}: its interval is {factor:.2g} times as wide"
