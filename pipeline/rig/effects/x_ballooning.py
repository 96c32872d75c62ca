"""A string that is spun fast bows out and so is shorter, whichever way it turns. No library holds it.

Source: the law is this rig's own; that a spun thread bows out: Padfield, "The motion and tension of an unwinding
thread", Proceedings of the Royal Society A 245, 1958.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, settle


class Model(Effect):
    """Bowing by the centrifugal force, which builds up within `settle_s`: the string is mm_per_rate2 · ω² shorter."""

    acts_on = "length"

    def __init__(self, mm_per_rate2: float = 0.05, settle_s: float = 0.1) -> None:
        self.mm_per_rate2, self.settle_s = mm_per_rate2, settle_s
        self.bow = np.zeros(1)

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm, which is negative."""
        target = (lived.turned_rad / (2.0 * np.pi) / lived.step_s) ** 2
        return -self.mm_per_rate2 * settle(target, -np.expm1(-lived.step_s / self.settle_s), self.bow)


class Hidden(Concealed):
    """A bow of a hundredth of a millimetre at a turn a second, and more."""

    claim = Claim("twisting rate squared", altered_motion.INFINITELY_SLOWLY, (altered_motion.UNDER_TWICE_THE_LOAD,))
    grows = ("mm_per_rate2",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How soon it bows."""
        return {"mm_per_rate2": 0.01, "settle_s": uniform(rng, 0.05, 0.2)}
