"""A set-up and a seed → the readings and the events of the rig's device, all at once and in memory."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Array
from ..wire import Event, Hello
from ..wire.motion import Limits
from . import effects, sensors
from .motion_commands import Commands, commands
from .setup import SetUp, described, dimensions
from .string_state import String

DEVICE = "twistbench synthetic rig"
FIRMWARE = "1"


@dataclass(frozen=True)
class Simulated:
    """One recording before it is sent, and the truth behind it."""

    hello: Hello
    samples: NDArray[np.void]  # (samples,), of the HELLO's sample type, each field in its channel's unit
    events: list[tuple[int, int, Event, int]]  # the sample that it comes before, t_us, code, value
    time_s: Array  # (samples,)
    truth: dict[str, Array]  # by channel, each (samples,), in the channel's unit


def simulate(setup: SetUp, seed: int) -> Simulated:
    """Run the set-up once; the same seed gives the same recording."""
    step_s = step_of(setup)
    return sampled(setup, commands(setup.motion, step_s), string_of(setup), seed)


def hello_of(setup: SetUp, nonce: str, strokes: int, program: Limits | None = None) -> Hello:
    """The HELLO of a set-up's device; `program`: its limits for programs."""
    return Hello(DEVICE, FIRMWARE, nonce, setup.rate_hz, strokes, sensors.declare(setup.sensors), program=program)


def step_of(setup: SetUp) -> float:
    """Time step of a set-up's rig in s."""
    return 1.0 / setup.rate_hz / setup.steps_per_sample


def string_of(setup: SetUp) -> String:
    """A new string of a set-up, with its effects."""
    geometry = dimensions(described(setup, Path("synthetic/run.yaml")))
    return String(geometry, [effects.make(*effect) for effect in setup.effects.items()], step_of(setup))


def sampled(
    setup: SetUp, commands: Commands, string: String, seed: int, zeros: dict[str, float] | None = None
) -> Simulated:
    """The readings of a set-up's sensors while a string undergoes commanded steps; the string is changed by them.

    `zeros` is where the channels' sensors were set to zero; one without a zero is set at the first sample.
    """
    # the nonce, and each channel's noise, have a stream of their own: one more channel must not move the others'
    boot, *streams = (np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(17))
    contraction_mm = string.pull(commands.motor_turns, commands.load_n)

    every = slice(None, None, setup.steps_per_sample)
    time_s = commands.time_s[every]
    truth = {
        "motor_turns": commands.motor_turns[every],
        "displacement_mm": contraction_mm[every],
        "load_n": commands.load_n[every],
    }
    hello = hello_of(setup, f"{boot.integers(1 << 32):08x}", len(commands.strokes_s))
    samples = np.zeros(len(time_s), hello.sample_type)
    samples["t_us"] = _t_us(setup, time_s)
    for (name, sensor), rng in zip(setup.sensors.items(), streams, strict=False):
        samples[name] = sensors.read(sensor, truth[name], rng, (zeros or {}).get(name))
    events = []
    for number, (start_s, _, _, end_s) in enumerate(commands.strokes_s.tolist(), 1):
        for at_s, code in ((start_s, Event.STROKE_START), (end_s, Event.STROKE_END)):
            at_us = int(_t_us(setup, np.array([at_s]))[0])
            events.append((int(np.searchsorted(time_s, at_s)), at_us, code, number))
    return Simulated(hello, samples, events, time_s, truth)


def _t_us(setup: SetUp, time_s: Array) -> NDArray[np.uint32]:
    return ((setup.clock_start_us + np.rint(time_s * 1e6).astype(np.int64)) % (1 << 32)).astype(np.uint32)
