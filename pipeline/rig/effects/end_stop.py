"""The load runs into a stop: it goes no further, however much is twisted.

Source: Johnson, Contact Mechanics, 1985 (a ball that is pressed in, after Hertz).
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """A rubber stop met by a string that gives way: bumper · p^1.5 = stretch · (x − at − p) for the way p into it.

    p is what the contact force of a ball (Hertz) and the string's own stretch leave of the way past `at_mm`
    (contraction of the string above its untwisted state); both in N/mm, and `bumper` in N/mm^1.5.
    """

    acts_on = "contraction"

    def __init__(self, at_mm: float = 10.0, bumper: float = 400.0, stretch_n_per_mm: float = 15.0) -> None:
        self.at_mm, self.ratio = at_mm, bumper / stretch_n_per_mm

    def run(self, lived: Lived) -> Array:
        """How much less the load moves than the string contracts, in mm."""
        geometry = lived.geometry
        lowest_mm = np.hypot(geometry.torsion_zone_mm, geometry.separator_mm) - geometry.torsion_zone_mm
        past_mm = np.maximum(lived.contraction_mm - lowest_mm - self.at_mm, 0.0)
        return np.asarray(past_mm - _dent(past_mm, self.ratio))


@compiled
def _dent(past_mm: Array, ratio: float) -> Array:
    """Way into the stop: the p with p + ratio · p^1.5 = past; by Newton in √p, of the shape of `past_mm`."""
    out = np.zeros(len(past_mm))
    for step in range(len(past_mm)):
        if past_mm[step] > 0.0:
            root = np.sqrt(past_mm[step])  # above the solution, whence Newton walks down to it
            for _ in range(30):
                root -= (root**2 + ratio * root**3 - past_mm[step]) / (2.0 * root + 3.0 * ratio * root**2)
            out[step] = root * root
    return out


class Hidden(Concealed):
    """A stop in the last hundredths of the stroke, and further in."""

    claim = Claim("large displacement", altered_motion.HALF_WOUND, (altered_motion.AT_HALF_SPEED,))
    wanders = 0.035

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How hard the rubber is."""
        return {"bumper": uniform(rng, 100.0, 400.0), "stretch_n_per_mm": scene.geometry.stiffness_n_per_mm}

    def at(self, drawn: Parameters, strength: float, scene: Scene) -> Parameters:
        """The stronger, the sooner it is met."""
        return {**drawn, "at_mm": scene.stroke_mm * (1.0 - min(0.03 * strength, 0.9))}
