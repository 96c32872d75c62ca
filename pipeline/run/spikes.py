"""Spikes of a channel: single samples that stand out from neighbours which agree among themselves.

Source: Tukey, Exploratory Data Analysis, 1977 (running medians); Hampel, "The influence curve and its role in robust
estimation", Journal of the American Statistical Association 69, 1974 (the median of distances as their spread). When a
sample is lonely is our own rule.
"""

from collections.abc import Callable

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from ..ground.kinematics import Array, Places
from ..ground.numbers import quantiles
from ..ground.numbers.spans import blocks
from ..ground.stored.rows import Rows, rows_of

SPIKE = 8.0  # spreads of a median filter's residual that make a lonely sample a spike
MEDIAN_SAMPLES = 5  # width of that filter
AGREE = 0.35  # of a sample's distance: neighbours within it agree
RANGE_SHARE = 1e-3  # of a channel's range that counts as spread, where the filter leaves nothing
NOTHING = 1e-6  # of that: a smaller distance is none
HIDDEN = 0.6  # of the step between readings: noise that may hide in it, where the filter leaves nothing
COMMON, SMALL = 0.01, 0.05  # of the samples, which a step moves; of the reading, which a step is
BLOCK = 200_000  # samples that are looked at together
HALF = MEDIAN_SAMPLES // 2


def lonely(signal: Array, least: float) -> NDArray[np.bool_]:
    """Samples that differ by `least` from four neighbours which agree with each other: spikes, not motion.

    The mask and the signal have the shape (samples,); `least` is in the signal's unit.
    """
    return _lonely(np.pad(signal, HALF, mode="reflect"), least)


def _lonely(padded: Array, least: float) -> NDArray[np.bool_]:
    """The mask of lonely samples, for a signal with two more samples on either side."""
    is_lonely = np.zeros(len(padded) - 2 * HALF, np.bool_)
    for start, stop in blocks(0, len(is_lonely), BLOCK):
        part = padded[start + HALF : stop + HALF]
        around = np.vstack([padded[start + k : stop + k] for k in (0, 1, 3, 4)])
        gap = np.abs(part - np.median(around, axis=0))
        is_lonely[start:stop] = (gap > least) & (np.ptp(around, axis=0) < AGREE * gap)
    return is_lonely


def medians(rows: Rows, name: str, first: int, stop: int) -> Array:
    """The median of the samples about each one, from sample `first` until `stop`.

    Shape (stop - first,), in the channel's unit.
    """
    begin = max(first - HALF, 0)
    about = rows.read(name, begin, min(stop + HALF, len(rows)))
    return np.asarray(median_filter(about, MEDIAN_SAMPLES, mode="nearest")[first - begin : stop - begin])


def spikes(rows: Rows, name: str) -> Places:
    """Samples of a channel that are spikes, rising, as indices of shape (spikes,). Read piece by piece."""

    def off(first: int, stop: int) -> Array:
        return np.abs(rows.read(name, first, stop) - medians(rows, name, first, stop))

    at_least = RANGE_SHARE * float(np.subtract(*rows.percentiles(name, [99, 1])))
    # a lonely sample is as far from the median of all five, but for the neighbours' own distances
    far = (1.0 - AGREE) * 0.99 * SPIKE
    if not any((off(*span) > far * at_least).any() for span in rows.spans):
        return np.zeros(0, np.intp)
    usual = 1.4826 * quantiles.median(lambda: (off(*span) for span in rows.spans), len(rows))
    if usual <= NOTHING * at_least:  # most samples read as their neighbours do: what noise there is hides in the steps
        usual = max(usual, _hidden(rows, name, off, NOTHING * at_least) - at_least)
    spread = usual + at_least
    places = [first + np.flatnonzero(_alone(rows, name, first, stop, SPIKE * spread)) for first, stop in rows.spans]
    return np.concatenate(places)


def _hidden(rows: Rows, name: str, off: Callable[[int, int], Array], least: float) -> float:
    """The noise that may hide within the steps of a coarse channel, from its samples' distances `off`; in its unit.

    A sample that stands alone is no step: steps are common, or small beside the reading.
    """
    beyond = [distances[distances > least] for distances in (off(*span) for span in rows.spans)]
    step = min(float(distances.min(initial=np.inf)) for distances in beyond)
    common = sum(map(len, beyond)) >= COMMON * len(rows)
    small = step <= SMALL * float(np.abs(rows.percentiles(name, [1, 99])).max())
    return HIDDEN * step if common or small else 0.0


def _alone(rows: Rows, name: str, first: int, stop: int, least: float) -> NDArray[np.bool_]:
    """The result of `lonely` for the samples from `first` until `stop`, with neighbours outside that range."""
    begin, end = max(first - HALF, 0), min(stop + HALF, len(rows))
    missing = HALF - (first - begin), HALF - (end - stop)
    return _lonely(np.pad(rows.read(name, begin, end), missing, mode="reflect"), least)


def without_spikes(rows: Rows, name: str, places: Places, first: int, stop: int) -> Array:
    """A channel from sample `first` until `stop`, its spikes at `places` replaced by the medians about them.

    Shape (stop - first,), in the channel's unit.
    """
    inside = places[np.searchsorted(places, first) : np.searchsorted(places, stop)]
    values = rows.read(name, first, stop)
    if not len(inside):
        return values
    values = values.copy()
    values[inside - first] = medians(rows, name, first, stop)[inside - first]
    return values


def despiked(signal: Array) -> Array:
    """A channel with its spikes replaced by the medians of the samples about them.

    Shape (samples,), in the channel's unit.
    """
    rows = rows_of(pd.DataFrame({"signal": signal}))
    return without_spikes(rows, "signal", spikes(rows, "signal"), 0, len(rows))
