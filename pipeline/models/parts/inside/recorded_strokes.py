"""Which strokes were recorded under which load: of runs one after another under other loads, not every pair is.

A stroke and a load can each lie in their range, and no stroke near was ever recorded under a load near: a string that
was worked under 30 N in strokes 1 to 6 and under 20 N after. So the recorded pairs of load and stroke count with all
that lies between them, their convex hull, as those of load and twist do (`recorded_pairs.py`), and with the strokes
ahead of each string's last one of which errors were measured, under the load of that last one.
A stroke counts under a load only as far as it was wound there: a load that was hung on in the rest at its end makes no
stroke under that load. So there is a hull for each level of the twist, of the pairs that were recorded up to there, or
up to the same share of the largest twist around that load, where the level is not reached.
"""

import math
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ....ground.kinematics import Array
from ..box import room
from ..conditions import Conditions
from .beyond_range import with_unit
from .recorded_pairs import upper

LOAD = "load_n"
BEFORE, NEXT = 0.5, 1.0  # strokes: the one after a recorded one was as good as recorded, the one before it was not
LEVELS = (0.0, 0.125, 0.25, 0.5, 0.75)  # of the largest twist
Corners = tuple[Array, Array]  # below and above, each (corners, 2): load in N, number of the stroke


@dataclass(frozen=True)
class Under:
    """The recorded pairs of load, in N, and stroke, for several depths of winding."""

    values: Array  # (values,): loads, each once, rising; in N
    room: float
    levels: Array  # (levels,): twists in turns, from which on the hull of the same place counts; the first is -inf
    hulls: tuple[Corners, ...]
    last: float  # stroke after which no error was measured under any load: that is said of the stroke alone
    name: str = LOAD
    whose: str = ""  # " of string C", where others were recorded otherwise

    @classmethod
    def of(cls, points: pd.DataFrame, ahead: int, least_room: float = 0.0, whose: str = "") -> "Under | None":
        """The pairs of recorded points, with errors measured up to `ahead` strokes later; None for a single load.

        The room around a load is `least_room`, in N, or more.
        """
        if LOAD not in Conditions.of(points, (LOAD,)).names or not np.isfinite(points[LOAD].to_numpy(float)).all():
            return None
        numbers = {LOAD: float, "stroke": float, "motor_turns": float}
        table = points[["string", *numbers]].astype({**numbers, "string": str})
        last = table[table["stroke"] == table.groupby("string")["stroke"].transform("max")]
        table = pd.concat([table, last.assign(stroke=last["stroke"] + ahead)], ignore_index=True)
        values = np.unique(table[LOAD].to_numpy())
        wide = max(least_room, room(LOAD, float(values[0]), float(values[-1])))
        twists = table["motor_turns"]
        near = np.searchsorted(values[1:][np.diff(values) > 2.0 * wide], table[LOAD].to_numpy(), "right")
        most = twists.groupby(near).transform("max")
        levels: list[float] = []
        hulls: list[Corners] = []
        for share in (-np.inf, *LEVELS):
            level = share * float(twists.max())
            hull = _hull(table[twists >= np.minimum(level, share * most)], wide)
            if not hulls or not all(map(np.array_equal, hull, hulls[-1])):
                levels.append(level)
                hulls.append(hull)
        return cls(values, wide, np.array(levels), tuple(hulls), float(table["stroke"].max()), whose=whose)

    def strokes(self, points: pd.DataFrame, turns: Array) -> tuple[Array, Array]:
        """First and last recorded stroke around each question's load at its twist in turns.

        Each of shape (points,).
        """
        at, level = points[LOAD].to_numpy(float), self._level(turns)
        each = [[np.interp(at, *corners.T) for corners in hull] for hull in self.hulls]
        below, above = np.moveaxis(np.array(each), 0, -1)
        rows = np.arange(len(at))
        return below[rows, level], above[rows, level]

    def never(self, points: pd.DataFrame, turns: Array) -> list[str]:
        """For each question whose stroke was not recorded around its load and twist, a sentence on that; else empty.

        Empty as well where the load is out of its range. Twists in turns, of shape (points,).
        """
        first, last = self.strokes(points, turns)
        loads, strokes = points[LOAD].to_numpy(float), np.minimum(points["stroke"].to_numpy(float), self.last)
        near = (loads >= self.values[0] - self.room) & (loads <= self.values[-1] + self.room)
        level, sentences = self._level(turns), [""] * len(points)
        for row in np.flatnonzero(near & ((strokes < first) | (strokes > last))):
            above = strokes[row] > last[row]
            end = math.floor(last[row] - NEXT) if above else math.ceil(first[row] + BEFORE - 1e-6)
            stroke = f"stroke {points['stroke'].iloc[row]:.0f}{self.whose}"
            what = f"{stroke} was not recorded under {with_unit(LOAD, loads[row])}"
            far = f" as far as {turns[row]:.4g} turns" if level[row] else ""
            sentences[row] = f"{what}{far}: the {'last' if above else 'first'} there is {end}"
        return sentences

    def _level(self, turns: Array) -> np.ndarray:
        """The place of each question's hull, shape (points,), without unit; for a twist that is NaN the first hull."""
        return np.maximum(np.searchsorted(self.levels, np.nan_to_num(turns, nan=-np.inf), "right") - 1, 0)


def _hull(table: pd.DataFrame, wide: float) -> Corners:
    """The hull of the pairs of a table, with loads that extend by `wide` to either side, in N."""
    strokes = table.groupby(LOAD, sort=True)["stroke"]
    least, most = strokes.min(), strokes.max()
    values = least.index.to_numpy(float)
    below = upper(values, wide, BEFORE - least.to_numpy(float)) * (1.0, -1.0)
    return below, upper(values, wide, most.to_numpy(float) + NEXT)
