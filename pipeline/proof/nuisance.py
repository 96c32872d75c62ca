"""Disturbances of every recording that are no physics: coloured noise, quanta, jitter, outliers, gaps."""

from dataclasses import asdict, dataclass, replace

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.signal import lfilter

from ..ground.kinematics import Array
from .perform import Performed

ENCODER_QUANTUM_TURNS = 1.0 / 4096.0


@dataclass(frozen=True)
class Nuisance:
    """How badly a recording is taken; sizes in mm and s."""

    floor_mm: float  # rms of all that is random in the displacement, quantisation included
    coloured: float  # share of the noise's variance that is coloured
    colour_s: float  # how long the coloured part remembers
    quantum_mm: float
    jitter: float  # rms, in sample periods
    outliers: float  # share of samples
    dropouts: float  # share of samples, in gaps
    louder: float = 1.0  # by how much the noise grows over a middle third of the recording

    def told(self) -> dict[str, float]:
        """All of it, for the answer."""
        return asdict(self)


def draw_nuisance(rng: np.random.Generator, trap: bool = False) -> Nuisance:
    """An ordinary recording, or one whose noise looks like physics: slow colour, steps in its size, many outliers."""
    floor_mm = float(rng.uniform(0.02, 0.08))
    nuisance = Nuisance(
        floor_mm,
        coloured=float(rng.uniform(0.0, 0.6)),
        colour_s=float(np.exp(rng.uniform(np.log(0.03), np.log(0.3)))),
        quantum_mm=floor_mm * float(rng.uniform(0.2, 0.7)),
        jitter=float(rng.uniform(0.0, 0.05)),
        outliers=0.001,
        dropouts=float(rng.uniform(0.0, 0.005)),
    )
    if not trap:
        return nuisance
    return replace(
        nuisance,
        coloured=float(rng.uniform(0.5, 0.9)),
        colour_s=float(rng.uniform(0.3, 1.0)),
        jitter=float(rng.uniform(0.05, 0.15)),
        outliers=float(rng.uniform(0.001, 0.005)),
        dropouts=float(rng.uniform(0.005, 0.02)),
        louder=float(rng.choice([1.0, 1.5, 2.0])),
    )


def late_s(nuisance: Nuisance, rate_hz: float, count: int, rng: np.random.Generator) -> Array:
    """How late each sample is taken; never so late that it is taken after the next one. Shape (count,)."""
    return np.clip(nuisance.jitter * rng.standard_normal(count), -0.4, 0.4) / rate_hz


def noise_mm(nuisance: Nuisance, rate_hz: float, count: int, rng: np.random.Generator) -> Array:
    """Noise without quantisation, of the rms that the floor leaves for it; of shape (count,)."""
    kept = np.exp(-1.0 / (rate_hz * nuisance.colour_s))
    coloured = lfilter([np.sqrt(1.0 - kept**2)], [1.0, -kept], rng.standard_normal(count + 500))[500:]
    mixed = np.sqrt(nuisance.coloured) * coloured + np.sqrt(1.0 - nuisance.coloured) * rng.standard_normal(count)
    middle = np.arange(count) // max(count // 3, 1) == 1
    loud = np.where(middle, nuisance.louder, 1.0)
    loud /= np.sqrt(np.square(loud).mean())
    return np.sqrt(nuisance.floor_mm**2 - nuisance.quantum_mm**2 / 12.0) * loud * mixed


@dataclass(frozen=True)
class Recorded:
    """A recording, and for each sample the truth that the recording does not show."""

    table: pd.DataFrame
    error_mm: Array  # (rows,): what the displacement says less what it truly was
    wild: NDArray[np.bool_]  # (rows,): outliers, a mask
    stroke: NDArray[np.intp]  # (rows,): as commanded, a count


def record(
    performed: Performed,
    nuisance: Nuisance,
    rate_hz: float,
    load_cell: bool,
    thermocouple: bool,
    rng: np.random.Generator,
) -> Recorded:
    """The recording: the performed motion as such sensors and such a logger keep it."""
    count = len(performed.time_s)
    measured_mm = performed.displacement_mm + noise_mm(nuisance, rate_hz, count, rng)
    wild = rng.random(count) < nuisance.outliers
    measured_mm = measured_mm + wild * rng.choice([-1.0, 1.0], count) * nuisance.floor_mm * rng.uniform(8, 40, count)
    turns = np.rint(performed.motor_turns / ENCODER_QUANTUM_TURNS) * ENCODER_QUANTUM_TURNS
    table = {
        "time_s": np.round(performed.time_s, 6),
        "motor_turns": turns,
        "displacement_mm": np.rint(measured_mm / nuisance.quantum_mm) * nuisance.quantum_mm,
    }
    if load_cell:
        table["load_n"] = np.round(performed.load_n * (1.0 + 0.003 * rng.standard_normal(count)), 3)
    if thermocouple:
        table["temperature_c"] = np.round(performed.temperature_c + 0.05 * rng.standard_normal(count), 2)
    kept = _kept(nuisance, count, rng)
    error_mm = table["displacement_mm"] - performed.displacement_mm
    rows = pd.DataFrame(table)[kept].reset_index(drop=True)
    return Recorded(rows, error_mm[kept], wild[kept], performed.stroke[kept])


def _kept(nuisance: Nuisance, count: int, rng: np.random.Generator) -> NDArray[np.bool_]:
    """Which samples are kept: all but those in gaps of up to twelve."""
    kept = np.ones(count, bool)
    while 1.0 - kept.mean() < nuisance.dropouts:
        first = int(rng.integers(1, count - 13))
        kept[first : first + int(rng.integers(1, 13))] = False
    return kept
