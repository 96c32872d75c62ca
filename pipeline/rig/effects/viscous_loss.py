"""Strands that are twisted fast resist it, and the string is longer while they do.

Source: Bird, Armstrong and Hassager, Dynamics of Polymeric Liquids, 1977 (a power of the rate, and a stress that
settles).
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, settle


class Model(Effect):
    """A shear-thinning fluid between the strands: its stress σ settles to the rate of twisting ω to a power, in time.

    settle_s · dσ/dt = sign(ω) |ω|^thinning − σ with ω in turns/s; the string is mm_per_rate · σ longer.
    """

    acts_on = "length"

    def __init__(self, mm_per_rate: float = 0.05, thinning: float = 0.8, settle_s: float = 0.04) -> None:
        self.mm_per_rate, self.thinning, self.settle_s = mm_per_rate, thinning, settle_s
        self.stress = np.zeros(1)

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        turns_per_s = lived.turned_rad / (2.0 * np.pi) / lived.step_s
        loss_target = np.sign(turns_per_s) * np.abs(turns_per_s) ** self.thinning
        return self.mm_per_rate * settle(loss_target, -math.expm1(-lived.step_s / self.settle_s), self.stress)


class Hidden(Concealed):
    """Strands with something between them that resists."""

    claim = Claim("twisting rate", altered_motion.INFINITELY_SLOWLY, (altered_motion.UNDER_TWICE_THE_LOAD,))
    grows, wanders = ("mm_per_rate",), 0.015

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """What kind of fluid it is."""
        return {"mm_per_rate": 0.03, "thinning": uniform(rng, 0.7, 0.85), "settle_s": uniform(rng, 0.02, 0.06)}
