"""The displacement sensor's zero drifts as its electronics warm and age.

Source: Utsu, Ogata and Matsu'ura, "The centenary of the Omori formula for a decay law of aftershock activity", Journal
of Physics of the Earth 43, 1995 (a rate that falls so); that a zero does so is this rig's own.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived


class Model(Effect):
    """A zero that ages ever more slowly: dz/dt = mm_per_hour / (1 + t/settle_s)^ageing, whatever the rig does."""

    acts_on = "reading"

    def __init__(self, mm_per_hour: float = 2.0, settle_s: float = 150.0, ageing: float = 0.6) -> None:
        self.mm_per_s, self.settle_s, self.ageing = mm_per_hour / 3600.0, settle_s, ageing
        self.time_s, self.zero_mm = 0.0, 0.0

    def run(self, lived: Lived) -> Array:
        """The reading minus the truth, in mm."""
        time_s = self.time_s + lived.step_s * np.arange(len(lived.reading_mm))
        rate = self.mm_per_s / (1.0 + time_s / self.settle_s) ** self.ageing
        zero_mm = self.zero_mm + np.cumsum(rate) * lived.step_s
        self.time_s, self.zero_mm = float(time_s[-1]) + lived.step_s, float(zero_mm[-1])
        return zero_mm


class Hidden(Concealed):
    """A zero that moves by a millimetre an hour, and more, either way."""

    claim = Claim("time", altered_motion.IN_NO_TIME, (altered_motion.UNDER_TWICE_THE_LOAD, altered_motion.AT_REST))
    grows, either_sign, wanders = ("mm_per_hour",), True, 0.017

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How soon it calms down."""
        return {"mm_per_hour": 1.0, "settle_s": uniform(rng, 80.0, 250.0), "ageing": uniform(rng, 0.3, 0.8)}
