"""The interface of an effect: a small machine with a state, stepped in time, that acts on one quantity of the rig."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np
from numba import njit

from ..ground.kinematics import Array, Geometry

ActsOn = Literal["twist", "radius", "length", "contraction", "reading"]
compiled = njit(cache=True)  # for loops over the steps; compiled once a machine


@dataclass(slots=True)
class Lived:
    """A stretch of time on the rig: arrays of shape (steps,), filled in the order of their fields."""

    geometry: Geometry  # the true dimensions, scalars
    step_s: float
    load_n: Array
    turned_rad: Array  # what the motor turned in each step
    twist_rad: Array  # the motor's, then as each twist effect leaves it
    radius_mm: Array  # under load, then as each radius effect leaves it
    helix_tangent: Array  # of the helix angle, without a unit
    helix_mm: Array  # contraction of the helix, as the twist and the radius make it
    advance_mm: Array  # what the helix contracted in each step
    contraction_mm: Array  # the helix' less what the string is longer, then as each contraction effect leaves it
    reading_mm: Array  # what the displacement sensor says, before noise
    temperature_c: Array  # what a thermocouple on the string would say

    @property
    def helix_sine(self) -> Array:
        """Sine of the helix angle. Shape (steps,), without a unit."""
        return self.helix_tangent / np.hypot(1.0, self.helix_tangent)


class Effect(ABC):
    """One effect: its parameters are the arguments of its making, its state lasts as long as the string."""

    acts_on: ClassVar[ActsOn]

    @abstractmethod
    def run(self, lived: Lived) -> Array:
        """Advance the state through a stretch of time and return what the effect does after each of its steps.

        A twist effect returns the twist that the string has less than the motor, in rad; a radius effect the
        factor on the radius; a length effect the lengthening of the string and a contraction effect what the
        load moves less than the string pulls, in mm; a reading effect what the sensor says too much, in mm.
        Shape (steps,).
        """


@compiled
def settle(target: Array, share: float, state: Array) -> Array:
    """A state that closes a share of its gap to its target in every step; of the shape of `target`.

    Shape (steps,), in the target's unit; `share` is one of 1.
    """
    out = np.empty(len(target))
    for step in range(len(target)):
        state[0] += (target[step] - state[0]) * share
        out[step] = state[0]
    return out
