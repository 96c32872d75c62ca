"""Which strokes count as recorded around a load: those that runs under lower and under higher loads both came near.

A stroke counts where a stroke no later and one no earlier were recorded under this load or a lower one, and also under
this load or a higher one. So between two loads a stroke counts that was recorded under both, or between others so.
What a convex hull has beside that lies between a stroke under a lower load and a far one under a higher load.
A load that came back every few strokes was as near in the strokes around its first and its last one: for a load beside
it, as many more count.

Source: Ottmann, Soisalon-Soininen and Wood, "On the definition and computation of rectilinear convex hulls",
Information Sciences 33, 1984 (no quadrant around a point of the hull is empty).
"""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ....ground.kinematics import Array

BEFORE, NEXT = 0.5, 1.0  # strokes: the one after a recorded one was as good as recorded, the one before it was not


@dataclass(frozen=True)
class Beyond:
    """Strokes that do not count: those earlier, or later, than `stroke`, under loads lower, or higher, than `load_n`.

    A `load_n` that is infinite stands for every load.
    """

    is_later: bool
    stroke: float
    is_higher: bool
    load_n: float


@dataclass(frozen=True)
class StrokesAround:
    """The least and largest stroke that counts, of strokes under a load or lower ones, and under it or higher ones.

    Both in steps: from a load on, rising, what was recorded below is known; down to a load, rising, what was above.
    """

    from_n: Array  # (steps,): loads
    first_below: Array  # (steps,): number of a stroke, without unit
    last_below: Array  # (steps,): number of a stroke, without unit
    to_n: Array  # (steps,): loads
    first_above: Array  # (steps,): number of a stroke, without unit
    last_above: Array  # (steps,): number of a stroke, without unit

    @classmethod
    def of(cls, loads_n: Array, strokes: Array, returns: Array, room_n: float) -> "StrokesAround":
        """Those of recorded pairs of a load in N and a stroke; `returns`: after how many strokes the load came back.

        Each of shape (points,). `room_n` is how far beside a recorded load another one still counts as it.
        """
        by_load = pd.DataFrame({"stroke": strokes, "returns": returns}).groupby(loads_n, sort=True)
        least, most = by_load["stroke"].min().to_numpy(float), by_load["stroke"].max().to_numpy(float)
        values, wide = np.unique(loads_n), by_load["returns"].max().to_numpy(float)
        first = np.concatenate([least - BEFORE, least - np.maximum(BEFORE, wide)])  # at the load, and beside it
        last = np.concatenate([most + NEXT, most + np.maximum(NEXT, wide)])
        from_n, to_n = (np.concatenate([values - side, values + side]) for side in (room_n, -room_n))
        rising, falling = np.argsort(from_n, kind="stable"), np.argsort(-to_n, kind="stable")
        return cls(
            from_n[rising], np.minimum.accumulate(first[rising]), np.maximum.accumulate(last[rising]),
            to_n[falling][::-1], np.minimum.accumulate(first[falling])[::-1],
            np.maximum.accumulate(last[falling])[::-1],
        )  # fmt: skip

    def ends(self, loads_n: Array) -> tuple[Array, Array]:
        """The least and the largest stroke that count under each load in N, each of shape (points,).

        A load beyond the recorded ones has the strokes of the nearest. Where the least is the larger, none counts.
        """
        below = np.maximum(np.searchsorted(self.from_n, loads_n, "right") - 1, 0)
        above = np.minimum(np.searchsorted(self.to_n, loads_n, "left"), len(self.to_n) - 1)
        first = np.maximum(self.first_below[below], self.first_above[above])
        return first, np.minimum(self.last_below[below], self.last_above[above])

    def beyond(self) -> list[Beyond]:
        """All strokes that do not count, the same as by `ends`."""
        beyond = []
        for is_later, below, above in (
            (False, self.first_below, self.first_above),
            (True, self.last_below, self.last_above),
        ):
            beyond.append(Beyond(is_later, float(below[-1]), True, -np.inf))
            for step in np.flatnonzero(np.diff(below)):
                beyond.append(Beyond(is_later, float(below[step]), False, float(self.from_n[step + 1])))
            for step in np.flatnonzero(np.diff(above)):
                beyond.append(Beyond(is_later, float(above[step + 1]), True, float(self.to_n[step])))
        return beyond
