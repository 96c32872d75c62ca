"""The load's slider sticks, is drawn along and slips, in steps, where it moves slowly.

Source: the law is this rig's own; that a grip grows with the time stood: Rabinowicz, "The nature of the static and
kinetic coefficients of friction", Journal of Applied Physics 22, 1951.
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled

SPEED_S = 0.02  # over which the speed is taken


class Model(Effect):
    """A slider on a spring that grips harder the longer it stands and floats on its film when it is drawn fast.

    It stands until the spring is stretched by more than step_mm · grip · film, then jumps nearly as far past
    its balance (`rebound`). The grip grows from `fresh` to 1 with the time stood over `age_s` as t/(t + age_s);
    the film bears the slider as 1/(1 + (v/float_mm_per_s)⁶) at the speed v of the string's end.
    """

    acts_on = "contraction"

    def __init__(
        self,
        step_mm: float = 0.15,
        float_mm_per_s: float = 3.0,
        age_s: float = 0.3,
        fresh: float = 0.92,
        rebound: float = 0.9,
    ) -> None:
        self.settings = (step_mm, float_mm_per_s, age_s, fresh, rebound)
        self.state = np.array([np.nan, 0.0, 0.0, 0.0])  # slider, time stood, string's end and its speed

    def run(self, lived: Lived) -> Array:
        """How far the slider is behind the string's end, in mm."""
        if math.isnan(self.state[0]):
            self.state[0] = self.state[2] = lived.contraction_mm[0]
        return _stick(lived.contraction_mm, lived.step_s, self.settings, self.state)


@compiled
def _stick(contraction_mm: Array, step_s: float, settings: tuple[float, ...], state: Array) -> Array:
    step_mm, float_mm_per_s, age_s, fresh, rebound = settings
    out = np.empty(len(contraction_mm))
    for step in range(len(contraction_mm)):
        string_mm = contraction_mm[step]
        speed = abs(string_mm - state[2]) / step_s
        state[2] = string_mm
        state[3] += (speed - state[3]) * (1.0 - math.exp(-step_s / SPEED_S))
        state[1] += step_s
        grip = fresh + (1.0 - fresh) * state[1] / (state[1] + age_s)
        gap_mm = string_mm - state[0]
        if abs(gap_mm) > step_mm * grip / (1.0 + (state[3] / float_mm_per_s) ** 6):
            state[0], state[1] = string_mm + rebound * gap_mm, 0.0
        out[step] = string_mm - state[0]
    return out


class Hidden(Concealed):
    """Steps of a tenth of a millimetre, and more."""

    claim = Claim("slow displacement", altered_motion.A_HUNDRED_TIMES_AS_FAST)
    grows, by_chance = ("step_mm",), True

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """At which speed the slider floats, and how fast its grip ages."""
        speed, age_s = scene.stroke_mm / uniform(rng, 4.0, 8.0), uniform(rng, 0.2, 0.6)
        return {"step_mm": 0.1, "float_mm_per_s": speed, "age_s": age_s}
