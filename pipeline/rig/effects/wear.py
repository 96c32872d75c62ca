"""The strands rub each other thinner, the more way they make on each other.

Source: Archard, "Contact and rubbing of flat surfaces", Journal of Applied Physics 24, 1953; the sharp asperities are
this rig's own.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Archard's wear of a rough surface: over a way ds the radius loses share_per_m · (F / 20 N)^press · rough · ds.

    The strands slip on each other by ds = r sin α |dθ|. Sharp asperities go first: rough = 1 + edge · u, with
    du/ds = −u² / first_m. The radius follows the travel alone, whichever way and however fast it is made.
    """

    acts_on = "radius"

    def __init__(self, share_per_m: float = 0.05, edge: float = 0.6, first_m: float = 0.1, press: float = 0.3) -> None:
        self.share_per_mm, self.edge, self.first_mm, self.press = share_per_m / 1e3, edge, first_m * 1e3, press
        self.state = np.array([1.0, 1.0, np.nan])  # what is left of the radius, sharpness, twist of the step before

    def run(self, lived: Lived) -> Array:
        """Factor on the radius."""
        if np.isnan(self.state[2]):
            self.state[2] = lived.twist_rad[0]
        way_rad = np.abs(np.diff(lived.twist_rad, prepend=self.state[2]))
        self.state[2] = lived.twist_rad[-1]
        tangent = (lived.geometry.separator_mm + lived.twist_rad * lived.radius_mm) / lived.geometry.torsion_zone_mm
        way_mm = lived.radius_mm * tangent / np.hypot(1.0, tangent) * way_rad
        pressed = (lived.load_n / 20.0) ** self.press
        return _rub(way_mm, self.share_per_mm * pressed, self.edge, self.first_mm, self.state)


@compiled
def _rub(way_mm: Array, share_per_mm: Array, edge: float, first_mm: float, state: Array) -> Array:
    out = np.empty(len(way_mm))
    for step in range(len(way_mm)):
        state[1] /= 1.0 + state[1] * way_mm[step] / first_mm
        state[0] -= share_per_mm[step] * way_mm[step] * (1.0 + edge * state[1])
        out[step] = state[0]
    return out


class Hidden(Concealed):
    """A radius that falls by three hundredths a metre, and more; worn fibres may fuzz instead."""

    claim = Claim("travel", altered_motion.WOUND_UP_ONCE, (altered_motion.AT_HALF_SPEED,))
    grows, either_sign, wanders = ("share_per_m",), True, 0.030

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How sharp the asperities are, and for how long."""
        return {"share_per_m": 0.03, "edge": uniform(rng, 0.3, 0.8), "first_m": uniform(rng, 0.05, 0.15)}
