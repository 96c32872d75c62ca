"""Intervals: exact ones of a share of counts and of a median, and bootstrap ones of a mean.

Source: Clopper and Pearson, "The use of confidence or fiducial limits illustrated in the case of the binomial",
Biometrika 26, 1934; Efron, "Bootstrap methods: another look at the jackknife", Annals of Statistics 7, 1979.
"""

from collections.abc import Sequence

import numpy as np
from scipy.stats import beta, binom

LEVEL = 0.95


def share(count: int, of: int) -> tuple[float, float]:
    """Clopper and Pearson's 95 % interval of a share; the whole range when nothing was counted."""
    tail = (1.0 - LEVEL) / 2.0
    low = float(beta.ppf(tail, count, of - count + 1)) if count else 0.0
    high = float(beta.ppf(1.0 - tail, count + 1, of - count)) if count < of else 1.0
    return low, high


def median(values: Sequence[float]) -> tuple[float, float]:
    """At least 95 % interval of a median by its order statistics; the extremes when there are too few for that."""
    ordered = np.sort(np.asarray(values, float))
    below = int(binom.ppf((1.0 - LEVEL) / 2.0, len(ordered), 0.5))
    at = max(below - 1, 0)
    return float(ordered[at]), float(ordered[len(ordered) - 1 - at])


def mean(values: Sequence[float]) -> tuple[float, float]:
    """95 % interval of a mean by drawing the values again 4,000 times, the same way each time."""
    drawn = np.random.default_rng(0).choice(np.asarray(values, float), (4000, len(values))).mean(axis=1)
    low, high = np.quantile(drawn, [(1.0 - LEVEL) / 2.0, (1.0 + LEVEL) / 2.0])
    return float(low), float(high)
