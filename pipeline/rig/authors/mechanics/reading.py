"""From what happened to what was written down: the clock, the encoder, the sensor's noise, lost rows and outliers."""

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import carried_on
from pipeline.rig.authors.mechanics.scene import STEP_S, Scene

MOST_ROWS = 24_000


@dataclass(frozen=True)
class Noise:
    """The clock and every error of the reading, drawn before any effect is: the noise floor sizes the effects."""

    time_s: Array
    reading_mm: Array  # white and coloured, without quantisation and outliers
    outliers_mm: Array
    kept: Array
    resolution_mm: float
    counts_per_turn: int
    angle_turns: float
    scale: float
    zero_mm: float


def noise(steps: int, draw: np.random.Generator) -> Noise:
    """The clock and the errors of one recording of so many steps."""
    rates_hz = [rate for rate in (25.0, 40.0, 50.0, 100.0) if rate * steps * STEP_S <= MOST_ROWS]
    rate_hz = float(draw.choice(rates_hz))
    count = int((steps - 2) * STEP_S * rate_hz)
    time_s = (np.arange(count) + draw.uniform(-0.08, 0.08, count) + 0.1) / rate_hz
    white_mm = float(np.exp(draw.uniform(np.log(0.015), np.log(0.06))))
    coloured_mm, keeps = (
        white_mm * float(draw.uniform(0.2, 0.5)),
        float(np.exp(-1.0 / (draw.uniform(0.2, 1.5) * rate_hz))),
    )
    slow, state = np.empty(count), draw.normal()
    for row, shock in enumerate(draw.normal(0.0, np.sqrt(1.0 - keeps**2), count)):
        state = keeps * state + shock
        slow[row] = state
    outliers = np.zeros(count)
    if draw.random() < 0.3:
        rows = draw.choice(count, int(draw.integers(2, 9)), replace=False)
        outliers[rows] = draw.choice([-1.0, 1.0], len(rows)) * white_mm * draw.uniform(8.0, 25.0, len(rows))
    kept = np.ones(count, bool)
    if draw.random() < 0.5:
        kept = draw.random(count) > draw.uniform(0.0005, 0.005)
    return Noise(
        time_s,
        white_mm * draw.normal(size=count) + coloured_mm * slow,
        outliers,
        kept,
        float(draw.choice([0.005, 0.01, 0.02])),
        int(draw.choice([512, 1024, 2048, 4096])),
        float(np.clip(draw.normal(0.0, 0.05), -0.12, 0.12)),
        1.0 + float(np.clip(draw.normal(0.0, 0.005), -0.012, 0.012)),
        float(draw.normal(0.0, 0.5)),
    )


def noise_on(errors: Noise, steps: int) -> Noise:
    """The same clock and errors until the end of a longer motion of so many steps."""
    period_s = float(np.median(np.diff(errors.time_s)))
    more_s = np.arange(errors.time_s[-1] + period_s, (steps - 2) * STEP_S, period_s)
    count = len(more_s)
    return replace(
        errors,
        time_s=np.append(errors.time_s, more_s),
        reading_mm=carried_on(errors.reading_mm, count),
        outliers_mm=np.append(errors.outliers_mm, np.zeros(count)),
        kept=np.append(errors.kept, np.ones(count, bool)),
    )


def sampled(values: Array, errors: Noise) -> Array:
    """Values of the simulation's steps at the recording's times."""
    return np.interp(errors.time_s, np.arange(len(values)) * STEP_S, values)


def _rounded(values: Array, unit: float) -> Array:
    return np.round(values / unit) * unit


def recorded(
    scene: Scene, shown_mm: Array, errors: Noise, with_load: bool, with_temperature: bool, draw: np.random.Generator
) -> tuple[pd.DataFrame, Array]:
    """The recording's table, and the noise of each of its rows in mm, outliers apart."""
    tared = errors.scale * (sampled(shown_mm, errors) - shown_mm[0]) + errors.zero_mm
    clean = _rounded(tared + errors.reading_mm, errors.resolution_mm)
    turns = _rounded(sampled(scene.turns, errors) + errors.angle_turns, 1.0 / errors.counts_per_turn)
    columns = {
        "time_s": np.round(errors.time_s, 5),
        "motor_turns": turns,
        "displacement_mm": _rounded(clean + errors.outliers_mm, errors.resolution_mm),
    }
    if with_load:
        cell = sampled(scene.load_n, errors) * (1.0 + 0.003 * draw.normal(size=len(turns)))
        columns["load_n"] = _rounded(cell, 0.01)
    if with_temperature:
        swing = draw.uniform(0.1, 0.8) * np.sin(2.0 * np.pi * errors.time_s / draw.uniform(400.0, 1500.0))
        columns["temperature_c"] = _rounded(
            draw.uniform(19.0, 25.0) + swing + 0.02 * draw.normal(size=len(turns)), 0.01
        )
    table = pd.DataFrame(columns)[errors.kept].reset_index(drop=True)
    return table, (clean - tared)[errors.kept]
