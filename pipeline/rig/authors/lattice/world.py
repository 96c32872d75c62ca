"""What happens at the bench on the fine clock, before any hidden effect: twist, load, warmth, and the true string."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pipeline.ground.kinematics import RAD_PER_TURN, loaded_radius, separator_contraction

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Dimensions:
    """Dimensions of a string on its rig, in mm and N/mm."""

    radius_mm: float
    length_mm: float
    stiffness_n_per_mm: float
    torsion_zone_mm: float
    separator_mm: float


@dataclass(frozen=True)
class World:
    """One session: arrays with a value a step of the fine clock.

    `ambient_k` is the room's warmth above its start; `wander` a slow factor about 1 by which real effects vary;
    `stroke` counts from 0, −1 before the first.
    """

    true: Dimensions
    step_s: float
    time_s: Array
    turns: Array
    load_n: Array
    ambient_k: Array
    wander: Array
    stroke: NDArray[np.int64]

    def contraction_mm(self, turns: Array, radius_share: Array | float = 1.0) -> Array:
        """Contraction by the geometry for a twist of the string and a share of the base radius, in mm."""
        radius_mm = self.radius_mm * radius_share
        return separator_contraction(turns * RAD_PER_TURN, self.true.torsion_zone_mm, self.true.separator_mm, radius_mm)

    @cached_property
    def radius_mm(self) -> Array:
        """Radius of the loaded string, in mm."""
        return loaded_radius(self.true.radius_mm, self.true.length_mm, self.true.stiffness_n_per_mm, self.load_n)

    @cached_property
    def base_mm(self) -> Array:
        """Contraction without any hidden effect, in mm."""
        return self.contraction_mm(self.turns)

    @cached_property
    def rate(self) -> Array:
        """Twisting rate in turns/s."""
        return np.asarray(np.gradient(self.turns, self.step_s))

    @cached_property
    def slope(self) -> Array:
        """Tangent of the helix angle, y/d."""
        return (self.true.separator_mm + RAD_PER_TURN * self.turns * self.radius_mm) / self.true.torsion_zone_mm

    @cached_property
    def lever(self) -> Array:
        """Sine of the helix angle over its greatest value: how well the twist is geared to the load, 0 to 1."""
        sine = self.slope / np.hypot(1.0, self.slope)
        return np.asarray(sine / sine.max())

    @cached_property
    def pull(self) -> Array:
        """Load over the session's mean load."""
        return np.asarray(self.load_n / self.load_n.mean())

    @cached_property
    def torque(self) -> Array:
        """Torque that the load asks of the shaft, over its greatest value."""
        torque = self.load_n * self.lever
        return np.asarray(torque / torque.max())

    @cached_property
    def top_turns(self) -> float:
        """The greatest twist of the session, in turns."""
        return float(self.turns.max())

    @cached_property
    def span_mm(self) -> float:
        """The greatest contraction of the session, from its start, in mm."""
        return float(self.base_mm.max() - self.base_mm[0])

    @cached_property
    def work(self) -> Array:
        """Work done on the load so far, in full strokes at the mean load."""
        lifted_mm = np.maximum(np.diff(self.base_mm, prepend=self.base_mm[0]), 0.0)
        return np.asarray(np.cumsum(self.pull * lifted_mm) / self.span_mm)

    @cached_property
    def travel(self) -> Array:
        """Rubbing so far: load times lever times twist, in full windings and unwindings at the mean load."""
        rubbed = np.abs(np.diff(self.turns, prepend=self.turns[0])) * self.pull * self.lever
        return np.asarray(np.cumsum(rubbed) / self.top_turns)

    @property
    def strokes(self) -> int:
        """How many strokes the session has."""
        return int(self.stroke.max()) + 1

    def at(self, where: Array) -> NDArray[np.int64]:
        """Steps at which the given times, in s, are reached."""
        return np.clip(np.searchsorted(self.time_s, where), 0, len(self.time_s) - 1)
