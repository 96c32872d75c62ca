"""Samples → inputs for a method without physics: motion, its rates, its memory, load, delays."""

import numpy as np
import pandas as pd
from scipy.signal import butter, sosfiltfilt

from ..ground.kinematics import Array

ORDER, RATE_HZ = 4, 20.0  # low-pass, forward and backward, before an encoder's steps are differentiated
MEMORIES = (0.02, 0.1)  # of the range of motion, over which a reversal is felt
DELAYS_S = (0.02, 0.1)


def low_pass(signal: Array, step_s: float, band_hz: float) -> Array:
    """A signal below a frequency, with zero phase; unchanged where its rate is too low to hold more.

    Shape (samples,), in the signal's unit.
    """
    if band_hz * step_s >= 0.45:
        return signal
    sections = butter(ORDER, band_hz, fs=1.0 / step_s, output="sos")
    return np.asarray(sosfiltfilt(sections, signal))


def memory(motion: Array, width: float) -> Array:
    """The direction of the motion so far, between -1 and 1: it takes `width` of travel to go from zero to either end.

    Shape (samples,), without a unit; motion and width in one unit.
    """
    state, remembered = 0.0, np.empty(len(motion))
    for row, step in enumerate(np.diff(motion, prepend=motion[0]).tolist()):
        state = min(1.0, max(-1.0, state + step / width))
        remembered[row] = state
    return remembered


def features(samples: pd.DataFrame, span: float, smoothed: bool = True) -> pd.DataFrame:
    """Columns by name, one row a sample: those of the motion (the second column) and every input beside it.

    The third column, which is to be predicted, is not looked at. `span` is the range of motion, in whose shares memory
    is measured: that of the recording that is learnt from. Unless `smoothed`, the motion is differentiated as it is.
    """
    time_s, motion = samples["time_s"].to_numpy(), samples.iloc[:, 1].to_numpy()
    step_s = float(np.median(np.diff(time_s)))
    smooth = low_pass(motion, step_s, RATE_HZ)
    rate = np.gradient(smooth if smoothed else motion, time_s)
    acceleration = np.gradient(low_pass(rate, step_s, RATE_HZ) if smoothed else rate, time_s)
    columns = {"motion": motion, "rate": rate, "acceleration": acceleration}
    columns |= {f"memory over {share:g} of the range": memory(smooth, share * span) for share in MEMORIES}
    for delay_s in DELAYS_S:
        columns[f"motion less that {delay_s:g} s before"] = motion - np.interp(time_s - delay_s, time_s, motion)
    columns |= {name: samples[name].to_numpy() for name in samples.columns[3:]}
    return pd.DataFrame(columns)


def averaged(table: pd.DataFrame, width: int) -> pd.DataFrame:
    """Means of every `width` rows; the last one may be of fewer."""
    return table.groupby(np.arange(len(table)) // width).mean()


def span_of(samples: pd.DataFrame) -> float:
    """Range of the motion, wild readings left out."""
    return float(np.subtract(*np.percentile(samples.iloc[:, 1], [99.9, 0.1])))
