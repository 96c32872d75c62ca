"""Which strokes were recorded under which load: of runs one after another under other loads, not every pair is.

A stroke and a load can each lie in their range, and no stroke near was ever recorded under a load near: a string that
was worked under 30 N in strokes 1 to 6 and under 20 N after. So a stroke counts where runs under lower and under higher
loads both came near it (`strokes_around.py`), and so do the strokes ahead of each string's last one of which errors
were measured, under the load of that last one.
A stroke counts under a load only as far as it was wound there: a load that was hung on in the rest at its end makes no
stroke under that load. So the strokes around a load are known for each level of the twist, of the pairs that were
recorded up to there, or up to the same share of the largest twist around that load, where the level is not reached.
"""

import math
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ....ground.kinematics import Array
from ..box import room
from ..conditions import Conditions
from .beyond_range import with_unit
from .strokes_around import NEXT, StrokesAround

LOAD = "load_n"
LEVELS = (0.0, 0.125, 0.25, 0.5, 0.75)  # of the largest twist


@dataclass(frozen=True)
class Under:
    """The recorded pairs of load, in N, and stroke, for several depths of winding."""

    values: Array  # (values,): loads, each once, rising; in N
    room: float
    levels: Array  # (levels,): twists in turns, from which on the strokes of the same place count; the first is -inf
    around: tuple[StrokesAround, ...]
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
        values = np.unique(table[LOAD].to_numpy())
        wide = max(least_room, room(LOAD, float(values[0]), float(values[-1])))
        table["near"] = np.searchsorted(values[1:][np.diff(values) > 2.0 * wide], table[LOAD].to_numpy(), "right")
        table["returns"] = table.groupby("near")["stroke"].transform(_returns)
        last = table[table["stroke"] == table.groupby("string")["stroke"].transform("max")]
        table = pd.concat([table, last.assign(stroke=last["stroke"] + ahead)], ignore_index=True)
        twists = table["motor_turns"]
        most = twists.groupby(table["near"]).transform("max")
        levels: list[float] = []
        around: list[StrokesAround] = []
        for share in (-np.inf, *LEVELS):
            level = share * float(twists.max())
            deep = table[twists >= np.minimum(level, share * most)]
            loads_n, numbered, returns = (deep[name].to_numpy() for name in (LOAD, "stroke", "returns"))
            strokes = StrokesAround.of(loads_n, numbered, returns, wide)
            if not around or strokes.beyond() != around[-1].beyond():
                levels.append(level)
                around.append(strokes)
        return cls(values, wide, np.array(levels), tuple(around), float(table["stroke"].max()), whose=whose)

    def strokes(self, points: pd.DataFrame, turns: Array) -> tuple[Array, Array]:
        """First and last stroke that count around each question's load at its twist in turns.

        Each of shape (points,). Where the first is the later one, none counts.
        """
        at, level = points[LOAD].to_numpy(float), self._level(turns)
        first, last = np.array([strokes.ends(at) for strokes in self.around])[level, :, np.arange(len(at))].T
        return first, last

    def never(self, points: pd.DataFrame, turns: Array) -> list[str]:
        """For each question whose stroke was not recorded around its load and twist, a sentence on that; else empty.

        Empty as well where the load is out of its range. Twists in turns, of shape (points,).
        """
        first, last = self.strokes(points, turns)
        loads, strokes = points[LOAD].to_numpy(float), np.minimum(points["stroke"].to_numpy(float), self.last)
        near = (loads >= self.values[0] - self.room) & (loads <= self.values[-1] + self.room)
        level, sentences = self._level(turns), [""] * len(points)
        for row in np.flatnonzero(near & ((strokes < first) | (strokes > last))):
            load = with_unit(LOAD, loads[row])
            is_between = np.abs(self.values - loads[row]).min() > self.room
            where = f"both below and above {load}" if is_between else f"under {load}"
            far = f" as far as {turns[row]:.4g} turns" if level[row] else ""
            above = strokes[row] > last[row]
            end = math.floor(last[row] - NEXT * (not is_between)) if above else math.ceil(first[row] - 1e-6)
            which = f"the {'last' if above else 'first'} stroke {'near both' if is_between else 'there'} is {end}"
            which = which if first[row] <= last[row] else "no stroke is near both"
            stroke = f"stroke {points['stroke'].iloc[row]:.0f}{self.whose}"
            sentences[row] = f"{stroke} was not recorded {where}{far}: {which}"
        return sentences

    def _level(self, turns: Array) -> np.ndarray:
        """The place of each question's strokes, shape (points,), without unit; for a twist that is NaN the first."""
        return np.maximum(np.searchsorted(self.levels, np.nan_to_num(turns, nan=-np.inf), "right") - 1, 0)


def _returns(strokes: pd.Series) -> float:
    """After how many strokes a load usually came back; 0 for a load of one stroke."""
    return float(np.median(np.diff(np.unique(strokes)))) if strokes.nunique() > 1 else 0.0
