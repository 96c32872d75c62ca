"""Means along a stroke, so that a drift can be seen in the noise of a sensor."""

import numpy as np
import pandas as pd

from ...ground.kinematics import Array

PARTS = 100  # of the range of a stroke, each with a mean


def averaged(x: pd.Series, values: pd.Series, parts: int = PARTS) -> tuple[Array, Array]:
    """The means of x and of some values over equal parts of the range of x; NaN where no point lies.

    Both in the units that are given, shape (parts,).
    """
    known = (x.notna() & values.notna()).to_numpy()
    given, sizes = x.to_numpy()[known], values.to_numpy()[known]
    means = np.full((2, parts), np.nan)
    if not len(given):
        return means[0], means[1]
    width = np.ptp(given) or 1.0
    part = np.minimum((parts * (given - given.min()) / width).astype(int), parts - 1)
    count = np.bincount(part, minlength=parts)
    for row, numbers in zip(means, (given, sizes), strict=True):
        row[count > 0] = np.bincount(part, numbers, parts)[count > 0] / count[count > 0]
    return means[0], means[1]
