"""A bench performs a motion: the rig is run once, and its noise-free sensor readings are sampled."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Array, Geometry
from ..rig import effects
from ..rig.concealed import Parameters
from ..rig.motion_commands import Commands
from ..rig.string_state import String
from .bench import Bench
from .protocol import STEPS_PER_SAMPLE, Protocol, phases

Hidden = Mapping[str, Parameters]  # parameters by effect


@dataclass(frozen=True)
class Performed:
    """The true motion and the noise-free readings in equal samples; arrays of shape (samples,)."""

    time_s: Array
    motor_turns: Array
    load_n: Array
    displacement_mm: Array
    temperature_c: Array
    stroke: NDArray[np.intp]  # as counts from 1; 0 before the first
    phase: NDArray[np.str_]  # as labels


def live(geometry: Geometry, commands: Commands, hidden: Hidden, step_s: float) -> tuple[Array, Array]:
    """Displacement in mm and temperature in °C at the end of every step; both of shape (steps,)."""
    string = String(geometry, [effects.make(*effect) for effect in hidden.items()], step_s)
    lived = string.live(commands.motor_turns, commands.load_n)
    return lived.reading_mm, lived.temperature_c


def perform(bench: Bench, protocol: Protocol, hidden: Hidden, late_s: Array | None = None) -> Performed:
    """The bench with these effects in it, sampled at the protocol's rate or `late_s` after it.

    The displacement has the sensor's scale and zero. `late_s` has the shape (samples,), in s.
    """
    commands = protocol.told
    reading_mm, temperature_c = live(bench.true, commands, hidden, protocol.step_s)
    time_s = commands.time_s[::STEPS_PER_SAMPLE]
    time_s = time_s if late_s is None else np.clip(time_s + late_s, 0.0, commands.time_s[-1])
    sampled = [
        np.interp(time_s, commands.time_s, values)
        for values in (commands.motor_turns, commands.load_n, reading_mm, temperature_c)
    ]
    stroke, phase = protocol.phases if late_s is None else phases(commands, time_s)
    displacement_mm = bench.scale * sampled[2] + bench.zero_mm
    return Performed(time_s, sampled[0], sampled[1], displacement_mm, sampled[3], stroke, phase)
