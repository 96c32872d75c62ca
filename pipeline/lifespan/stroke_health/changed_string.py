"""Runs that begin as the string itself began: these may be of another string under the same name."""

from itertools import pairwise

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from ...string.rests import LEAST_FLOOR_MM
from .indicators import REFERENCE

YOUNG = ("stroke_mm", "loop_mm")  # both change as a string beds in, and neither depends on the sensor's zero
NEARER = 4.0  # times nearer to the string's first strokes than to those just before
CHANGED = 6.0  # standard errors by which a string must have changed since its first strokes


def runs_anew(strokes: pd.DataFrame) -> list[str]:
    """Names of the runs whose first strokes repeat the string's first ones, far from the end of the run before.

    `strokes` has the columns run, stroke, and each of YOUNG with its `_error`, a row a stroke, in order.
    """
    runs = [part for _, part in strokes.groupby("run", sort=False)]
    first, names = runs[0].iloc[:REFERENCE], list[str]()
    for before, part in pairwise(runs):
        young, old = part.iloc[:REFERENCE], before.iloc[-REFERENCE:]
        if min(len(first), len(young), len(old)) < REFERENCE:
            continue
        away, near = _apart(young, old), _apart(young, first)
        if away > CHANGED and away > NEARER * near:
            names.append(str(part["run"].iloc[0]))
    return names


def _apart(young: pd.DataFrame, other: pd.DataFrame) -> float:
    """Root mean square difference of two times as many strokes in standard errors, NaN where nothing compares."""
    off = np.concatenate([_off(young, other, name) for name in YOUNG])
    return float(np.sqrt(np.nanmean(np.square(off)))) if np.isfinite(off).any() else np.nan


def _off(young: pd.DataFrame, other: pd.DataFrame, name: str) -> Array:
    errors = np.hypot(young[f"{name}_error"].to_numpy(), other[f"{name}_error"].to_numpy())
    errors = np.maximum(errors, LEAST_FLOOR_MM)
    return np.asarray((young[name].to_numpy() - other[name].to_numpy()) / errors)
