"""Samples → strokes: where the motor winds, holds, unwinds and rests, with the number of the stroke.

A stroke is a winding and the unwinding after it. Reversals of at least a quarter of the run's twist range part
windings from unwindings; smaller ones stay inside the stroke. What lies before the first winding is stroke 0. Samples
are read piece by piece; what is kept goes by how often the motor turns and stands.
"""

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.errors import BadInput
from ..ground.kinematics import Array, Places
from ..ground.numbers import quantiles, spans
from ..ground.numbers.spans import Spans
from ..ground.numbers.unwound import PHASE_REVERSAL
from ..ground.stored import schemas
from ..ground.stored.rows import Rows, rows_of
from ..ground.units import unit_of
from .clean_motion import Motion
from .standstills import stands
from .turning import turning_points

STROKE_REVERSAL = 0.25  # of the range: what parts a winding from an unwinding
REST_BAND = 0.05  # of the range, above the lowest twist: a hold there is a rest
LEAST_RANGE = {"turns": 0.1, "deg": 1.0, "m": 1e-3}  # of the motion, by its unit: less is no stroke

Phases = NDArray[np.object_]


def _after_stands(points: Places, holding: Spans, reach: int, length: int) -> Places:
    """Turning points moved to the end of a stand, if they lie in it or within `reach` samples of it.

    The motor turns anywhere in a stand as far as the twist tells: what moves before it belongs to the leg before.
    """
    moved = points.copy()
    for first, last in holding.tolist():
        begin, end = np.searchsorted(points, [first - reach, last + reach])
        moved[begin:end] = last
    return np.minimum(moved, length - 1)


def _changes(stroke: Places, phase: Phases) -> NDArray[np.bool_]:
    """Places where another stroke or phase begins, including the first place; shape (places,)."""
    return np.append(True, (np.diff(stroke) != 0) | (phase[1:] != phase[:-1]))[: len(stroke)]


def _stretches(motion: Motion) -> tuple[Places, Places, Phases]:
    """First sample, stroke and phase of each stretch of one phase of one stroke; all of shape (stretches,)."""
    low, high = quantiles.percentiles(motion.pieces, motion.length, [0.1, 99.9])
    span = float(high - low)
    strokes, legs = (turning_points(motion.pieces(), share * span) for share in (STROKE_REVERSAL, PHASE_REVERSAL))
    holding = stands(motion, legs, span)
    strokes, legs = (_after_stands(points, holding, motion.reach, motion.length) for points in (strokes, legs))
    legs[0], legs[-1] = 0, motion.length - 1

    def resting(first: int, stop: int) -> Array:
        return np.asarray(motion.smooth(first, stop) <= low + REST_BAND * span, float)

    # one stand, one name: noise at the edge of the band must not cut it
    rests = spans.reduced(resting, holding, schemas.ROW_GROUP, np.add, 0.0) / np.diff(holding)[:, 0] > 0.5
    up, rises = (np.diff(motion.smooth_at(points)) > 0 for points in (legs, strokes))
    first = np.unique(np.concatenate([legs[:-1], holding.ravel()]))  # where a stroke turns a leg does too
    first = first[first < motion.length]
    stroke = np.searchsorted(strokes[:-1][rises], first, side="right")
    phase = np.where(up[np.searchsorted(legs[:-1], first, side="right") - 1], "winding", "unwinding").astype(object)
    ends = np.searchsorted(holding.ravel(), first, side="right")  # of stands, up to each: an odd number within one
    is_hold = (ends % 2).astype(bool)
    phase[is_hold] = np.where(rests[ends[is_hold] // 2], "rest", "hold")
    change = _changes(stroke, phase)
    return first[change], stroke[change], phase[change]


def label(time_s: Array, motion: Array) -> tuple[Places, Phases]:
    """Stroke and phase of every sample; both of shape (samples,).

    `motion` is the driver (motor_turns, motor_deg or position_m). The phase is winding, hold, unwinding or rest. Time
    in s, motion in the driver's unit; strokes count from 1.
    """
    first, stroke, phase = _stretches(Motion(rows_of(pd.DataFrame({"time_s": time_s, "motion": motion})), "motion"))
    times = np.diff(first, append=len(motion))
    return np.repeat(stroke, times), np.repeat(phase, times)


def of_samples(strokes: pd.DataFrame) -> tuple[Places, Phases]:
    """Stroke and phase of every sample, as in `label`, from the strokes that `segment` made.

    The number of its stroke is a count, its phase a word; both of shape (samples,).
    """
    times = (strokes["last_sample"] - strokes["first_sample"] + 1).to_numpy()
    return np.repeat(strokes["stroke"].to_numpy(np.intp), times), np.repeat(strokes["phase"].to_numpy(), times)


def stretches(stroke: Places, phase: Phases) -> pd.DataFrame:
    """The strokes of samples with known stroke and phase: the inverse of `of_samples`.

    The number of a sample's stroke is a count, its phase a word; both of shape (samples,). One row for each stretch,
    with the columns of `schemas.STROKES` that need no motion.
    """
    first = np.flatnonzero(_changes(stroke, phase))
    last = np.append(first, len(stroke))[1:] - 1
    return pd.DataFrame({"stroke": stroke[first], "phase": phase[first], "first_sample": first, "last_sample": last})


def segment(samples: pd.DataFrame | Rows, driver: str, where: Path | str) -> pd.DataFrame:
    """Strokes of a run, one row for each stretch of one phase of one stroke; columns of `schemas.STROKES`.

    Raises BadInput when the recording holds no stroke.
    """
    rows = rows_of(samples)
    motion = Motion(rows, driver)
    reach = float(np.subtract(*rows.percentiles(driver, [99.9, 0.1])))
    first, stroke, phase = _stretches(motion)
    if reach < LEAST_RANGE.get(unit_of(driver), 0.0) or not (phase[stroke > 0] == "winding").any():
        least, most = rows.extremes(driver)
        problem = f"there is no stroke in it: from {least:.3g} to {most:.3g} it never winds up"
        mend = "record at least one winding; is the column the motor's, and its unit right?"
        raise BadInput(where, driver, problem, mend)

    def missing(begin: int, stop: int) -> Array:
        return np.maximum(np.rint(motion.steps_s(begin, stop) / motion.step_s) - 1, 0)

    last = np.append(first[1:], len(rows)) - 1
    gone = spans.reduced(missing, np.column_stack([first, last + 1]), schemas.ROW_GROUP, np.add, 0.0)
    unwound = set(stroke[phase == "unwinding"])
    return pd.DataFrame(
        {
            "stroke": stroke,
            "phase": phase,
            "first_sample": first,
            "last_sample": last,
            "start_s": rows.at("time_s", first),
            "end_s": rows.at("time_s", last),
            "start_turns": rows.at(driver, first),
            "end_turns": rows.at(driver, last),
            "missing_samples": gone.astype(int),
            "complete": [number in unwound for number in stroke],
        }
    )
