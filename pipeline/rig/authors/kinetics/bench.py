"""What goes on at the bench while nothing spoils it: the motion, the loads and what follows of them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, Array, Geometry

STEP_S = 0.01


@dataclass(frozen=True)
class Bench:
    """One motion of one string on a fine, even clock; arrays hold a value a step of `STEP_S`."""

    geometry: Geometry
    turns: Array
    load_n: Array
    air_c: Array
    stroke: Array  # from 1; 0 before the first
    load_swings: bool

    @cached_property
    def time_s(self) -> Array:
        """Time since the start."""
        return np.arange(len(self.turns), dtype=np.float64) * STEP_S

    @cached_property
    def rate(self) -> Array:
        """Twisting rate in turns a second."""
        return np.gradient(self.turns, STEP_S)

    @cached_property
    def top(self) -> float:
        """The greatest twist in turns."""
        return float(self.turns.max())

    @cached_property
    def contraction_mm(self) -> Array:
        """Contraction of the true geometry."""
        return self.geometry.contraction_mm(self.turns, self.load_n)

    @cached_property
    def span_mm(self) -> float:
        """Height of the highest stroke."""
        return float(np.ptp(self.contraction_mm))

    @cached_property
    def lever_mm(self) -> Array:
        """Torque per force: the contraction by the twist, in mm."""
        return self.geometry.slope_mm_per_turn(self.turns, self.load_n) / RAD_PER_TURN

    @cached_property
    def load(self) -> Array:
        """Load as a share of its median."""
        return self.load_n / np.median(self.load_n)

    @cached_property
    def torque(self) -> Array:
        """Torque as a share of its greatest at the median load."""
        return self.load * self.lever_mm / float(np.max(self.lever_mm))

    @cached_property
    def squeeze(self) -> Array:
        """Line pressure between the strands, about load times the square of the helix' sine, relative to its top."""
        return self.load * np.square(self.lever_mm / float(np.max(self.lever_mm)))

    @cached_property
    def tension(self) -> Array:
        """Tension along a strand as a share: the load, and what the helix adds to it."""
        return self.load * (1.0 + 0.8 * np.square(self.turns / self.top))

    @cached_property
    def worked(self) -> Array:
        """Worked strokes: lifting work, 1 for a full stroke at the median load."""
        up = np.maximum(np.diff(self.contraction_mm, prepend=self.contraction_mm[0]), 0.0)
        return np.cumsum(self.load * up) / self.span_mm

    @cached_property
    def travel(self) -> Array:
        """Sliding of strand on strand under pressure, 1 for half a full stroke at the median load."""
        way = np.abs(np.diff(self.turns, prepend=self.turns[0])) / self.top
        return np.cumsum(way * self.squeeze) * 3.0
