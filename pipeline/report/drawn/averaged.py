"""Means along a stroke, so that a drift can be seen in the noise of a sensor."""

from collections.abc import Iterable

import numpy as np
import pandas as pd

from ...ground.kinematics import Array

PARTS = 100  # of the range of a stroke, each with a mean, at most
LEAST_PARTS = 20  # fewer show no drift
SAMPLES = 5  # of a part on average, for a mean to be calmer than a sample


def parts_of(samples: Iterable[int]) -> int:
    """How many parts all strokes of a figure are averaged over, by the number of samples of each.

    Each part holds some samples of the stroke with the fewest; 0 where every stroke is too sparse for means.
    """
    counts = list(samples)
    if max(counts, default=0) < SAMPLES * LEAST_PARTS:
        return 0
    return min(PARTS, max(LEAST_PARTS, min(counts) // SAMPLES))


def averaged(x: pd.Series, values: pd.Series, parts: int = PARTS) -> tuple[Array, Array]:
    """The means of x and of some values over equal parts of the range of x; NaN where no point lies.

    Both in the units that are given, shape (parts,).
    """
    both_there = (x.notna() & values.notna()).to_numpy()
    places, sizes = x.to_numpy()[both_there], values.to_numpy()[both_there]
    means = np.full((2, parts), np.nan)
    if not len(places):
        return means[0], means[1]
    width = np.ptp(places) or 1.0
    part = np.minimum((parts * (places - places.min()) / width).astype(int), parts - 1)
    count = np.bincount(part, minlength=parts)
    for row, numbers in zip(means, (places, sizes), strict=True):
        row[count > 0] = np.bincount(part, numbers, parts)[count > 0] / count[count > 0]
    return means[0], means[1]
