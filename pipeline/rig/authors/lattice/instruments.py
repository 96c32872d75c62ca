"""The instruments: a clock that jitters, counts of an encoder, a noisy quantised sensor, lost rows and outliers."""

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from pipeline.rig.authors.interface import carried_on
from pipeline.rig.authors.lattice.kernels import wandering
from pipeline.rig.authors.lattice.session import Session

Array = NDArray[np.float64]
Rng = np.random.Generator


@dataclass(frozen=True)
class Sampling:
    """When the samples are taken, and the noise of each of them without the quantisation."""

    time_s: Array
    stamped_s: Array
    noise_mm: Array
    quantum_mm: float
    counts_per_turn: int
    outlier_mm: Array


def sampling(rng: Rng, whole_session: Session) -> Sampling:
    """Draw the clock and the noise of a session's recording."""
    end_s, period_s = whole_session.world.time_s[-1], 1.0 / whole_session.rate_hz
    time_s = np.arange(0.0, end_s - period_s, period_s)
    time_s = time_s + period_s * 0.06 * np.clip(rng.normal(size=time_s.size), -3, 3)
    time_s = np.maximum(time_s, 0.0)
    kept = rng.random(time_s.size) > rng.choice([0.0, 0.0, 0.002])
    for _ in range(int(rng.poisson(0.7))):  # a burst that the logger lost
        at = int(rng.integers(0, time_s.size))
        kept[at : at + int(rng.integers(2, 20))] = False
    kept[:3] = True
    time_s = time_s[kept]
    count = time_s.size
    white_mm = float(np.exp(rng.uniform(np.log(0.008), np.log(0.06))))
    coloured = white_mm * rng.uniform(0.15, 0.6) * wandering(rng, count, period_s, rng.uniform(0.1, 1.2))
    outlier_mm = np.zeros(count)
    if rng.random() < 0.3:
        where = rng.choice(count, int(rng.integers(2, 9)), replace=False)
        outlier_mm[where] = white_mm * rng.uniform(8.0, 40.0, where.size) * rng.choice([-1.0, 1.0], where.size)
    return Sampling(
        time_s,
        np.round(time_s + 2e-4 * rng.normal(size=count).clip(-2, 2) * (period_s > 0.008), 6),
        white_mm * rng.normal(size=count) + coloured,
        float(rng.choice([0.001, 0.005, 0.01, 0.02])),
        int(rng.choice([360, 1024, 2000, 4096])),
        outlier_mm,
    )


def sampling_on(taken: Sampling, whole_session: Session) -> Sampling:
    """The same clock and noise until the end of a longer session."""
    period_s = 1.0 / whole_session.rate_hz
    more_s = np.arange(taken.time_s[-1] + period_s, whole_session.world.time_s[-1] - period_s, period_s)
    count = len(more_s)
    return replace(
        taken,
        time_s=np.append(taken.time_s, more_s),
        stamped_s=np.append(taken.stamped_s, np.round(more_s, 6)),
        noise_mm=carried_on(taken.noise_mm, count),
        outlier_mm=np.append(taken.outlier_mm, np.zeros(count)),
    )


@dataclass(frozen=True)
class Recorded:
    """The table of a recording, and the noise of each of its readings, outliers left out."""

    table: pd.DataFrame
    noise_mm: Array


def recorded(rng: Rng, whole_session: Session, taken: Sampling, reading_mm: Array, warmth: bool) -> Recorded:
    """The table that the instruments make of an ideal reading on the fine clock, `warmth` says if room is logged."""
    world, at = whole_session.world, taken.time_s
    zero_mm = rng.uniform(-5.0, 5.0)
    true_turns = np.interp(at, world.time_s, world.turns)
    counted = (
        np.round((true_turns - whole_session.specimen.angle_zero_turns) * taken.counts_per_turn) / taken.counts_per_turn
    )
    ideal_mm = (1.0 + whole_session.specimen.gain) * np.interp(at, world.time_s, reading_mm) + zero_mm
    shown_mm = np.round((ideal_mm + taken.noise_mm) / taken.quantum_mm) * taken.quantum_mm
    # a count that is off moves the point along the curve: noise of the reading as a simulator sees it
    slope = np.interp(at, world.time_s, np.gradient(world.base_mm) / np.where(world.rate == 0, np.inf, world.rate))
    off_mm = slope / world.step_s * (counted + whole_session.specimen.angle_zero_turns - true_turns)
    columns = {
        "time_s": taken.stamped_s - taken.stamped_s[0],
        "motor_turns": counted,
        "displacement_mm": np.round((shown_mm + taken.outlier_mm) / taken.quantum_mm) * taken.quantum_mm,
    }
    if whole_session.two_loads or rng.random() < 0.35:
        load_n = np.interp(at, world.time_s, world.load_n)
        columns["load_n"] = np.round(load_n * (1.0 + 0.002 * rng.normal(size=at.size)), 2)
    if warmth or rng.random() < 0.35:
        ambient_k = np.interp(at, world.time_s, world.ambient_k)
        columns["temperature_c"] = np.round(21.0 + ambient_k + 0.05 * rng.normal(size=at.size), 2)
    return Recorded(pd.DataFrame(columns), shown_mm - ideal_mm - off_mm)


def held_out(whole_session: Session, taken: Sampling) -> NDArray[np.bool_]:
    """Which samples belong to the last 30 % of the strokes, at least one."""
    last = max(1, round(0.3 * whole_session.world.strokes))
    stroke = whole_session.world.stroke[whole_session.world.at(taken.time_s)]
    return np.asarray(stroke >= whole_session.world.strokes - last)
