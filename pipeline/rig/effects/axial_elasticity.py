"""The string is longer under a larger load, first by drawing its crimp straight.

Source: the law is this rig's own; it is like the toe of a rope in McKenna, Hearle and O'Hear, Handbook of Fibre Rope
Technology, 2004.
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, settle


class Model(Effect):
    """Fibres that come to bear one after the other: of a stretch δ the share δ/(δ + toe) bears, F = δ²/(δ + toe)/c.

    c is `compliance_mm_per_n`, and the toe is what the string gives under `toe_n`; δ is solved from the load. The
    share `late` of δ comes after it by the time constant `late_s`, an elastic after-effect; the first load is old.
    """

    acts_on = "length"

    def __init__(
        self, compliance_mm_per_n: float = 0.03, toe_n: float = 4.0, late: float = 0.0, late_s: float = 5.0
    ) -> None:
        self.compliance_mm_per_n, self.toe_n, self.late, self.late_s = compliance_mm_per_n, toe_n, late, late_s
        self.state = np.array([np.nan])

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        load_n, stretch_n = lived.load_n, lived.load_n + self.toe_n
        for _ in range(6):  # Newton on δ² = F (δ + toe), all in N
            stretch_n = stretch_n - (stretch_n**2 - load_n * (stretch_n + self.toe_n)) / (2.0 * stretch_n - load_n)
        if np.isnan(self.state[0]):
            self.state[0] = stretch_n[0]
        late_n = settle(stretch_n, -math.expm1(-lived.step_s / self.late_s), self.state)
        return np.asarray(self.compliance_mm_per_n * ((1.0 - self.late) * stretch_n + self.late * late_n))


class Hidden(Concealed):
    """A string as soft as fibres and toe make it."""

    claim = Claim("load", altered_motion.UNDER_ONE_LOAD, (altered_motion.AT_HALF_SPEED, altered_motion.NEVER_UNWOUND))
    grows = ("compliance_mm_per_n",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """The toe in shares of the usual load."""
        return {
            "compliance_mm_per_n": 0.02,
            "toe_n": uniform(rng, 1.0, 3.0) * scene.load_n,
            "late": uniform(rng, 0.08, 0.12),
            "late_s": uniform(rng, 4.0, 8.0),
        }
