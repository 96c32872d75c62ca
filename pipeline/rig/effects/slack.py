"""A string that hangs through: the first twist takes up the slack and moves nothing.

Source: the law is this rig's own; with a hardness of 1.5 the bed is a ball after Hertz, in Johnson, Contact Mechanics,
1985.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """A load that rests on a rubber bed until the string, `take_up_mm` too long, has taken its weight over.

    At the rise y the bed still bears F (1 − y/bed)^hardness and the string stretch_n_per_mm times the gap between what
    it asks for and y less than F; y is where the two bear F together, and is solved for at every step.
    """

    acts_on = "contraction"

    def __init__(
        self,
        take_up_mm: float = 0.5,
        bed_mm: float = 0.08,
        hardness: float = 1.5,
        stretch_n_per_mm: float = 60.0,
    ) -> None:
        self.take_up_mm, self.bed_mm, self.hardness = take_up_mm, bed_mm, hardness
        self.stretch_n_per_mm = stretch_n_per_mm

    def run(self, lived: Lived) -> Array:
        """How much less the load rises than the string contracts, in mm."""
        geometry = lived.geometry
        lowest_mm = np.hypot(geometry.torsion_zone_mm, geometry.separator_mm) - geometry.torsion_zone_mm
        asked_mm = lived.contraction_mm - lowest_mm - self.take_up_mm
        softness = lived.load_n / self.stretch_n_per_mm
        return np.asarray(lived.contraction_mm - lowest_mm - _lift(asked_mm, softness, self.bed_mm, self.hardness))


@compiled
def _lift(asked_mm: Array, softness_mm: Array, bed_mm: float, hardness: float) -> Array:
    """Rise of the load for what the string asks, both from the bed, in mm; by bisection, of the shape of `asked_mm`."""
    out = np.empty(len(asked_mm))
    for step in range(len(asked_mm)):
        low, high = 0.0, bed_mm
        if asked_mm[step] >= bed_mm:
            out[step] = asked_mm[step]
            continue
        for _ in range(40):
            rise = 0.5 * (low + high)
            bed = (1.0 - rise / bed_mm) ** hardness
            string = min((rise - asked_mm[step]) / softness_mm[step], 1.0)  # share of the load that it misses
            if string < bed:
                low = rise
            else:
                high = rise
        out[step] = 0.5 * (low + high)
    return out


class Hidden(Concealed):
    """A string that is four tenths of a millimetre too long, and more."""

    claim = Claim(
        "low twist", altered_motion.NEVER_UNWOUND, (altered_motion.AT_HALF_SPEED, altered_motion.UNDER_TWICE_THE_LOAD)
    )
    grows, wanders = ("take_up_mm", "bed_mm"), 0.020

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How the load leaves its bed."""
        return {"take_up_mm": 0.4, "bed_mm": uniform(rng, 0.1, 0.25), "hardness": uniform(rng, 1.2, 2.0)}
