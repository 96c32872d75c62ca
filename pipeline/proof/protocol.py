"""The motion of a concealed rig: a rich protocol that separates the drivers, or a poor one that does not."""

from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Array
from ..rig.motion_commands import Commands, Motion, commands
from .bench import Bench

Kind = Literal["rich", "poor"]
SAMPLES = 12_000
STEPS_PER_SAMPLE = 8
REST_BAND = 0.05  # of the twist's range: a hold so near the lowest twist is a rest, as in run/strokes.py


@dataclass(frozen=True)
class Protocol:
    """A motion and the rate at which it is recorded."""

    kind: Kind
    motion: Motion
    rate_hz: float

    @property
    def step_s(self) -> float:
        """Time step of the rig."""
        return 1.0 / self.rate_hz / STEPS_PER_SAMPLE

    @cached_property
    def told(self) -> Commands:
        """The motion in steps of the rig."""
        return commands(self.motion, self.step_s)

    @cached_property
    def phases(self) -> tuple[NDArray[np.intp], NDArray[np.str_]]:
        """Stroke and phase of every sample that is taken in time; both of shape (samples,).

        A stroke is a count.
        """
        return phases(self.told, self.told.time_s[::STEPS_PER_SAMPLE])


def draw_protocol(kind: Kind, bench: Bench, rng: np.random.Generator) -> Protocol:
    """About 12,000 samples at 25 to 50 Hz of 10 to 15 strokes."""
    strokes = _rich(bench, rng) if kind == "rich" else _poor(bench, rng)
    motion = Motion.model_validate({"rest_s": float(rng.uniform(3.0, 8.0)), "strokes": strokes})
    lasts_s = sum(_lasts_s(stroke) for stroke in strokes)
    rate_hz = float(np.clip(round(SAMPLES / lasts_s), 25, 50))
    return Protocol(kind, motion, rate_hz)


def _lasts_s(stroke: dict[str, float]) -> float:
    way_turns = stroke["repeat"] * 2.0 * (stroke["top_turns"] - stroke["bottom_turns"])
    return float(way_turns / stroke["speed_turns_per_s"] + stroke["repeat"] * (stroke["hold_s"] + stroke["rest_s"]))


def _stroke(bench: Bench, **settings: float) -> dict[str, float]:
    ramp_s = {"speed_up_s": 0.2, "slow_down_s": 0.2}
    return (
        {"repeat": 1, "top_turns": bench.top_turns, "bottom_turns": 0.0, "load_n": bench.loads_n[0]} | ramp_s | settings
    )


def _rich(bench: Bench, rng: np.random.Generator) -> list[dict[str, float]]:
    """Every load at every speed in random order, some twice; dwells and pauses of all lengths; partial strokes."""
    speeds = [bench.top_turns / way_s for way_s in (rng.uniform(3.5, 5.0), rng.uniform(7.0, 9.0), rng.uniform(13, 17))]
    count = int(rng.integers(10, 15))
    pairs = [*product(bench.loads_n, speeds)]
    pairs = [pairs[k] for k in rng.permutation(9)] + [(bench.loads_n[0], speeds[k % 3]) for k in range(count - 9)]
    dwells_s = rng.permutation(np.resize([0.6, 2.0, 6.0, 15.0], count))
    pauses_s = rng.permutation(np.resize([1.0, 3.0, 10.0, 25.0], count))
    first = 1 + int(rng.integers(2))
    partial = dict(zip(first + rng.permutation(3) * ((count - first) // 3), ("top", "top", "bottom"), strict=True))
    strokes = []
    for number, (load_n, speed) in enumerate(pairs):
        settings = {"load_n": load_n, "speed_turns_per_s": speed}
        settings |= {"hold_s": float(dwells_s[number]), "rest_s": float(pauses_s[number])}
        if partial.get(number) == "top":
            settings["top_turns"] = bench.top_turns * rng.uniform(0.5, 0.75)
        elif partial.get(number) == "bottom":
            settings["bottom_turns"] = bench.top_turns * rng.uniform(0.25, 0.4)
        strokes.append(_stroke(bench, **settings))
    return strokes


def _poor(bench: Bench, rng: np.random.Generator) -> list[dict[str, float]]:
    """Equal strokes at one speed under one load, one after the other."""
    settings = {"speed_turns_per_s": bench.top_turns / rng.uniform(8.0, 14.0), "hold_s": 0.0, "rest_s": 0.0}
    return [_stroke(bench, repeat=int(rng.integers(10, 16)), **settings)]


def phases(commands: Commands, time_s: Array) -> tuple[NDArray[np.intp], NDArray[np.str_]]:
    """Stroke (0 before the first) and phase of every sample, as they were commanded; both of shape (samples,).

    A stroke is a count.
    """
    marks_s = commands.strokes_s.ravel()
    mark = np.searchsorted(marks_s, time_s, side="right")
    stroke = (mark + 3) // 4
    names = np.array(["stand", "winding", "hold", "unwinding"])
    phase = names[np.where(mark == 0, 0, (mark - 1) % 4 + 1) % 4]
    turns = np.interp(time_s, commands.time_s, commands.motor_turns)
    low = turns <= commands.motor_turns.min() + REST_BAND * np.ptp(commands.motor_turns)
    phase[phase == "stand"] = np.where(low, "rest", "hold")[phase == "stand"]
    return stroke.astype(np.intp), phase
