"""A magnetic scale is unevenly magnetised: the sensor errs with a period of its way. No library holds it.

Source: the law is this rig's own; errors of sensors of displacement: Webster, The Measurement, Instrumentation and
Sensors Handbook, 1999.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived


class Model(Effect):
    """A field of which the third harmonic leaks into the reading once every `pole_mm`, more towards one end."""

    acts_on = "reading"

    def __init__(self, error_mm: float = 0.05, pole_mm: float = 2.0, phase_rad: float = 0.0) -> None:
        self.error_mm, self.pole_mm, self.phase_rad = error_mm, pole_mm, phase_rad

    def run(self, lived: Lived) -> Array:
        """The reading minus the truth, in mm."""
        angle = 2.0 * np.pi * lived.reading_mm / self.pole_mm + self.phase_rad
        return np.asarray(self.error_mm * (np.sin(angle) + 0.3 * np.sin(3.0 * angle)))


class Hidden(Concealed):
    """A scale that errs by a twentieth of a millimetre, and more."""

    claim = Claim("displacement", altered_motion.AT_REST, (altered_motion.AT_HALF_SPEED,))
    grows = ("error_mm",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How long the poles are, and where they begin."""
        return {"error_mm": 0.05, "pole_mm": uniform(rng, 1.0, 3.0), "phase_rad": scene.phase_rad}
