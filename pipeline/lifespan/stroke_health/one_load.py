"""Which of a string's strokes are compared: those under one load, since another load changes the length.

It is the load that has the most strokes, of several with as many the one that was met last. Loads are alike within the
part by which two rests' loads may differ (`string/recovered.py`), or within half of what they vary inside a stroke.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ...ground.words.counts import counted
from ...string.recovered import SAME_LOAD
from .readings import Found

LEAST_N = 0.1  # loads this near count as one: a load cell under no load reads so much
NAMED = 3  # other loads that are named each


@dataclass(frozen=True)
class Loads:
    """The load in N under which strokes are compared, their numbers, and the strokes of each other load."""

    load_n: float = float("nan")
    kept: list[int] = field(default_factory=list)
    others: list[tuple[float, list[int]]] = field(default_factory=list)

    @property
    def under(self) -> str:
        """The load in words if there were others; empty if there was only one."""
        return f" under {newtons(self.load_n)}" if self.others else ""

    @property
    def count_left_out(self) -> int:
        """How many strokes of other loads are left out."""
        return sum(len(numbers) for _, numbers in self.others)

    @property
    def left_out(self) -> str:
        """The strokes of other loads, which are left out, and why these and not those that are compared."""
        most = max(len(numbers) for _, numbers in self.others)
        why = "the most" if len(self.kept) > most else "as many as the most, and later"
        taken = f"{newtons(self.load_n)} has {why} ({counted(len(self.kept), 'stroke')})"
        return f"Left out: {self._named()}. A change of load is no ageing; {taken}."

    def _named(self) -> str:
        if len(self.others) > NAMED:
            ends = [load for load, _ in self.others]
            return f"{counted(self.count_left_out, 'stroke')} under {min(ends):.3g} to {newtons(max(ends))}"
        named = (
            f"{counted(len(numbers), 'stroke')} under {newtons(load)} ({spans(numbers)})"
            for load, numbers in self.others
        )
        return ", ".join(named)


def of_one_load(strokes: list[Found]) -> tuple[list[Found], Loads]:
    """The strokes under the load with most strokes, and the remark on the others."""
    loads, spreads = (np.array(column) for column in zip(*(place.load_n for place in strokes), strict=True))
    spare, rest, groups = 0.5 * float(np.median(spreads)), np.arange(len(strokes)), list[NDArray[np.intp]]()
    while len(rest):
        groups.append(rest[_most(loads[rest], spare)])
        rest = np.setdiff1d(rest, groups[-1])
    numbers = [[strokes[at].number for at in group] for group in groups]
    others = sorted((float(np.median(loads[group])), every) for group, every in zip(groups, numbers, strict=True))
    load_n = float(np.median(loads[groups[0]]))
    kept = [strokes[at] for at in groups[0]]
    if len(groups) == 1:
        return kept, Loads(load_n, numbers[0])
    others = [(load, every) for load, every in others if every != numbers[0]]
    return [place.under(load_n) for place in kept], Loads(load_n, numbers[0], others)


def newtons(load_n: float) -> str:
    """A load in words."""
    return f"{load_n:.3g} N"


def _most(loads: Array, spare: float) -> NDArray[np.bool_]:
    """The largest group of similar loads; of equal groups the later one; loads in N, of shape (strokes,), in order."""
    each = [
        (loads >= least) & (loads <= max(least / (1.0 - SAME_LOAD), least + LEAST_N, least + spare)) for least in loads
    ]
    return max(each, key=lambda alike: (alike.sum(), np.flatnonzero(alike)[-1]))


def spans(numbers: Sequence[int]) -> str:
    """Numbers of strokes, those that follow each other from where to where."""
    parts = np.split(np.array(numbers), 1 + np.flatnonzero(np.diff(numbers) != 1))
    return ", ".join(f"{part[0]} to {part[-1]}" if len(part) > 1 else f"{part[0]}" for part in parts)
