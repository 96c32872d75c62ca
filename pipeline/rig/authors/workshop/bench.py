"""The bench as it truly is on its clock: motion, load, temperature, string, and what follows from them."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, Array, Geometry


@dataclass(frozen=True)
class Bench:
    """One specimen's true course, sampled on an even clock; every array has one value per tick."""

    time_s: Array
    turns: Array
    load_n: Array
    temperature_c: Array
    stroke: Array
    geometry: Geometry
    thermometer: bool

    @property
    def tick_s(self) -> float:
        """Time between two samples, in s."""
        return float(self.time_s[1] - self.time_s[0])

    @cached_property
    def contraction_mm(self) -> Array:
        """Contraction by geometry alone, in mm."""
        return self.geometry.contraction_mm(self.turns, self.load_n)

    @cached_property
    def helix_rad(self) -> Array:
        """Angle of the strands to the axis, in rad."""
        wound_mm = self.turns * RAD_PER_TURN * self.geometry.radius_mm
        if self.geometry.actuator == "twisted_pair":
            return np.arcsin(np.clip(wound_mm / self.geometry.length_mm, 0.0, 1.0))
        return np.arctan((self.geometry.separator_mm + wound_mm) / self.geometry.torsion_zone_mm)

    @cached_property
    def load_ratio(self) -> Array:
        """Load over its mean."""
        return self.load_n / self.load_n.mean()

    @cached_property
    def tension(self) -> Array:
        """Tension along the strands over the mean load."""
        return self.load_ratio / np.cos(self.helix_rad)

    @cached_property
    def torque(self) -> Array:
        """Torque that the string asks of the shaft, over its greatest value."""
        torque = self.load_n * np.sin(self.helix_rad)
        return torque / torque.max()

    @cached_property
    def speed(self) -> Array:
        """Twisting rate in turns/s, winding positive."""
        return np.gradient(self.turns, self.tick_s)

    @cached_property
    def height(self) -> Array:
        """Twist over its range: 0 at the lowest, 1 at the highest."""
        return (self.turns - self.turns.min()) / np.ptp(self.turns)

    @cached_property
    def work(self) -> Array:
        """Lifting work done so far, in strokes of full height under the mean load."""
        lift = np.maximum(np.diff(self.contraction_mm, prepend=self.contraction_mm[0]), 0.0)
        return np.cumsum(lift * self.load_ratio) / np.ptp(self.contraction_mm)

    @cached_property
    def travel(self) -> Array:
        """Twist travelled so far, to and fro, over the twist's range."""
        return np.cumsum(np.abs(np.diff(self.turns, prepend=self.turns[0]))) / np.ptp(self.turns)


@dataclass(frozen=True)
class Part:
    """One hidden effect of a drawn shape: `act` of a size and the stage's signal gives the signal with the effect.

    Stages: `twist` in turns, `radius` as a factor, `length` and `reading` in mm. `size` names what the size is.
    """

    stage: str
    size: str
    limit: float
    act: Callable[[float, Array], Array]
    parameters: dict[str, Any] = field(default_factory=dict)


Law = Callable[[Bench, np.random.Generator], Part]


def added(stage: str, size: str, limit: float, shape: Array, **parameters: Any) -> Part:
    """An effect that adds its size times a shape to its stage's signal."""
    return Part(stage, size, limit, lambda amount, now: now + amount * shape, parameters)
