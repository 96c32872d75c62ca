"""A change that the stroke does not show: a string that is longer at rest, where the sensor then reads less."""

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from .indicators import REFERENCE

LAST = 3  # strokes that are compared with the first ones
SURE = 3.0  # times the noise, from which a change is said
LEAST_MM = 0.05  # nobody sets out for less


def scatter(changes: Array) -> float:
    """Standard deviation of changes from stroke to stroke, of any unit and shape (strokes - 1,); some may be large."""
    low, high = np.percentile(changes, (25.0, 75.0))
    return float(high - low) / 1.349


def longer_at_rest(strokes: pd.DataFrame) -> str:
    """By how much the string is longer or shorter at rest than at first; empty if that is within the noise.

    `strokes` has `rest_mm`, what the sensor reads at the lowest twist, and `rest_mm_error`, a row each stroke.
    """
    if len(strokes) < REFERENCE + LAST:
        return ""
    rest_mm, error_mm = strokes["rest_mm"].to_numpy(float), strokes["rest_mm_error"].to_numpy(float)
    fell_mm = float(np.median(rest_mm[:REFERENCE]) - np.median(rest_mm[-LAST:]))
    noise_mm = max(float(np.median(error_mm)), scatter(np.diff(rest_mm)) / np.sqrt(2.0))
    if not abs(fell_mm) > max(LEAST_MM, SURE * noise_mm):
        return ""
    return f"but the string is {abs(fell_mm):.2g} mm {'longer' if fell_mm > 0.0 else 'shorter'} at rest"
