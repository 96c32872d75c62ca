"""What a diagnosis works on: the samples of its runs, joined, cleared of spikes, averaged to a working rate.

Source: Hampel, "The influence curve and its role in robust estimation", Journal of the American Statistical Association
69, 1974 (the median of distances as their spread).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from ...ground.kinematics import Array
from ...run.spikes import despiked
from ...run.strokes import of_samples
from ...systems import System
from .recorded_run import RecordedRun

WORKING_SAMPLES, DRIVES_SAMPLES = 8_000, 15_000  # of a string's recordings; of a drive's, whose ringing is faster
BETWEEN_RUNS_S = 60.0  # between the end of a run and the begin of the next, diagnosed together
FINER = 10.0  # times the working rate, at which a motion is differentiated
OUTLIER, LOCAL = 6.0, 8.0  # spreads of a residual, of all and of its neighbours, that make a reading wild
PHASES = ("winding", "hold", "unwinding", "rest")


@dataclass(frozen=True)
class Record:
    """Inputs and the measured channel, each of shape (samples,); `samples` maps them to the recording's rows."""

    time_s: Array
    motion: Array  # in the driver's unit: turns, degrees or metres
    velocity: Array  # of the motion, taken at the recording's own rate, in the driver's unit a second
    acceleration: Array  # in the driver's unit a second squared
    measured: Array  # in the channel's unit
    load: Array  # in the unit of the system's load channel; zeros where there is none
    temperature_c: Array | None
    current_a: Array | None
    stroke: NDArray[np.intp]  # its number, a count
    phase: NDArray[np.intp]  # its place, as places in PHASES
    run_index: NDArray[np.intp]  # which run, as indices from 0

    def __len__(self) -> int:
        return len(self.time_s)


def wild(residual: Array) -> tuple[NDArray[np.bool_], Array]:
    """Samples of a residual that lie far from neighbours which agree among themselves, and how far each lies.

    Both of shape (samples,), the distance in the residual's unit.
    """
    gap = residual - median_filter(residual, 7, mode="nearest")
    spread = 1.4826 * float(np.median(np.abs(gap)))
    usual = median_filter(np.abs(gap), 9, mode="nearest")
    quiet = usual < np.maximum(2.5 * spread, np.abs(gap) / LOCAL)
    return (np.abs(gap) > OUTLIER * spread) & quiet, gap


def _bins(time_s: Array, width: int) -> NDArray[np.intp]:
    """Bin of each sample: `width` median steps of time; bins without samples do not exist."""
    step_s = float(np.median(np.diff(time_s)))
    return np.unique(
        np.floor((time_s - time_s[0]) / (width * step_s) + 0.5 / width).astype(np.intp), return_inverse=True
    )[1]


def means(time_s: Array, signal: Array, width: int) -> Array:
    """Means of a signal over `width` samples, as a record takes them.

    Time in s; shape (means,), in the signal's unit.
    """
    bins = _bins(time_s, width) if width > 1 else np.arange(len(time_s))
    return np.asarray(np.bincount(bins, weights=signal) / np.bincount(bins))


def of_run(recorded: RecordedRun, width: int, index: int, stroke0: int) -> Record:
    """The record of one run, averaged over `width` samples; strokes are numbered on from `stroke0`."""
    system, samples = recorded.run.system, recorded.samples
    time_s, turned = samples["time_s"].to_numpy(), samples[system.driver].to_numpy()
    motion = despiked(turned)
    stroke, phase = of_samples(recorded.strokes)
    phase_index = np.array([PHASES.index(name) for name in phase])
    nothing = pd.Series(np.zeros(len(samples)))
    load = despiked(samples.get(system.load, nothing).to_numpy())
    velocity, acceleration = derivatives(time_s, motion, system.working_hz if system.differentiates else None)
    bins = _bins(time_s, width) if width > 1 else np.arange(len(time_s))
    count = np.bincount(bins)

    def mean(values: Array) -> Array:
        return np.bincount(bins, weights=values) / count

    last = np.concatenate([np.flatnonzero(np.diff(bins)), [len(bins) - 1]])
    middle = last - (count - 1) // 2
    measured = samples[system.channel].to_numpy()
    if width > 1:
        measured = despiked(measured)

    def optional(name: str) -> Array | None:
        is_there = name in samples and name not in (system.driver, system.channel, system.load)
        return mean(despiked(samples[name].to_numpy())) if is_there else None

    return Record(
        mean(time_s), mean(motion), mean(velocity), mean(acceleration), mean(measured), mean(load),
        optional("temperature_c"), optional("motor_current_a"),
        stroke[middle] + stroke0, phase_index[middle], np.full(len(count), index, np.intp),
    )  # fmt: skip


def derivatives(time_s: Array, motion: Array, working_hz: float | None) -> tuple[Array, Array]:
    """Rate and acceleration of a motion, of means over a tenth of a working period: finer only differentiates steps.

    Each of shape (samples,), per s and per s²; time in s.
    """
    step_s = float(np.median(np.diff(time_s)))
    width = max(1, round(1.0 / (FINER * working_hz * step_s))) if working_hz else 1
    if width == 1:
        velocity = np.gradient(motion, time_s)
        return velocity, np.gradient(velocity, time_s)
    bins = _bins(time_s, width)
    count = np.bincount(bins)
    middle, mean = (np.bincount(bins, weights=values) / count for values in (time_s, motion))
    velocity = np.gradient(mean, middle)
    acceleration = np.gradient(velocity, middle)
    return np.interp(time_s, middle, velocity), np.interp(time_s, middle, acceleration)


def averaged(system: System, samples: pd.DataFrame) -> int:
    """Samples to average where a system is compared at a working rate: what is faster is noise."""
    if system.working_hz is None:
        return 1
    usual_s = float(np.median(np.diff(samples["time_s"].to_numpy())))
    return max(1, round(1.0 / (system.working_hz * usual_s)))


def joined(runs: Sequence[RecordedRun], most: int = WORKING_SAMPLES, thin: bool = True) -> Record:
    """One record of all runs, in the given order, a minute apart; strokes are numbered on from `strokes_before`.

    Without `thin` a system's working rate is no reason to average.
    """
    common = max(1, -(-sum(len(recorded.samples) for recorded in runs) // most))
    parts: list[Record] = []
    clock_s, stroke0 = 0.0, 0
    for index, recorded in enumerate(runs):
        run = recorded.run
        before = run.string.strokes_before if run.string else 0
        width = max(common, averaged(run.system, recorded.samples) if thin else 1)
        part = of_run(recorded, width, index, max(stroke0, before))
        time_s = part.time_s - part.time_s[0] + clock_s
        clock_s, stroke0 = float(time_s[-1]) + BETWEEN_RUNS_S, int(part.stroke.max())
        parts.append(Record(**{**part.__dict__, "time_s": time_s}))
    if len(parts) == 1:
        return parts[0]

    def stacked(name: str) -> Array | None:
        columns = [getattr(part, name) for part in parts]
        return None if any(column is None for column in columns) else np.concatenate(columns)

    return Record(**{name: stacked(name) for name in Record.__dataclass_fields__})  # type: ignore[arg-type]
