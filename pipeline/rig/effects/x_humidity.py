"""The string swells and dries with the air's humidity, slowly up and down. No library holds it.

Source: the law is this rig's own; that fibres swell in damp air: Morton and Hearle, Physical Properties of Textile
Fibres, 1962.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, settle


class Model(Effect):
    """An air conditioner that switches at two limits wets and dries the air; the string takes it up within `soak_s`."""

    acts_on = "length"

    def __init__(self, swell_mm: float = 0.2, period_s: float = 90.0, soak_s: float = 20.0, phase: float = 0.0) -> None:
        self.swell_mm, self.period_s, self.soak_s, self.phase = swell_mm, period_s, soak_s, phase
        self.time_s = 0.0
        self.wet = np.zeros(1)

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        time_s = self.time_s + lived.step_s * np.arange(len(lived.load_n))
        self.time_s = float(time_s[-1]) + lived.step_s
        air = np.where((time_s / self.period_s + self.phase) % 1.0 < 0.5, 1.0, -1.0)
        return self.swell_mm * settle(air, -np.expm1(-lived.step_s / self.soak_s), self.wet)


class Hidden(Concealed):
    """A string that swells by a tenth of a millimetre, and more."""

    claim = Claim("time", altered_motion.IN_NO_TIME, (altered_motion.UNDER_TWICE_THE_LOAD, altered_motion.AT_REST))
    grows = ("swell_mm",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How often the air is wetted, and when first."""
        return {
            "swell_mm": 0.1,
            "period_s": scene.lasts_s * uniform(rng, 0.18, 0.3),
            "phase": uniform(rng, 0.0, 1.0),
        }
