"""How a bench conceals an effect: its drawn parameters, its growth with strength, and the claims of its name."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from ..ground.kinematics import Array, Geometry
from .altered_motion import Otherwise
from .motion_commands import Commands
from .wandering_strength import Waves

Parameter = float | list[float] | tuple[float, float] | Waves
# arguments of an effect's `Model`: numbers, or lists of them; and its `unsteady` waves
Parameters = dict[str, Parameter]


@dataclass(frozen=True)
class Claim:
    """The claims of an effect: its driver, a motion in which the effect stands still, motions that change nothing."""

    driver: str
    frozen: Otherwise
    indifferent: tuple[Otherwise, ...] = ()


@dataclass(frozen=True)
class Scene:
    """The bench and the motion that an effect is drawn for."""

    geometry: Geometry  # as it truly is
    load_n: float  # the usual load
    top_turns: float
    stroke_mm: float  # what the string contracts from untwisted to wound up
    torque_n_mm: float  # of the string when it is wound up under the usual load
    commands: Commands
    step_s: float
    phase_rad: float  # drawn evenly, for whatever is periodic

    @property
    def lasts_s(self) -> float:
        """Length of the recording."""
        return float(self.commands.time_s[-1])

    @property
    def work_n_mm(self) -> float:
        """Work of a whole stroke under the usual load."""
        return self.load_n * self.stroke_mm

    def lives(self, tires: Array, events: int, rng: np.random.Generator) -> list[float]:
        """Damage at which events happen, so that they fall between a fifth and three quarters of the recording.

        `tires`, of shape (steps,), is what tires the part, in damage a second.
        """
        damage = np.cumsum(tires) * self.step_s
        at = np.sort(rng.uniform(0.2, 0.75, events)) * (len(damage) - 1)
        return [float(life) for life in damage[at.astype(int)]]


class Concealed(ABC):
    """One effect as a bench conceals it; a strength of 1 is a size that is often met."""

    claim: ClassVar[Claim]
    grows: ClassVar[tuple[str, ...]] = ()  # parameters in proportion to the strength
    most: ClassVar[float] = np.inf  # of each of those: beyond it would be another thing
    either_sign: ClassVar[bool] = False
    by_chance: ClassVar[bool] = False  # sudden events: no fit of the past knows the next one
    # How far the strength wanders, rms: no formula of few numbers, whosever it is, may fit an effect without
    # remainder (`python -m pipeline.proof.twins`). What leaves enough as it is stays at 0.
    wanders: ClassVar[float] = 0.0

    @abstractmethod
    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Parameters at a strength of 1; what is left out stays at the effect's own default."""

    def at(self, drawn: Parameters, strength: float, scene: Scene) -> Parameters:
        """Parameters at a strength, which is negative where the effect goes the other way."""
        parameters = dict(drawn)
        for key in self.grows:
            parameters[key] = np.minimum(np.multiply(np.asarray(drawn[key]), strength), self.most).tolist()
        return parameters

    def claims(self, parameters: Parameters) -> Claim:
        """What the effect claims with these parameters."""
        return self.claim

    def warms_the_room(self, parameters: Parameters) -> bool:
        """Whether nobody can know the effect without a thermometer."""
        return False


def number(parameters: Parameters, key: str) -> float:
    """A parameter that is one number; raises TypeError for another."""
    value = parameters[key]
    if not isinstance(value, float | int):
        raise TypeError(f"{key} is no number")
    return value


def numbers(parameters: Parameters, key: str) -> list[float]:
    """A parameter that is a list of numbers; raises TypeError for another."""
    value = parameters[key]
    if not isinstance(value, list):
        raise TypeError(f"{key} is no list of numbers")
    return value


def uniform(rng: np.random.Generator, low: float, high: float) -> float:
    """A number between two, all of them equally likely."""
    return float(rng.uniform(low, high))
