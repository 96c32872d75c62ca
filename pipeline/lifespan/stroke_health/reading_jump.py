"""A reading that jumps from one stroke to the next and stands still besides: no wear, something slipped.

Wear and creep go on over many strokes; a clamp or a counter slips in one. So a jump is told from them by what is left
of the change when it is taken off.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ...string.zero import LEAST_FLOOR_MM
from .at_rest import LAST, LEAST_MM, scatter
from .indicators import REFERENCE

JUMPING = ("rest_mm", "stroke_mm")  # readings that a slip moves at once
FLOORS = 6.0  # times the noise of the change from stroke to stroke, as for a zero that jumps between two runs
SIDE = 2  # strokes at least before a jump, after it and between two: a bad stroke, or a fast beginning or end, is none
WINDOW = 3  # strokes whose middle is taken: a stroke, the one before and the one after
MOST = 3  # jumps at most: what jumps more often is how the string wears
LEFT = 0.5  # of the jumps at most may be left of the change when they are taken off


@dataclass(frozen=True)
class Step:
    """By how much a reading jumped after stroke `stroke` of the string, in run `run`, and how many times its noise."""

    run: str
    stroke: int
    moved_mm: float
    floors: float


def steps(strokes: pd.DataFrame, name: str) -> list[Step]:
    """Jumps of the reading `name`, in mm, if they are most of its change; else none.

    `strokes` has a row a stroke, in order: run, stroke, the reading and its `_error`. A jump lies between two strokes
    of one run that follow each other: between others the string did what nobody compares.
    """
    table = strokes.dropna(subset=[name])
    if len(table) < REFERENCE + LAST:
        return []
    values, errors = table[name].to_numpy(float), table[f"{name}_error"].to_numpy(float)
    level = _without_bad_strokes(values)
    changes = np.diff(level)
    usual, floor = float(np.median(changes)), max(scatter(np.diff(values)), float(np.sqrt(2.0) * np.nanmedian(errors)))
    large = (np.abs(changes - usual) > FLOORS * floor) & (np.abs(changes) > LEAST_MM) & _beside(table)
    places = np.flatnonzero(large)
    if not 0 < len(places) <= MOST or any(after - before < SIDE for before, after in pairwise(places)):
        return []
    rest = np.where(large, 0.0, changes)
    if np.ptp(np.concatenate([[0.0], np.cumsum(rest)])) > LEFT * np.abs(changes[places]).sum():
        return []
    moved = [(int(at), _moved_mm(values, int(at))) for at in places]
    runs, numbers, floor = table["run"].tolist(), table["stroke"].tolist(), max(floor, LEAST_FLOOR_MM)
    return [Step(str(runs[at]), int(numbers[at]), change_mm, abs(change_mm) / floor) for at, change_mm in moved]


def _moved_mm(values: Array, at: int) -> float:
    """How far readings of shape (strokes,), in mm, moved after the stroke at place `at`: three against three."""
    before, after = values[max(at + 1 - WINDOW, 0) : at + 1], values[at + 1 : at + 1 + WINDOW]
    return float(np.median(after) - np.median(before))


def _without_bad_strokes(values: Array) -> Array:
    """The middle of each stroke and its two neighbours, shape (strokes,), in mm: a jump stays, a bad stroke goes."""
    wide = np.concatenate([values[:1], values, values[-1:]])
    return np.asarray(np.median(np.lib.stride_tricks.sliding_window_view(wide, WINDOW), axis=1))


def _beside(table: pd.DataFrame) -> NDArray[np.bool_]:
    """Whether a stroke and the next follow each other in one run, SIDE strokes from both ends; (strokes - 1,)."""
    run, number = table["run"].to_numpy(), table["stroke"].to_numpy(float)
    beside = (run[1:] == run[:-1]) & (np.diff(number) == 1.0)
    beside[: SIDE - 1] = beside[-(SIDE - 1) :] = False
    return np.asarray(beside)
