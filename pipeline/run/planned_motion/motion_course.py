"""The course of a motion, and the ranges of recorded courses: speeds, pauses, and turning places."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ...ground.kinematics import Array, Mask
from ...ground.numbers import spans
from ..strokes import of_samples
from ..turning import turning_points

STANDS, UNWOUND = 0.02, 0.05  # of the highest speed: slower stands; of the range: lower is unwound
WINDOW_S = 0.2  # over which a speed is taken: less is encoder noise
TURNS = 0.02  # of the recorded range: a smaller way back is no reversal
ALIKE = 1.2  # times the slowest stroke's speed: a fastest one below that is no other speed

Turns = dict[bool, Array]  # motion at which it turned, in the driver's unit, by whether that was at a top


@dataclass(frozen=True)
class Course:
    """Time in s, a motion in the driver's unit, and its speed over `WINDOW_S`, per second; each of shape (samples,)."""

    time_s: Array
    way: Array
    speed: Array

    @classmethod
    def of(cls, samples: pd.DataFrame, driver: str) -> "Course":
        """The course of some samples."""
        time_s, way = samples["time_s"].to_numpy(float), samples[driver].to_numpy(float)
        half_s = max(0.5 * WINDOW_S, float(np.median(np.diff(time_s))))
        first_s, last_s = np.maximum(time_s - half_s, time_s[0]), np.minimum(time_s + half_s, time_s[-1])
        moved = np.interp(last_s, time_s, way) - np.interp(first_s, time_s, way)
        return cls(time_s, way, np.abs(moved) / (last_s - first_s))

    @property
    def fastest(self) -> float:
        """The highest speed, in the driver's unit per second."""
        return float(self.speed.max())

    def moves(self, least: float) -> Mask:
        """The samples that move, compared with a highest speed of `least` or its own. Shape (samples,)."""
        return np.asarray(self.speed >= STANDS * max(min(least, self.fastest), 1e-9))

    @property
    def high(self) -> Mask:
        """The samples that are wound: further than a part of the range from the lowest place. Shape (samples,)."""
        return np.asarray(self.way > self.way.min() + UNWOUND * np.ptp(self.way))

    def lasted_s(self, mask: Mask) -> Array:
        """The time since a mask became True, in s, 0 where it is False. Both of shape (samples,)."""
        lasted_s = np.zeros(len(mask))
        for first, last in spans.of_mask(mask):
            lasted_s[first:last] = self.time_s[first:last] - self.time_s[first]
        return lasted_s

    def turns(self, span: float) -> tuple[NDArray[np.intp], Turns]:
        """The samples at which the motion turns, with its ends; and the places.

        `span`: the recorded range, in its unit.
        """
        points = turning_points(self.way, TURNS * span)
        values, before = self.way[points[1:-1]], self.way[points[:-2]]
        return points, {True: values[values > before], False: values[values <= before]}


def longest_s(time_s: Array, mask: Mask) -> float:
    """The longest time without a break, in s, of the samples in a mask; both of shape (samples,)."""
    return max((float(time_s[last - 1] - time_s[first]) for first, last in spans.of_mask(mask)), default=0.0)


@dataclass(frozen=True)
class Recorded:
    """The recordings of one rig: the samples of each, the strokes they were cut into, and the driver."""

    samples: Sequence[pd.DataFrame]
    strokes: Sequence[pd.DataFrame]
    driver: str

    @cached_property
    def courses(self) -> list[Course]:
        """The course of each recording."""
        return [Course.of(table, self.driver) for table in self.samples]

    @cached_property
    def ends(self) -> tuple[float, float]:
        """The lowest and the highest motion, in the driver's unit."""
        return min(float(course.way.min()) for course in self.courses), max(
            float(course.way.max()) for course in self.courses
        )

    @property
    def fastest(self) -> float:
        """The highest speed of a moment, in the driver's unit per second."""
        return max(course.fastest for course in self.courses)

    def longest_s(self, phase: str) -> float:
        """The longest `hold` or `rest`, in s."""
        parts = zip(self.samples, self.strokes, strict=True)
        return max(longest_s(table["time_s"].to_numpy(), of_samples(cut)[1] == phase) for table, cut in parts)

    @cached_property
    def speeds(self) -> list[float]:
        """The usual speed of each stroke, winding and unwinding together, in the driver's unit per second."""
        speeds = []
        for course, cut in zip(self.courses, self.strokes, strict=True):
            stroke, phase = of_samples(cut)
            moving = np.isin(phase, ["winding", "unwinding"])
            speeds += [float(np.median(course.speed[moving & (stroke == each)])) for each in np.unique(stroke[moving])]
        return speeds

    @property
    def one_speed(self) -> bool:
        """Whether all strokes have about the same speed."""
        return max(self.speeds) < ALIKE * min(self.speeds)

    @cached_property
    def turns(self) -> Turns:
        """Where the motion turned, in the driver's unit."""
        span = self.ends[1] - self.ends[0]
        course_turns = [course.turns(span)[1] for course in self.courses]
        return {top: np.concatenate([turned[top] for turned in course_turns]) for top in (True, False)}
