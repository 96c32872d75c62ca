"""The segmentation once more, with a mark for every sample of a recording that is held whole: what pieces must give.

A stroke is a winding and the unwinding after it. Reversals of at least a quarter of the run's twist range part
windings from unwindings; smaller ones stay inside the stroke. What lies before the first winding is stroke 0.
"""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from pipeline.ground.errors import BadInput
from pipeline.ground.kinematics import Array
from pipeline.ground.units import unit_of

STROKE_REVERSAL = 0.25  # of the range: what parts a winding from an unwinding
PHASE_REVERSAL = 0.02  # of the range: what counts as moving the other way within a stroke
REST_BAND = 0.05  # of the range, above the lowest twist: a hold there is a rest
HOLD_SPEED = 0.10  # of the speed at which the motor does half its travel: slower is holding
HOLD_LEAST_S = 0.25
SPEED_WINDOW_S = 0.2
OUTLIER_SAMPLES = 5  # width of the median that keeps outliers of the motor channel out
LEAST_RANGE = {"turns": 0.1, "deg": 1.0, "m": 1e-3}  # of the motion, by its unit: less is no stroke

Indices = NDArray[np.intp]
Phases = NDArray[np.object_]


def turning_points(motion: Array, reversal: float) -> Indices:
    """Samples at which a motion turns by at least `reversal`, and its first and last sample; shape (points,).

    Motion and `reversal` in one unit, motion of shape (samples,).
    """
    step = np.diff(motion)
    moving = np.flatnonzero(step)
    turns = moving[1:][np.diff(np.sign(step[moving])) != 0]  # local extremes: nothing else can be a turning point
    points: list[int] = []
    low = high = 0
    direction = 0  # of the leg under way: +1 up, -1 down, 0 not known yet
    for index in (*turns.tolist(), len(motion) - 1):
        if direction >= 0 and motion[index] > motion[high]:
            high = index
        if direction <= 0 and motion[index] < motion[low]:
            low = index
        if direction >= 0 and motion[high] - motion[index] >= reversal:
            points.append(high)
            direction, low = -1, index
        elif direction <= 0 and motion[index] - motion[low] >= reversal:
            points.append(low)
            direction, high = 1, index
    last = len(motion) - 1
    if not points:
        return np.array([0, last])
    points[0] = 0  # what comes before the first point is less than a reversal: it belongs to the first leg
    return np.unique([0, *points, last])


def _runs_of(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and one-past-last index of every stretch of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _half_window(time_s: Array) -> int:
    """Samples on either side over which the speed is taken."""
    return max(1, round(SPEED_WINDOW_S / 2 / float(np.median(np.diff(time_s)))))


def _holds(time_s: Array, motion: Array, legs: Indices, span: float) -> NDArray[np.bool_]:
    """Where the motor stands: slower than a share of its leg's own speed, for long enough."""
    half = _half_window(time_s)
    ahead = np.minimum(np.arange(len(motion)) + half, len(motion) - 1)
    behind = np.maximum(np.arange(len(motion)) - half, 0)
    speed = np.abs(motion[ahead] - motion[behind]) / (time_s[ahead] - time_s[behind])
    slow = np.zeros(len(motion), bool)
    for first, last in pairwise(legs):
        leg = slice(first, last + 1)
        order = np.sort(speed[leg])
        travel = np.cumsum(order)  # samples are near enough equally spaced: speed weighs as travel does
        usual = order[np.searchsorted(travel, travel[-1] / 2)]
        slow[leg] = speed[leg] < HOLD_SPEED * usual
    still = slow.copy()  # jitter while holding is no motion
    for first, last in _runs_of(~slow):
        beside = first > 0 or last < len(slow)
        if beside and np.ptp(motion[first:last]) < PHASE_REVERSAL * span / 2:
            still[first:last] = True
    step = np.diff(motion, append=motion[-1])
    for first, last in pairwise(legs):  # but a leg that is made of such steps moves all the same
        absorbed = (still & ~slow)[first:last]
        if abs(step[first:last][absorbed].sum()) < abs(motion[last] - motion[first]) / 2:
            slow[first:last] = still[first:last]
    for first, last in _runs_of(slow):
        if time_s[last - 1] - time_s[first] < HOLD_LEAST_S:
            slow[first:last] = False
    return slow


def _after_stands(points: Indices, holding: NDArray[np.bool_], reach: int) -> Indices:
    """Turning points moved to the end of the stand that they lie in, or within `reach` samples of.

    The motor turns anywhere in a stand as far as the twist tells: what moves before it belongs to the leg before.
    """
    moved = points.copy()
    for first, last in _runs_of(holding):
        moved[(points >= first - reach) & (points < last + reach)] = last
    return np.clip(moved, 0, len(holding) - 1)


def despiked_whole(signal: Array) -> Array:
    """A channel without its spikes; shape (samples,), in the channel's unit."""
    middle = median_filter(signal, 5, mode="nearest")
    off, share = np.abs(signal - middle), 1e-3 * float(np.subtract(*np.percentile(signal, [99, 1])))
    spread = 1.4826 * float(np.median(off)) + share
    moved = off[off > 1e-6 * share]
    if spread - share <= 1e-6 * share and len(moved):  # noise that is finer than the steps of a sensor
        size = np.abs(np.percentile(signal, [1, 99])).max()
        if len(moved) >= 0.01 * len(signal) or moved.min() <= 0.05 * size:
            spread = max(spread, 0.6 * moved.min())
    padded = np.pad(signal, 2, mode="reflect")
    around = np.vstack([padded[k : k + len(signal)] for k in (0, 1, 3, 4)])
    gap = np.abs(signal - np.median(around, axis=0))
    lonely = (gap > 8.0 * spread) & (np.ptp(around, axis=0) < 0.35 * gap)
    return np.where(lonely, middle, signal)


def label(time_s: Array, motion: Array) -> tuple[Indices, Phases]:
    """Stroke and phase of every sample; both of shape (samples,).

    `motion` is the driver (motor_turns, motor_deg or position_m). The phase is winding, hold, unwinding or rest. Time
    in s, motion in the driver's unit; strokes count from 1.
    """
    smooth = median_filter(despiked_whole(motion), OUTLIER_SAMPLES, mode="nearest")
    low, high = np.percentile(smooth, [0.1, 99.9])
    span = float(high - low)
    strokes, legs = (turning_points(smooth, share * span) for share in (STROKE_REVERSAL, PHASE_REVERSAL))
    holding = _holds(time_s, smooth, legs, span)
    strokes, legs = (_after_stands(points, holding, _half_window(time_s)) for points in (strokes, legs))
    legs[0], legs[-1] = 0, len(motion) - 1
    resting = holding & (smooth <= low + REST_BAND * span)

    phase = np.empty(len(motion), object)
    for first, last in pairwise(legs):
        phase[first : last + 1] = "winding" if smooth[last] > smooth[first] else "unwinding"
    phase[holding] = "hold"
    for first, last in _runs_of(holding):  # one stand, one name: noise at the edge of the band must not cut it
        if resting[first:last].mean() > 0.5:
            phase[first:last] = "rest"

    stroke = np.zeros(len(motion), np.intp)
    for first, last in pairwise(strokes):
        if smooth[last] > smooth[first]:
            stroke[first:] += 1
    return stroke, phase


def segment(samples: pd.DataFrame, driver: str, where: Path | str) -> pd.DataFrame:
    """Strokes of a run, one row for each stretch of one phase of one stroke; columns of `schemas.STROKES`.

    Raises BadInput when the recording holds no stroke.
    """
    time_s, motion = samples["time_s"].to_numpy(), samples[driver].to_numpy()
    reach = float(np.subtract(*np.percentile(motion, [99.9, 0.1])))
    stroke, phase = label(time_s, motion)
    if reach < LEAST_RANGE.get(unit_of(driver), 0.0) or not (phase[stroke > 0] == "winding").any():
        problem = f"there is no stroke in it: from {motion.min():.3g} to {motion.max():.3g} it never winds up"
        mend = "record at least one winding; is the column the motor's, and its unit right?"
        raise BadInput(where, driver, problem, mend)
    change = (np.diff(stroke) != 0) | (phase[1:] != phase[:-1])
    first = np.concatenate([[0], np.flatnonzero(change) + 1])
    last = np.concatenate([first[1:] - 1, [len(stroke) - 1]])
    step_s = np.diff(time_s, append=time_s[-1])
    missing = np.maximum(np.rint(step_s / np.median(step_s[:-1])) - 1, 0)
    unwound = set(stroke[phase == "unwinding"])
    return pd.DataFrame(
        {
            "stroke": stroke[first],
            "phase": phase[first],
            "first_sample": first,
            "last_sample": last,
            "start_s": time_s[first],
            "end_s": time_s[last],
            "start_turns": motion[first],
            "end_turns": motion[last],
            "missing_samples": [int(missing[a : b + 1].sum()) for a, b in zip(first, last, strict=True)],
            "complete": [number in unwound for number in stroke[first]],
        }
    )
