"""The displacement sensor is late.

Source: Åström and Hägglund, PID Controllers, 1995 (dead time and two poles).
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene
from ..effect import Effect, Lived, settle


class Model(Effect):
    """A conversion that takes time, then two filters: dead time and two poles, together `lag_s` long.

    The dead time is half of the lag, the slower filter three fifths of the rest.
    """

    acts_on = "reading"

    def __init__(self, lag_s: float = 0.06) -> None:
        self.dead_s, self.poles_s = 0.5 * lag_s, (0.3 * lag_s, 0.2 * lag_s)
        self.before_mm: Array | None = None  # what the dead time still holds
        self.filtered_mm = [np.zeros(1) for _ in self.poles_s]

    def run(self, lived: Lived) -> Array:
        """The reading minus the truth, in mm."""
        line_steps = math.ceil(self.dead_s / lived.step_s) + 1
        if self.before_mm is None:
            self.before_mm = np.full(line_steps, lived.reading_mm[0])
            for state in self.filtered_mm:
                state[:] = lived.reading_mm[0]
        line_mm = np.concatenate([self.before_mm, lived.reading_mm])
        self.before_mm = line_mm[-line_steps:]
        now = np.arange(line_steps, len(line_mm))
        late_mm = np.interp(now - self.dead_s / lived.step_s, np.arange(len(line_mm)), line_mm)
        for pole_s, state in zip(self.poles_s, self.filtered_mm, strict=True):
            late_mm = settle(late_mm, -math.expm1(-lived.step_s / pole_s), state)
        return np.asarray(late_mm - lived.reading_mm)


class Hidden(Concealed):
    """A reading that is late by six hundredths of a second, and more."""

    claim = Claim("displacement rate", altered_motion.INFINITELY_SLOWLY, (altered_motion.UNDER_TWICE_THE_LOAD,))
    grows, most, wanders = ("lag_s",), 0.5, 0.044

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Nothing is drawn."""
        return {"lag_s": 0.06}
