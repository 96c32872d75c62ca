"""The logger: when it takes its rows, what noise it adds, how finely it counts, which rows it loses."""

from dataclasses import dataclass, replace

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import carried_on
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.populations import wandering

MOST_ROWS = 24500


@dataclass(frozen=True)
class Logger:
    """One logger: `at` are its rows' times as fractions of bench steps; the rest is how it reads."""

    at: Array
    noise_mm: Array
    step_mm: float
    counts_per_turn: int
    zero_mm: float
    has_load: bool
    has_air: bool

    @property
    def rows(self) -> Array:
        """The bench's steps nearest to the rows."""
        return np.asarray(np.round(self.at), int)

    def taken(self, values: Array) -> Array:
        """Values of the bench at the rows' times."""
        return np.interp(self.at, np.arange(len(values)), values)

    def read(self, displacement_mm: Array) -> Array:
        """What the displacement sensor writes down of a true displacement at the rows, outliers left out."""
        return np.round((displacement_mm + self.zero_mm + self.noise_mm) / self.step_mm) * self.step_mm


def logger(chance: np.random.Generator, bench: Bench) -> Logger:
    """Draw a logger for a run."""
    duration_s = float(bench.time_s[-1])
    rates = [rate for rate in (25.0, 40.0, 50.0, 60.0, 80.0, 100.0) if rate * duration_s < MOST_ROWS]
    rate = float(chance.choice(rates))
    count = int(duration_s * rate)
    at = (np.arange(count) + chance.normal(0.0, chance.uniform(0.01, 0.08), count).clip(-0.3, 0.3)) / rate / STEP_S
    keep = chance.uniform(size=count) > (chance.uniform(0.0, 0.01) if chance.uniform() < 0.7 else 0.0)
    for start in chance.integers(0, count, int(chance.integers(0, 4))):
        keep[start : start + int(chance.integers(2, 30))] = False
    keep[0] = keep[-1] = True
    at = at[keep].clip(0.0, len(bench.turns) - 1.0)
    white_mm = float(np.exp(chance.uniform(np.log(0.008), np.log(0.05))))
    slow = chance.uniform(0.0, 0.6) * wandering(chance, len(bench.turns), float(np.exp(chance.uniform(-3.0, 0.5))))
    noise_mm = white_mm * (chance.normal(size=len(at)) + np.interp(at, np.arange(len(slow)), slow))
    step_mm = float(chance.choice([s for s in (0.001, 0.002, 0.005, 0.01, 0.02) if s < 1.2 * white_mm]))
    counts = int(chance.choice([1024, 2000, 2048, 4096, 8192]))
    has_load = bench.load_swings or bool(chance.uniform() < 0.4)
    return Logger(
        at, noise_mm, step_mm, counts, float(chance.uniform(-5.0, 30.0)), has_load, bool(chance.uniform() < 0.4)
    )


def logging_on(log: Logger, bench: Bench) -> Logger:
    """The same logger until the end of a longer run."""
    period = float(np.median(np.diff(log.at)))
    more = np.arange(log.at[-1] + period, len(bench.turns) - 1.0, period)
    noise_mm = carried_on(log.noise_mm, len(more))
    return replace(log, at=np.append(log.at, more), noise_mm=noise_mm, has_load=log.has_load or bench.load_swings)


def with_outliers(chance: np.random.Generator, reading_mm: Array, floor_mm: float) -> Array:
    """A reading with a few wild values, in three recordings of ten."""
    if chance.uniform() > 0.3:
        return reading_mm
    wild = reading_mm.copy()
    rows = chance.integers(0, len(wild), int(chance.integers(2, 12)))
    wild[rows] += chance.choice([-1.0, 1.0], len(rows)) * floor_mm * chance.uniform(15.0, 60.0, len(rows))
    return wild
