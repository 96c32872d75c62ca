"""Which strokes were recorded under which load: of runs that follow each other under other loads, not every pair.

A stroke and a load can each lie in their range, and no stroke near was ever recorded under a load near: a string that
was worked under 30 N in strokes 1 to 6 and under 20 N after. So the recorded pairs of load and stroke count with all
that lies between them, their convex hull, as those of load and twist do (`recorded_pairs.py`), and with the strokes
ahead of each string's last one of which errors were measured, under the load of that last one.
"""

import math
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from .beyond import with_unit
from .box import room
from .conditions import Conditions
from .recorded_pairs import upper

LOAD = "load_n"
NEAR = 1.0  # strokes: one next to a recorded one was as good as recorded


@dataclass(frozen=True)
class Under:
    """The recorded pairs of load, in N, and stroke."""

    values: Array  # (values,): loads, each once, rising; in N
    room: float
    corners: tuple[Array, Array]  # below and above, each (corners, 2): load in N, number of the stroke
    last: float  # stroke after which no error was measured under any load: that is said of the stroke alone
    name: str = LOAD

    @classmethod
    def of(cls, points: pd.DataFrame, ahead: int) -> "Under | None":
        """The pairs of recorded points, of which errors were measured so many strokes ahead; None of one load alone."""
        if LOAD not in Conditions.of(points, (LOAD,)).names or not np.isfinite(points[LOAD].to_numpy(float)).all():
            return None
        table = points[["string", LOAD, "stroke"]].astype({LOAD: float, "stroke": float, "string": str})
        last = table[table["stroke"] == table.groupby("string")["stroke"].transform("max")]
        later = last.assign(stroke=last["stroke"] + ahead)
        strokes = pd.concat([table, later], ignore_index=True).groupby(LOAD, sort=True)["stroke"]
        least, most = strokes.min(), strokes.max()
        values = least.index.to_numpy(float)
        wide = room(LOAD, float(values[0]), float(values[-1]))
        below = upper(values, wide, NEAR - least.to_numpy(float)) * (1.0, -1.0)
        above = upper(values, wide, most.to_numpy(float) + NEAR)
        return cls(values, wide, (below, above), float(most.max()))

    def strokes(self, points: pd.DataFrame) -> tuple[Array, Array]:
        """First and last stroke around each question's load, with what is near; each of shape (points,)."""
        at = points[LOAD].to_numpy(float)
        below, above = (np.interp(at, *corners.T) for corners in self.corners)
        return below, above

    def never(self, points: pd.DataFrame) -> list[str]:
        """Of each question whose stroke was not recorded around its load, that it was not; else empty.

        Empty as well where the load is out of its range.
        """
        first, last = self.strokes(points)
        loads, strokes = points[LOAD].to_numpy(float), np.minimum(points["stroke"].to_numpy(float), self.last)
        near = (loads >= self.values[0] - self.room) & (loads <= self.values[-1] + self.room)
        sentences = [""] * len(points)
        for row in np.flatnonzero(near & ((strokes < first) | (strokes > last))):
            above = strokes[row] > last[row]
            end = math.floor(last[row] - NEAR) if above else math.ceil(first[row] + NEAR)
            what = f"no stroke near {points['stroke'].iloc[row]:.0f} was recorded under {with_unit(LOAD, loads[row])}"
            sentences[row] = f"{what}: the {'last' if above else 'first'} there is {end}"
        return sentences
