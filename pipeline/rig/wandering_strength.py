"""The strength of an effect wanders by a few per cent, with air, dust and the string's lay."""

from collections.abc import Sequence
from typing import TypedDict

import numpy as np

from ..ground.kinematics import Array
from .effect import Effect, Lived


class Waves(TypedDict):
    """How a strength wanders: of each wave its share of the strength, its period in s and its phase in rad."""

    shares: list[float]
    periods_s: list[float]
    phases_rad: list[float]


class Unsteady(Effect):
    """An effect whose strength is 1 + w(t) of what its equations say, w = Σ share_i · sin(2π t / period_s_i + phase_i).

    The equations of the effect itself know nothing of it.
    """

    def __init__(
        self, effect: Effect, shares: Sequence[float], periods_s: Sequence[float], phases_rad: Sequence[float]
    ) -> None:
        if not len(shares) == len(periods_s) == len(phases_rad):
            raise TypeError("shares, periods_s and phases_rad must have one value for each wave")
        self.effect, self.acts_on = effect, effect.acts_on  # type: ignore[misc]
        self.waves = list(zip(shares, periods_s, phases_rad, strict=True))
        self.time_s = 0.0

    def run(self, lived: Lived) -> Array:
        """The output of the effect, in its own unit; a factor on the radius wanders about 1."""
        does = self.effect.run(lived)
        time_s = self.time_s + lived.step_s * np.arange(len(does))
        self.time_s += lived.step_s * len(does)
        strength = 1.0 + sum(
            share * np.sin(2.0 * np.pi * time_s / period + phase) for share, period, phase in self.waves
        )
        around = 1.0 if self.acts_on == "radius" else 0.0
        return np.asarray(around + (does - around) * strength)
