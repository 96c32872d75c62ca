"""A mismatch over the course of a recording: its change with time, from stroke to stroke, and during rests.

Source: Björck, Numerical Methods for Least Squares Problems, 1996 (the slope of a straight line).
"""

import numpy as np

from ...ground.kinematics import Array
from .mismatch import LOW, MIDDLE, TOP, Mismatch, follows

EARLY = 0.03  # of the duration: added to the time before the logarithm is taken
NEAR = 0.1  # of the range of motion, from the end of a stroke
LEAST_STROKE, LEAST_REST = 10, 8  # samples
STEADY = 0.05  # of the mean load: a rest with a load that varies more does not count
END = 5  # the parts of a rest, of which the first is compared with the last


def time(mismatch: Mismatch) -> dict[str, float]:
    """How far the remainder moves with time and with its logarithm, at the bottom, in the middle and at the top."""
    remainder, late = mismatch.remainder, np.log(mismatch.course + EARLY)
    parts = {name: mismatch.within(part) for name, part in (("low", LOW), ("middle", MIDDLE), ("top", TOP))}
    return {
        **{f"time_{name}": follows(remainder, mismatch.course, where) for name, where in parts.items()},
        **{f"early_{name}": follows(remainder, late, where) for name, where in parts.items()},
        "time_all": follows(mismatch.smooth, mismatch.course, np.ones(len(late), bool)),
    }


def strokes(mismatch: Mismatch) -> dict[str, float]:
    """At the bottom and the top of the strokes: the trend, the largest step, its share of all steps, the first step."""
    ends = []
    for number in range(1, int(mismatch.stroke.max()) + 1):
        rows = np.flatnonzero(mismatch.stroke == number)
        if len(rows) < LEAST_STROKE:
            continue
        place, value = mismatch.place[rows], mismatch.smooth[rows]
        bottom, top = place <= place.min() + NEAR, place >= place.max() - NEAR
        ends.append([np.mean(value[bottom]), np.mean(value[top]), np.mean(mismatch.course[rows])])
    table = np.array(ends) if ends else np.zeros((1, 3))
    bottoms, tops = _steps(table[:, 0], table[:, 2]), _steps(table[:, 1], table[:, 2])
    sign_by_name = {f"{name}_bottom": value for name, value in bottoms.items()}
    sign_by_name |= {f"{name}_top": value for name, value in tops.items()}
    return sign_by_name | {"trend_apart": tops["trend"] - bottoms["trend"]}


def _steps(values: Array, course: Array) -> dict[str, float]:
    steps = np.diff(values) if len(values) > 1 else np.zeros(1)
    largest = int(np.argmax(np.abs(steps)))
    return {
        "trend": float(np.polyfit(course, values, 1)[0]) if len(values) > 2 else 0.0,
        "step": float(steps[largest]),
        "sudden": float(np.abs(steps[largest]) / (np.sum(np.abs(steps)) + 1e-3)),
        "first": float(steps[0]),
    }


def rests(mismatch: Mismatch) -> dict[str, float]:
    """How far the mismatch moves while the rig rests under one load, above and below the middle: medians."""
    resting = np.diff(np.concatenate([[0], (mismatch.way == 0).astype(int), [0]]))
    moved: dict[bool, list[float]] = {True: [], False: []}
    for begin, end in zip(np.flatnonzero(resting == 1), np.flatnonzero(resting == -1), strict=True):
        if end - begin < LEAST_REST or np.std(mismatch.heavier[begin:end]) > STEADY:
            continue
        part, value = max(2, int(end - begin) // END), mismatch.smooth[begin:end]
        above = bool(np.mean(mismatch.place[begin:end]) > 0.5)
        moved[above].append(float(np.mean(value[len(value) - part :]) - np.mean(value[:part])))
    return {
        f"rest_{name}": float(np.median(moved[above])) if moved[above] else 0.0
        for name, above in (("top", True), ("bottom", False))
    }
