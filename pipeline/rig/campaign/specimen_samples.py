"""The recorded samples of a specimen in motion, with the truth behind them; in memory."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from .. import sensors
from ..effect import Effect
from ..motion_commands import Commands, Motion, commands
from ..sensors import Sensor
from ..string_state import String
from .specimen import Specimen

STEPS_PER_SAMPLE = 4
SENSORS = {
    "motor_turns": Sensor(quantum=1.0 / 4096.0, type="i32", zeroed=False),
    "displacement_mm": Sensor(quantum=0.02, noise=0.03, type="i32", zeroed=True),
}


@dataclass(frozen=True)
class Recorded:
    """`samples` has `time_s`, `motor_turns` and `displacement_mm`, one row a sample.

    `told` holds the commands of all steps, (steps,); `contraction_mm` what the sensor says without noise, with the
    recording's zero, (steps,).
    """

    samples: pd.DataFrame
    told: Commands
    contraction_mm: Array


def recorded(
    specimen: Specimen, effects: Iterable[Effect], motion: Motion, rate_hz: float, rng: np.random.Generator
) -> Recorded:
    """Move a specimen with these effects in it, and record it at `rate_hz`."""
    step_s = 1.0 / rate_hz / STEPS_PER_SAMPLE
    commanded = commands(motion, step_s)
    contraction_mm = String(specimen.true, effects, step_s).pull(commanded.motor_turns, commanded.load_n)
    samples = sampled(commanded.time_s, commanded.motor_turns, contraction_mm, rng)
    return Recorded(samples, commanded, contraction_mm - contraction_mm[0])


def sampled(time_s: Array, motor_turns: Array, contraction_mm: Array, rng: np.random.Generator) -> pd.DataFrame:
    """The readings of the sensors after steps of shape (steps,): one row a sample, the first at the first step.

    In s, turns and mm.
    """
    truth = {"motor_turns": motor_turns, "displacement_mm": contraction_mm}
    columns = {"time_s": time_s[::STEPS_PER_SAMPLE]}
    for (name, sensor), stream in zip(SENSORS.items(), rng.spawn(len(SENSORS)), strict=True):
        columns[name] = sensor.quantum * sensors.read(sensor, truth[name][::STEPS_PER_SAMPLE], stream)
    return pd.DataFrame(columns)
