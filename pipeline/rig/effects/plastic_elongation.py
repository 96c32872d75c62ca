"""Winding under load stretches a string for good, ever less as it is worked.

Source: the law is this rig's own; that ropes bed in: McKenna, Hearle and O'Hear, Handbook of Fibre Rope Technology,
2004.
"""

from collections.abc import Sequence

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Populations of fibres that yield as the strands are pressed past each other, each until it is exhausted.

    Population i has stretch_mm[i] to give at the start and loses a share dW / work_n_mm[i] of what is left for
    every dW = F sin α dx of contact work (contact force times contraction) in winding; unwinding does none.
    """

    acts_on = "length"

    def __init__(self, stretch_mm: Sequence[float], work_n_mm: Sequence[float]) -> None:
        if len(stretch_mm) != len(work_n_mm):
            raise TypeError("stretch_mm and work_n_mm must have one value for each population")
        self.left_mm = np.array(stretch_mm, float)
        self.work_n_mm = np.array(work_n_mm, float)
        self.given_mm = np.zeros(1)

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        work_n_mm = lived.load_n * np.maximum(lived.advance_mm, 0.0) * lived.helix_sine
        return _yield(work_n_mm, self.work_n_mm, self.left_mm, self.given_mm)


@compiled
def _yield(work_n_mm: Array, capacity_n_mm: Array, left_mm: Array, given_mm: Array) -> Array:
    out = np.empty(len(work_n_mm))
    for step in range(len(work_n_mm)):
        for population in range(len(left_mm)):
            # implicit: never more than there is
            share = work_n_mm[step] / (capacity_n_mm[population] + work_n_mm[step])
            yielded_mm = left_mm[population] * share
            left_mm[population] -= yielded_mm
            given_mm[0] += yielded_mm
        out[step] = given_mm[0]
    return out


class Hidden(Concealed):
    """A string that stretches by four tenths of a millimetre in all, and more."""

    claim = Claim("worked strokes", altered_motion.WOUND_UP_ONCE, (altered_motion.AT_HALF_SPEED,))
    grows, wanders = ("stretch_mm",), 0.010

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Three populations that are exhausted within a stroke, in one or two, and in many."""
        shares = rng.dirichlet([3.0, 3.0, 3.0])
        strokes = np.array([uniform(rng, 0.2, 0.5), uniform(rng, 0.8, 2.0), uniform(rng, 4.0, 10.0)])
        return {"stretch_mm": (0.4 * shares).tolist(), "work_n_mm": (scene.work_n_mm * strokes).tolist()}
