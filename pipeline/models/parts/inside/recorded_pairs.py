"""Which twists were recorded at which load, or at which value of another condition.

Two numbers can each lie in their range, and nothing near the two together was ever recorded: a load that was wound
only half as far. So the recorded pairs of a condition and the twist count with all that lies between them, their
convex hull, and with the room that each range has (`box.py`). A value that is further than its room from every
recorded one is interpolated: it is answered, and said.

Source: King and Zeng, "The dangers of extreme counterfactuals", Political Analysis 14, 2006 (the convex hull parts
interpolation from extrapolation); Andrew, "Another efficient algorithm for convex hulls in two dimensions",
Information Processing Letters 9, 1979.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ....ground.kinematics import Array
from ....ground.units import unit_of
from ..box import room
from ..conditions import Conditions
from .beyond_range import WORDS, also, inward, with_unit


@dataclass(frozen=True)
class Paired:
    """The recorded pairs of one condition, in its column's unit, and the twist in turns."""

    name: str
    values: Array  # (values,): of the condition, each once, rising; in its unit
    room: float
    corners: tuple[Array, Array]  # below and above, each (corners, 2): the condition in its unit, twist in turns
    whose: str = ""  # " of string C", where others were recorded otherwise

    @classmethod
    def of(cls, points: pd.DataFrame, name: str, least_room: float = 0.0) -> "Paired":
        """The pairs of recorded points, with a room of `least_room` or more, in the condition's unit."""
        turns = points["motor_turns"].groupby(points[name].astype(float), sort=True)
        least, most = turns.min(), turns.max()
        values = least.index.to_numpy(float)
        wide, turns_wide = (room(of, float(low), float(high)) for of, low, high in (
            (name, values[0], values[-1]), ("motor_turns", least.min(), most.max())))  # fmt: skip
        wide = max(wide, least_room)
        below = upper(values, wide, turns_wide - least.to_numpy(float)) * (1.0, -1.0)
        return cls(name, values, wide, (below, upper(values, wide, most.to_numpy(float) + turns_wide)))

    def turns(self, points: pd.DataFrame) -> tuple[Array, Array]:
        """Least and largest recorded twist around each question's value, in turns; each of shape (points,)."""
        at = points[self.name].to_numpy(float)
        below, above = (np.interp(at, *corners.T) for corners in self.corners)
        return below, above

    def groups(self) -> list[tuple[float, float]]:
        """The recorded values in groups with gaps wider than their room; the least and most of each, in its unit."""
        parted = np.split(self.values, 1 + np.flatnonzero(np.diff(self.values) > 2.0 * self.room))
        return [(float(near[0]), float(near[-1])) for near in parted]

    def neighbours(self, points: pd.DataFrame) -> tuple[Array, Array]:
        """The recorded values below and above a question's value, if it is near neither; else NaN.

        In the condition's unit, each of shape (points,).
        """
        at = points[self.name].to_numpy(float)
        ends, place = np.full((2, len(points)), np.nan), np.searchsorted(self.values, at)
        rows = np.flatnonzero((place > 0) & (place < len(self.values)))
        around = np.array([self.values[place[rows] - 1], self.values[place[rows]]])
        far = np.minimum(at[rows] - around[0], around[1] - at[rows]) > self.room
        ends[:, rows[far]] = around[:, far]
        return ends[0], ends[1]

    def gaps(self, points: pd.DataFrame) -> list[str]:
        """For each question with a value between recorded ones, and near none, these; else an empty text."""
        unit = unit_of(self.name)
        sentences = [""] * len(points)
        for row, (below, above) in enumerate(zip(*self.neighbours(points), strict=True)):
            if np.isfinite(below):
                ends = f"{below:.4g} and {above:.4g}{'' if unit == '1' else f' {unit}'}"
                what = f"no {WORDS.get(self.name, self.name)} between {ends} was recorded{self.whose}"
                sentences[row] = f"{what}, so no error was measured there"
        return sentences

    def never(self, points: pd.DataFrame, turns: Array) -> list[str]:
        """For each question whose twist was not recorded around its value of the condition, a sentence on that.

        Empty for the others, and for one whose condition is out of its range. Twists in turns, of shape (points,).
        """
        least, most = self.turns(points)
        values = points[self.name].to_numpy(float)
        near = (values >= self.values[0] - self.room) & (values <= self.values[-1] + self.room)
        sentences = [""] * len(points)
        for row in np.flatnonzero(near & ((turns < least) | (turns > most))):
            above = turns[row] > most[row]
            limit = inward(float(most[row] if above else least[row]), up=not above)
            side, end = ("above", "most") if above else ("below", "least")
            around = with_unit(self.name, values[row])
            most_is = f"the {end} recorded{self.whose} around {around}"
            sentences[row] = f"twist {turns[row]:.4g} turns is {side} {limit:g}, {most_is}"
        return sentences


def pairs_of(points: pd.DataFrame, rooms: Mapping[str, float] | None = None) -> tuple[Paired, ...]:
    """The recorded pairs of each condition that differs among recorded points.

    With `rooms`, in each condition's unit, only those of these conditions, each with so much room or more.
    """
    names = [name for name in Conditions.of(points).names if np.isfinite(points[name].to_numpy(float)).all()]
    if rooms is None:
        return tuple(Paired.of(points, name) for name in names)
    return tuple(Paired.of(points, name, rooms[name]) for name in names if name in rooms)


def turns_at(pairs: tuple[Paired, ...], points: pd.DataFrame, turns: tuple[float, float]) -> tuple[Array, Array]:
    """The range of twists at each question's conditions, within an overall one, in turns; each of shape (points,)."""
    low, high = (np.full(len(points), end) for end in turns)
    for paired in pairs:
        least, most = paired.turns(points)
        low, high = np.maximum(low, least), np.minimum(high, most)
    return low, np.maximum(low, high)


def around(pairs: tuple[Paired, ...], points: pd.DataFrame, ends: Array) -> list[str]:
    """For each question the conditions, in words, that limit its twists in turns to the end given; ends: (points,)."""
    words = [""] * len(points)
    for paired in pairs:
        least, most = paired.turns(points)
        for row in np.flatnonzero(np.isclose(ends, least) | np.isclose(ends, most)):
            words[row] = also(words[row], with_unit(paired.name, float(points[paired.name].iloc[row])), " and ")
    return words


def upper(values: Array, wide: float, heights: Array) -> Array:
    """Corners of the upper hull, shape (corners, 2), of heights over values that extend by `wide` to either side.

    Values and heights have the shape (values,), each in its own unit, which the corners have as well.
    """
    over = pd.Series(np.tile(heights, 2), np.concatenate([values - wide, values + wide])).groupby(level=0).max()
    corners: list[tuple[float, float]] = []
    for x, y in zip(over.index.to_numpy(float), over.to_numpy(float), strict=True):
        while len(corners) > 1 and _is_under(corners[-2], corners[-1], (x, y)):
            corners.pop()
        corners.append((x, y))
    return np.array(corners)


def _is_under(first: tuple[float, float], middle: tuple[float, float], last: tuple[float, float]) -> NDArray[np.bool_]:
    """Whether the middle corner lies on or under the line between the two others."""
    rise = (middle[1] - first[1]) * (last[0] - first[0])
    return np.asarray(rise <= (last[1] - first[1]) * (middle[0] - first[0]))
