"""What an effect of the string is: a small machine with a state, stepped in time, that acts on one quantity."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Literal

from pipeline.kinematics import Geometry


@dataclass(slots=True)
class Now:
    """What the string undergoes in one step; the string fills it in the order of its fields.

    Twist effects see the motor's twist, radius effects the string's as well, length effects everything.
    """

    geometry: Geometry  # the true dimensions, scalars
    step_s: float
    load_n: float = 0.0
    turned_rad: float = 0.0  # what the motor turned in this step
    twist_rad: float = 0.0  # the motor's, then the string's once the twist effects have acted
    radius_mm: float = 0.0  # under load; then as the radius effects leave it
    helix_tangent: float = 0.0  # of the helix angle, with the radius of the step before for radius effects
    advance_mm: float = 0.0  # what the helix contracted in this step


class Effect(ABC):
    """One effect: its parameters are the arguments of its making, its state lasts as long as the string."""

    acts_on: ClassVar[Literal["twist", "radius", "length"]]

    @abstractmethod
    def step(self, now: Now) -> float:
        """Advance the state by one step and return what the effect does now.

        A twist effect returns the twist that the string has less than the motor, in rad; a radius effect the
        factor on the radius; a length effect the lengthening of the string, in mm.
        """
