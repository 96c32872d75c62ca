"""The width of an interval between recorded loads, or between recorded values of other conditions.

A recorded value with others on both sides is left out whole, and a model fitted to the rest is asked about it. Between
recorded values intervals are wider by what those errors have above the usual half width. The points of one value err
together, so each value counts as one error: Student's quantile of so few is taken. Where only two values were recorded,
none can be left out: the interval then reaches over the answers at both of them, with their half widths, and in no case
further. That holds where the answer changes one way from the one value to the other, as contraction does with load.

Source: Roberts et al., "Cross-validation strategies for data with temporal, spatial, hierarchical, or phylogenetic
structure", Ecography 40, 2017 (whole blocks are left out where predictions are asked for between them); Student, "The
probable error of a mean", Biometrika 6, 1908.
"""

from collections.abc import Callable

import numpy as np
import pandas as pd
from scipy import special

from ....ground.kinematics import Array
from ....ground.words.counts import counted
from ....ground.words.progress import steps
from ...interface import Model
from ..inside.recorded_pairs import Paired, pairs_of
from .foreseen import MAPS, foreseen
from .scatter import Scatter, quantile

MOST = 4  # values of a condition that are left out, evenly chosen: each costs a fit


class Between:
    """Measures the errors between recorded values; the fits are made when the first question needs them."""

    def __init__(self, make: Callable[[], Model], points: pd.DataFrame, seed: int) -> None:
        self.make, self.points, self.seed = make, points, seed
        self.pairs = {paired.name: paired for paired in pairs_of(points)}
        self.errors: dict[str, pd.DataFrame] = {}  # by condition, at all values that were left out

    def widened(
        self, model: Model, points: pd.DataFrame, pairs: tuple[Paired, ...], wanted: str, turns: Array, level: float,
        value: Array, half: Array,
    ) -> tuple[Array, Array]:  # fmt: skip
        """The ends of intervals, wider than `half` where a question lies between recorded values.

        Value, half and ends are in the wanted column's unit, twist in turns; all have the shape (points,).
        """
        low, high = value - half, value + half
        for paired in pairs:
            below, above = paired.neighbours(points)
            rows = np.flatnonzero(np.isfinite(below))
            if not len(rows):
                continue
            at_ends = [
                getattr(model, MAPS[wanted])(points.iloc[rows].assign(**{paired.name: end[rows]}))
                for end in (below, above)
            ]
            reach = [np.minimum(*at_ends) - half[rows], np.maximum(*at_ends) + half[rows]]
            if self.left_out(paired):
                least = self._half(paired, wanted, turns[rows], points["direction"].to_numpy()[rows], level)
                beyond = few(len(self.left_out(paired)), level) ** 2 * np.maximum(least**2 - half[rows] ** 2, 0.0)
                least = np.sqrt(half[rows] ** 2 + beyond)
                reach = [np.maximum(reach[0], value[rows] - least), np.minimum(reach[1], value[rows] + least)]
            low[rows], high[rows] = np.minimum(low[rows], reach[0]), np.maximum(high[rows], reach[1])
        return low, high

    def left_out(self, paired: Paired) -> list[tuple[float, float]]:
        """The recorded ranges of a condition that can be left out, since others lie on both sides; in its unit.

        They are those of all strings, also where a question lies between the recorded values of one.
        """
        inner = self.pairs[paired.name].groups()[1:-1]
        return [inner[place] for place in np.unique(np.linspace(0, len(inner) - 1, MOST).astype(int))] if inner else []

    def said(self, paired: Paired) -> str:
        """What an interval between recorded values of a condition is based on."""
        count = len(self.left_out(paired))
        if not count:
            return "the interval reaches over the answers at both"
        return f"the interval is as wide as the errors at {counted(count, 'recorded value')} left out whole"

    def _half(self, paired: Paired, wanted: str, turns: Array, direction: Array, level: float) -> Array:
        """Half widths from the left-out values, in the wanted column's unit; twist in turns; shape (points,)."""
        if paired.name not in self.errors:
            values = self.points[paired.name]
            apart = [values.between(*ends) for ends in self.left_out(paired)]
            tables = [
                foreseen(self.make, self.points[~out], self.points[out], self.seed) for out in steps(apart, "fit")
            ]
            self.errors[paired.name] = pd.concat(tables, ignore_index=True)
        errors = self.errors[paired.name]
        at, way, error = (errors[name].to_numpy() for name in (f"{wanted}_at", "direction", wanted))
        scatter = Scatter.of(at, way, error)
        score = quantile(np.sort(np.abs(error) / scatter.at(at, way)), level)
        return np.asarray(scatter.at(turns, direction) * score)


def few(values: int, level: float) -> float:
    """The factor on an interval from errors at so few values: Student's quantile over the normal one."""
    tail = 0.5 * (1.0 + level)
    return float(special.stdtrit(values, tail) / special.ndtri(tail))
