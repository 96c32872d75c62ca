"""The commanded motion of the rig: strokes, speeds, holds, rests and loads, as twist and load over time."""

from dataclasses import dataclass
from itertools import cycle, islice
from typing import Annotated

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, model_validator

from ..ground.kinematics import Array

Positive = Annotated[float, Field(gt=0, allow_inf_nan=False)]
Time = Annotated[float, Field(ge=0, allow_inf_nan=False)]


class Strokes(BaseModel):
    """`repeat` equal strokes: wind up, hold, unwind, rest; under one load."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    repeat: Annotated[int, Field(ge=1)] = 1
    top_turns: float
    bottom_turns: float = 0.0
    speed_turns_per_s: Positive
    speed_up_s: Time = 0.0
    slow_down_s: Time = 0.0
    hold_s: Time
    rest_s: Time
    load_n: Positive

    @model_validator(mode="after")
    def _winds_up(self) -> "Strokes":
        if self.top_turns <= self.bottom_turns:
            raise ValueError("top_turns must be above bottom_turns")
        return self


class Motion(BaseModel):
    """A whole recording: a rest, then the strokes."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    rest_s: Time
    strokes: Annotated[list[Strokes], Field(min_length=1)]

    def each(self) -> list[Strokes]:
        """The strokes one by one."""
        return [stroke for strokes in self.strokes for stroke in [strokes] * strokes.repeat]

    def of_strokes(self, count: int) -> "Motion":
        """The same motion with that many strokes: its own in order, from the first again after the last."""
        each = (stroke.model_copy(update={"repeat": 1}) for stroke in cycle(self.each()))
        return self.model_copy(update={"strokes": list(islice(each, count))})


@dataclass(frozen=True)
class Commands:
    """Commanded twist and load at the ends of equal steps, and when each stroke starts and ends."""

    time_s: Array  # (steps,)
    motor_turns: Array  # (steps,)
    load_n: Array  # (steps,)
    strokes_s: Array  # (strokes, 4): start of winding, of hold, of unwinding, and its end


@dataclass(frozen=True)
class Move:
    """One way of the motor: its speed rises and falls evenly, sooner where the way is too short for that."""

    turns: float  # negative when unwinding
    speed_turns_per_s: float
    up_s: float
    down_s: float

    @staticmethod
    def of(stroke: Strokes, turns: float) -> "Move":
        ramps_turns = stroke.speed_turns_per_s * (stroke.speed_up_s + stroke.slow_down_s) / 2.0
        share = min(1.0, abs(turns) / ramps_turns) if ramps_turns else 1.0
        return Move(turns, stroke.speed_turns_per_s, share * stroke.speed_up_s, share * stroke.slow_down_s)

    @property
    def duration_s(self) -> float:
        """How long it takes."""
        return abs(self.turns) / self.speed_turns_per_s + (self.up_s + self.down_s) / 2.0

    def at(self, since_s: Array) -> Array:
        """Turns made after a time since the start; nothing before it, all of them after its end.

        Shape (times,), in s; answers in turns.
        """
        end_s = self.duration_s
        t = np.clip(since_s, 0.0, end_s)
        full_speed_s = np.clip(t, self.up_s, end_s - self.down_s) - self.up_s  # in seconds of full speed
        if self.up_s:
            full_speed_s += np.minimum(t, self.up_s) ** 2 / (2.0 * self.up_s)
        if self.down_s:
            left_s = np.minimum(end_s - t, self.down_s)
            full_speed_s += (self.down_s**2 - left_s**2) / (2.0 * self.down_s)
        return np.copysign(self.speed_turns_per_s * full_speed_s, self.turns)


def commands(motion: Motion, step_s: float) -> Commands:
    """The motion in steps of `step_s`; a load hangs from the end of the stroke before to the end of its own."""
    each = motion.each()
    at_turns, at_s = each[0].bottom_turns, motion.rest_s
    moves, marks_s = [], []
    for stroke in each:
        wind = Move.of(stroke, stroke.top_turns - at_turns)
        unwind = Move.of(stroke, stroke.bottom_turns - stroke.top_turns)
        held_s = at_s + wind.duration_s + stroke.hold_s
        moves += [(at_s, wind), (held_s, unwind)]
        marks_s.append((at_s, at_s + wind.duration_s, held_s, held_s + unwind.duration_s))
        at_turns, at_s = stroke.bottom_turns, marks_s[-1][3] + stroke.rest_s
    time_s: Array = np.arange(round(at_s / step_s) + 1, dtype=np.float64) * step_s
    turns = each[0].bottom_turns + np.sum([move.at(time_s - start_s) for start_s, move in moves], axis=0)
    strokes_s = np.array(marks_s)
    hanging = np.minimum(np.searchsorted(strokes_s[:, 3], time_s, side="left"), len(each) - 1)
    load_n = np.array([stroke.load_n for stroke in each])[hanging]
    return Commands(time_s, turns, load_n, strokes_s)
