"""A rig whose string stays on it: each recording starts where the last one ended. It runs motion programs."""

import copy
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..wire.motion import Leg, Limits, cruise
from .motion_commands import Commands, Move, commands
from .recorded_at_once import Simulated, hello_of, sampled, step_of, string_of
from .setup import SetUp
from .string_state import String

BETWEEN_S = 60.0  # of the rig's own time, at rest between two recordings
REACH, FASTER, HEAVIER = 1.1, 2.5, 2.5  # times what the set-up's own motion does: the limits
RAMP_S = 0.1  # to full speed
LEGS, LONGEST_S, SILENCE_S = 200, 3600.0, 1.5


class Standing:
    """One string for all recordings; `load` says whether the rig can change its load.

    It stays powered, so its sensors keep the zero of the first recording; `zeroed`: they are set to zero at each start.
    """

    def __init__(self, setup: SetUp, seed: int, load: bool = True, zeroed: bool = False) -> None:
        self.setup, self.seed, self.load, self.zeroed = setup, seed, load, zeroed
        self._zeros: dict[str, float] = {}  # of the first recording, by channel
        self.step_s, self.string, self.number = step_of(setup), string_of(setup), 0
        each = setup.motion.each()
        self.strokes = len(each)  # of its own motion
        self.at_turns, self.hangs_n = each[0].bottom_turns, each[0].load_n
        top = max(stroke.top_turns for stroke in each)
        fastest = FASTER * max(stroke.speed_turns_per_s for stroke in each)
        loads = [stroke.load_n for stroke in each]
        self._limits = Limits(
            legs=LEGS,
            turns=(0.0, REACH * top),
            turns_per_s=fastest,
            turns_per_s2=fastest / RAMP_S,
            seconds=LONGEST_S,
            silence_s=SILENCE_S,
            at_turns=self.at_turns,
            load_n=(min(loads) / HEAVIER, HEAVIER * max(loads)) if load else None,
        )
        self._before: tuple[String, Commands] | None = None
        self._rehearse()

    def _rehearse(self) -> None:
        """Run a first motion, so that compiling and loading are done before a host waits."""
        still = followed([Leg(1.0, self.at_turns)], self.at_turns, self.hangs_n, self._limits.turns_per_s2, self.step_s)
        sampled(self.setup, still, copy.deepcopy(self.string), self.seed)

    @property
    def limits(self) -> Limits:
        """The limits for a program, from the motor's present place."""
        return replace(self._limits, at_turns=self.at_turns)

    @property
    def declared(self) -> Simulated:
        """The HELLO, without samples yet."""
        nonce = f"{np.random.default_rng(self.seed).integers(1 << 32):08x}"
        hello = hello_of(self.setup, nonce, self.strokes, self.limits)
        return Simulated(hello, np.zeros(0, hello.sample_type), [], np.zeros(0), {})

    def own(self) -> Simulated:
        """The set-up's own motion."""
        return self._performed(commands(self.setup.motion, self.step_s))

    def perform(self, legs: Sequence[Leg]) -> Simulated:
        """Follow a program that is within the limits."""
        return self._performed(followed(legs, self.at_turns, self.hangs_n, self._limits.turns_per_s2, self.step_s))

    def _performed(self, commands: Commands) -> Simulated:
        if self.number:
            steps = round(BETWEEN_S / self.step_s)
            self.string.pull(np.full(steps, self.at_turns), np.full(steps, self.hangs_n))
        self._before = copy.deepcopy(self.string), commands
        simulated = sampled(self.setup, commands, self.string, self.seed + self.number, self._zeros)
        if not self.zeroed and not self._zeros:
            self._zeros = {name: float(true[0]) for name, true in simulated.truth.items()}
        self.number += 1
        self.at_turns, self.hangs_n = float(commands.motor_turns[-1]), float(commands.load_n[-1])
        return simulated

    def stopped(self, samples: int) -> None:
        """The recording ended after that many samples: the string has undergone no more, and the motor stands there."""
        if self._before is None:
            return
        self.string, commands = self._before
        steps = max(1, samples * self.setup.steps_per_sample)
        turns, load_n = commands.motor_turns[:steps], commands.load_n[:steps]
        self.string.pull(turns, load_n)
        self.at_turns, self.hangs_n, self._before = float(turns[-1]), float(load_n[-1]), None


def followed(legs: Sequence[Leg], at_turns: float, hangs_n: float, turns_per_s2: float, step_s: float) -> Commands:
    """The legs in steps of `step_s`: each from standstill to standstill, under its load from its beginning on."""
    ends_s = np.cumsum([leg.seconds for leg in legs])
    time_s = np.arange(round(float(ends_s[-1]) / step_s) + 1, dtype=np.float64) * step_s
    turns, load_n = np.full(len(time_s), at_turns), np.full(len(time_s), hangs_n)
    marks_s: list[list[float]] = []  # of strokes: winding, hold, unwinding, end
    for leg, end_s in zip(legs, ends_s.tolist(), strict=True):
        start_s, way = end_s - leg.seconds, leg.turns - at_turns
        if leg.load_n is not None:
            load_n[time_s >= start_s] = leg.load_n
        speed = cruise(way, leg.seconds, turns_per_s2)
        if way and speed:
            ramp_s = speed / turns_per_s2
            turns += Move(way, speed, ramp_s, ramp_s).at(time_s - start_s)
        if way > 0:
            marks_s.append([start_s, end_s, end_s, end_s])
        elif way < 0 and marks_s and marks_s[-1][2] == marks_s[-1][3]:
            marks_s[-1][2:] = [start_s, end_s]
        at_turns = leg.turns
    return Commands(time_s, turns, load_n, np.array(marks_s).reshape(-1, 4))
