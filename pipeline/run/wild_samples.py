"""Lonely samples that no rig can have read: found by their neighbours, left out, and said."""

from pathlib import Path

import numpy as np
import pandas as pd
from scipy.ndimage import median_filter

from ..ground.errors import BadInput
from .description import Run

BESIDE = 5  # neighbours on either side, by whose median a sample is judged
RANGES = 3.0  # of the channel's whole range: a sample further from its neighbours was never measured
INSIDE = (0.5, 99.5)  # percentiles of that range
MOST = 0.01  # of a recording's samples, and one in any case: what is wild more often is no accident
LEAST_LOAD = 1.0  # in the load's unit: noise about a load of 0 is no range


def _wild(values: np.ndarray, is_load: bool) -> tuple[np.ndarray, np.ndarray]:
    """Which values stand alone and impossibly far, and what their neighbours read; both of shape (samples,)."""
    others = np.ones(2 * BESIDE + 1, bool)
    others[BESIDE] = False
    beside = median_filter(values, footprint=others, mode="mirror")
    low, high = np.percentile(beside, INSIDE)
    with np.errstate(over="ignore"):
        size = float(np.median(np.abs(beside)))
        reach = max(high - low, size, LEAST_LOAD) if is_load else (high - low) or size or 1.0
        return np.abs(values - beside) > RANGES * reach, beside


def without_wild(run: Run, samples: pd.DataFrame, path: Path) -> tuple[pd.DataFrame, list[str]]:
    """Finite samples of a run without those that motion, reading or load make impossible; a sentence a channel.

    An ordinary outlier stays: a sample goes only where its value is further from its neighbours' median than three
    times the channel's whole range (of a load: or its size). Raises BadInput where that is over 1 % of all samples.
    """
    gone, notes = np.zeros(len(samples), bool), []
    for name in (run.system.driver, run.system.channel, run.system.load):
        if name is None or name not in samples.columns:
            continue
        values = samples[name].to_numpy()
        wild, beside = _wild(values, name == run.system.load)
        count = int(wild.sum())
        if not count:
            continue
        row = int(np.argmax(wild))
        reads = f"{name} reads {values[row]:.3g} in row {row + 1}, where its neighbours read {beside[row]:.3g}"
        gone |= wild
        if gone.sum() > max(1, MOST * len(samples)):
            problem = f"{int(gone.sum())} of {len(samples)} samples are impossible, over 1 %: {reads}"
            raise BadInput(
                path, name, problem, "check the sensor and its cable, then remove these rows or record again"
            )
        notes.append(f"{path}: {count} sample{'s' * (count > 1)} left out: {reads}")
    return (samples[~gone].reset_index(drop=True) if notes else samples), notes
