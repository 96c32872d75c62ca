"""The frequency band in which a residual is stated: faster changes are filtered out."""

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array

ORDER = 4  # order of the filter that takes off faster changes
HIGHEST = 0.9  # of the Nyquist frequency: a band up to a higher frequency needs no filter


def within(signals: Array, first: NDArray[np.intp], step_s: float, band_hz: float | None) -> Array:
    """Signals along the last axis through a Butterworth low-pass, forward and backward, each run by itself.

    `first[i]` is the number of samples since the start of the run; without `band_hz` nothing changes.
    Shape (..., samples), in the signals' unit.
    """
    if band_hz is None or band_hz * step_s >= HIGHEST / 2.0:
        return signals
    from scipy.signal import butter, sosfiltfilt  # a second to import, and few systems state a band

    sections = butter(ORDER, band_hz, fs=1.0 / step_s, output="sos")
    out = np.array(signals, dtype=float)
    starts = np.flatnonzero(first == 0)
    for start, end in zip(starts, [*starts[1:], len(first)], strict=True):
        out[..., start:end] = sosfiltfilt(sections, signals[..., start:end], axis=-1)
    return out


def words(band_hz: float | None, step_s: float) -> str:
    """The filter, as a page states it."""
    if band_hz is None or band_hz * step_s >= HIGHEST / 2.0:
        return "nothing more"
    return f"Butterworth low-pass of order {ORDER} at {band_hz:g} Hz, forward and backward"
