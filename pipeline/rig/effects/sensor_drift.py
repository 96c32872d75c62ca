"""The displacement sensor's zero drifts as its electronics warm and age."""

import numpy as np

from ...ground.kinematics import Array
from ..effect import Effect, Lived


class Model(Effect):
    """A zero that ages ever more slowly: dz/dt = mm_per_hour / (1 + t/settle_s)^ageing, whatever the rig does."""

    acts_on = "reading"

    def __init__(self, mm_per_hour: float = 2.0, settle_s: float = 150.0, ageing: float = 0.6) -> None:
        self.mm_per_s, self.settle_s, self.ageing = mm_per_hour / 3600.0, settle_s, ageing
        self.time_s, self.zero_mm = 0.0, 0.0

    def run(self, lived: Lived) -> Array:
        """What the sensor says too much, in mm."""
        time_s = self.time_s + lived.step_s * np.arange(len(lived.reading_mm))
        rate = self.mm_per_s / (1.0 + time_s / self.settle_s) ** self.ageing
        zero_mm = self.zero_mm + np.cumsum(rate) * lived.step_s
        self.time_s, self.zero_mm = float(time_s[-1]) + lived.step_s, float(zero_mm[-1])
        return zero_mm
