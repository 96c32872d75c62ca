"""Friction of string on string that grows as the strands rub each other rough."""

from dataclasses import replace

import numpy as np

from ...ground.kinematics import RAD_PER_TURN, Array
from ..effect import Lived
from ..effects import friction_hysteresis


class Model(friction_hysteresis.Model):
    """Dahl's friction, 1 + gain · (1 − exp(−N / rough_turns)) times as strong after N turns there and back."""

    def __init__(self, turns_per_n: float, reach_turns: float, gain: float, rough_turns: float) -> None:
        super().__init__(turns_per_n, reach_turns)
        self.gain, self.rough_turns, self.turned = gain, rough_turns, 0.0

    def run(self, lived: Lived) -> Array:
        """Twist held back, in rad, shape (steps,)."""
        turned = self.turned + np.cumsum(np.abs(lived.turned_rad)) / RAD_PER_TURN
        self.turned = float(turned[-1])
        stronger = 1.0 - self.gain * np.expm1(-turned / self.rough_turns)
        return super().run(replace(lived, load_n=lived.load_n * stronger))
