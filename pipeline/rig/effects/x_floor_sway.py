"""The building sways: the reading goes to and fro in time, whatever the rig does. No library holds it.

Source: Rayleigh, The Theory of Sound, 1877 (beats).
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived


class Model(Effect):
    """Two modes of a floor that beat against each other, seen by a sensor that stands on it."""

    acts_on = "reading"

    def __init__(self, sway_mm: float = 0.05, frequency_hz: float = 0.31, phase_rad: float = 0.0) -> None:
        self.sway_mm, self.frequency_hz, self.phase_rad = sway_mm, frequency_hz, phase_rad
        self.time_s = 0.0

    def run(self, lived: Lived) -> Array:
        """The reading minus the truth, in mm."""
        time_s = self.time_s + lived.step_s * np.arange(len(lived.reading_mm))
        self.time_s = float(time_s[-1]) + lived.step_s
        angle = 2.0 * np.pi * self.frequency_hz * time_s + self.phase_rad
        return np.asarray(self.sway_mm * (np.sin(angle) + 0.5 * np.sin(1.083 * angle)))


class Hidden(Concealed):
    """A floor that moves by a twentieth of a millimetre, and more."""

    claim = Claim("time", altered_motion.IN_NO_TIME, (altered_motion.UNDER_TWICE_THE_LOAD, altered_motion.AT_REST))
    grows = ("sway_mm",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How fast the floor sways."""
        return {"sway_mm": 0.05, "frequency_hz": uniform(rng, 0.15, 0.6), "phase_rad": scene.phase_rad}
