"""Questions under a load that their string was not recorded under, in any stroke or in theirs.

Where each load has strokes of its own, a fit cannot tell what the load does from what the strokes do: what was fitted
to points may be far off there.
"""

import numpy as np
import pandas as pd

from ....ground.kinematics import Mask
from ..box import room
from .recorded_strokes import LOAD
from .strokes_around import BEFORE, NEXT


def at_unrecorded_loads(questions: pd.DataFrame, points: pd.DataFrame) -> Mask:
    """Which questions are further from every load of their string than the loads' room; shape (questions,), no unit.

    `points` are the recorded ones. A string that was not recorded has no such question.
    """
    apart = np.zeros(len(questions), bool)
    room_n = room(LOAD, float(points[LOAD].min()), float(points[LOAD].max()))
    strings = questions["string"].astype(str).to_numpy()
    for string, own in points.groupby(points["string"].astype(str)):
        loads_n = np.unique(own[LOAD].to_numpy(float))
        rows = np.flatnonzero(strings == string)
        asked_n = questions[LOAD].to_numpy(float)[rows]
        place = np.searchsorted(loads_n, asked_n)
        below = np.abs(asked_n - loads_n[np.maximum(place - 1, 0)])
        above = np.abs(asked_n - loads_n[np.minimum(place, len(loads_n) - 1)])
        apart[rows] = np.minimum(below, above) > room_n
    return apart


def in_unrecorded_strokes(questions: pd.DataFrame, points: pd.DataFrame) -> Mask:
    """Which questions are under a load of their string, in a recorded stroke before or after all that had this load.

    Shape (questions,), no unit; `points` are the recorded ones.
    """
    apart = np.zeros(len(questions), bool)
    room_n = room(LOAD, float(points[LOAD].min()), float(points[LOAD].max()))
    strings, conditions = questions["string"].astype(str).to_numpy(), questions[[LOAD, "stroke"]].to_numpy(float)
    for string, own in points.groupby(points["string"].astype(str)):
        loads_n, strokes = own[LOAD].to_numpy(float), own["stroke"].to_numpy(float)
        for row in np.flatnonzero(strings == string):
            load_n, stroke = conditions[row]
            under = strokes[np.abs(loads_n - load_n) <= room_n]
            if len(under) and stroke <= strokes.max():
                apart[row] = not under.min() - BEFORE <= stroke <= under.max() + NEXT
    return apart


def beyond_all_loads(questions: pd.DataFrame, points: pd.DataFrame) -> Mask:
    """Which questions about strings that were not recorded are under a load beyond those of all strings.

    Shape (questions,), no unit; `points` are the recorded ones.
    """
    least_n, most_n = float(points[LOAD].min()), float(points[LOAD].max())
    room_n, asked_n = room(LOAD, least_n, most_n), questions[LOAD].to_numpy(float)
    is_new = ~questions["string"].astype(str).isin(set(points["string"].astype(str))).to_numpy()
    return np.asarray(is_new & ((asked_n < least_n - room_n) | (asked_n > most_n + room_n)))
