"""What the instruments make of the truth: noise, counts, a clock that jitters, lost rows, outliers."""

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd
from scipy.signal import lfilter

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import carried_on
from pipeline.rig.authors.workshop.specimen import Specimen


@dataclass(frozen=True)
class Instruments:
    """The drawn errors of one recording's instruments, tick by tick."""

    noise_mm: Array
    step_mm: float
    zero_mm: float
    kept: Array
    outliers_mm: Array
    rng_state: int

    @property
    def floor_mm(self) -> float:
        """Rms of the reading's noise and its rounding, without outliers, in mm."""
        return float(np.sqrt(np.mean(self.noise_mm[self.kept] ** 2) + self.step_mm**2 / 12.0))


def drawn_instruments(seed: int, specimen: Specimen) -> Instruments:
    """Draw the instruments of a seed for its specimen."""
    rng = np.random.default_rng([seed, 7002])
    count, tick_s = len(specimen.bench.time_s), specimen.bench.tick_s
    sigma = float(np.exp(rng.uniform(np.log(0.006), np.log(0.04))))
    coloured, memory = rng.uniform(0.1, 0.45), np.exp(-tick_s / rng.uniform(0.05, 0.8))
    drive = rng.normal(0.0, np.sqrt(1.0 - memory**2), count)
    drive[0] = rng.normal()
    noise = sigma * (np.sqrt(1.0 - coloured) * rng.normal(size=count))
    noise += sigma * np.sqrt(coloured) * lfilter([1.0], [1.0, -memory], drive)
    kept = rng.random(count) >= rng.choice([0.0, 0.002, 0.01])
    for _ in range(int(rng.integers(0, 3))):  # a buffer that ran over
        begin = int(rng.integers(count // 10, count - 200))
        kept[begin : begin + int(rng.uniform(0.1, 0.8) / tick_s)] = False
    kept[[0, -1]] = True
    outliers = np.zeros(count)
    if rng.random() < 0.3:
        where = rng.integers(10, count - 10, int(rng.integers(2, 9)))
        outliers[where] = rng.choice([-1.0, 1.0], len(where)) * rng.uniform(8.0, 60.0, len(where)) * sigma
    step, zero = sigma * rng.uniform(0.1, 0.9), rng.uniform(-5.0, 20.0)
    return Instruments(noise, step, zero, kept, outliers, int(rng.integers(2**31)))


def working_on(instruments: Instruments, ticks: int) -> Instruments:
    """The same instruments until the end of a longer recording of so many ticks."""
    count = ticks - len(instruments.noise_mm)
    return replace(
        instruments,
        noise_mm=carried_on(instruments.noise_mm, count),
        kept=np.append(instruments.kept, np.ones(count, bool)),
        outliers_mm=np.append(instruments.outliers_mm, np.zeros(count)),
    )


def rounded(values: Array, step: float) -> Array:
    """Values in whole steps."""
    return np.asarray(np.round(values / step) * step)


def recorded(specimen: Specimen, instruments: Instruments, reading_mm: Array) -> tuple[pd.DataFrame, Array]:
    """The recording's table, and the noise of its displacement without outliers, in mm, row by row."""
    rng = np.random.default_rng([instruments.rng_state, 7003])
    bench, kept = specimen.bench, instruments.kept
    clean = reading_mm + instruments.zero_mm
    shown = rounded(clean + instruments.noise_mm, instruments.step_mm)
    jitter = rng.uniform(-1.0, 1.0, len(clean)) * rng.uniform(0.0, 0.04) * bench.tick_s
    counts = float(rng.choice([1024.0, 2000.0, 4096.0, 16384.0]))
    table = {
        "time_s": np.round(bench.time_s + jitter - jitter[0], 6),
        "motor_turns": rounded(bench.turns + specimen.angle_zero_turns, 1.0 / counts),
        "displacement_mm": np.round(rounded(shown + instruments.outliers_mm, instruments.step_mm), 6),
    }
    load = bench.load_n * (1.0 + rng.normal(0.0, 0.003)) + rng.normal(0.0, 0.03, len(clean))
    warmth = bench.temperature_c + rng.normal(0.0, 0.05, len(clean))
    if specimen.load_cell:
        table["load_n"] = rounded(load, 0.01)
    if bench.thermometer:
        table["temperature_c"] = rounded(warmth, 0.0625)
    return pd.DataFrame({name: column[kept] for name, column in table.items()}), (shown - clean)[kept]
