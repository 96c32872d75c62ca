"""A string that is worked grows stiffer: under the same load it is less long than it was.

Source: the law is this rig's own; that yarns get stiffer as their fibres lock: Hearle, Grosberg and Backer, Structural
Mechanics of Fibers, Yarns, and Fabrics, 1969.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Fibre contacts that lock as the string is worked: dm/dW = (1 − m)^order / work_n_mm, dW = F |dx|.

    A string with a share m of its contacts locked is 1 + gain · m times as stiff as the new one, whose
    compliance is `compliance_mm_per_n`.
    """

    acts_on = "length"

    def __init__(
        self, compliance_mm_per_n: float = 0.06, gain: float = 0.4, work_n_mm: float = 800.0, order: float = 3.0
    ) -> None:
        self.compliance_mm_per_n, self.gain = compliance_mm_per_n, gain
        self.work_n_mm, self.order = work_n_mm, order
        self.unlocked = np.ones(1)

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm, which is negative."""
        work = lived.load_n * np.abs(lived.advance_mm) / self.work_n_mm
        locked = _lock(work, self.order, self.unlocked)
        softer = 1.0 / (1.0 + self.gain * locked) - 1.0
        return np.asarray(self.compliance_mm_per_n * lived.load_n * softer)


@compiled
def _lock(work: Array, order: float, unlocked: Array) -> Array:
    out = np.empty(len(work))
    for step in range(len(work)):
        unlocked[0] /= 1.0 + work[step] * unlocked[0] ** (order - 1.0)  # implicit: never below nothing
        out[step] = 1.0 - unlocked[0]
    return out


class Hidden(Concealed):
    """A string that grows up to half as stiff again."""

    claim = Claim("worked strokes, under load", altered_motion.WITHOUT_LOAD, (altered_motion.AT_HALF_SPEED,))
    grows = ("compliance_mm_per_n",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """By how much, within how many strokes, and how abruptly."""
        return {
            "compliance_mm_per_n": 0.03,
            "gain": uniform(rng, 0.3, 0.6),
            "work_n_mm": scene.work_n_mm * uniform(rng, 2.0, 6.0),
            "order": uniform(rng, 2.0, 3.5),
        }
