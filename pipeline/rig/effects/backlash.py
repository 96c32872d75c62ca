"""Play in the drive line: after a reversal the string stays where it is until the play is crossed.

Source: Wen, "Method for random vibration of hysteretic systems", Journal of the Engineering Mechanics Division 102,
1976 (with both shape parameters 1/2).
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Two dogs that meet softly: of a turn dθ the string takes |g/w|^firmness when the gap g leans that way, else 0.

    The gap g between motor and string lies within ±w, half of `turns`. Neither load nor speed enters: only the
    way that the motor went.
    """

    acts_on = "twist"

    def __init__(self, turns: float = 0.3, firmness: float = 3.0) -> None:
        self.half_rad = math.pi * turns
        self.firmness = firmness
        self.state = np.array([0.0, np.nan])  # the gap, and the twist of the step before

    def run(self, lived: Lived) -> Array:
        """Gap between motor and string, in rad."""
        if math.isnan(self.state[1]):
            self.state[1] = lived.twist_rad[0]
        return _cross(lived.twist_rad, self.half_rad, self.firmness, self.state)


@compiled
def _cross(twist_rad: Array, half_rad: float, firmness: float, state: Array) -> Array:
    out = np.empty(len(twist_rad))
    for step in range(len(twist_rad)):
        way_rad = twist_rad[step] - state[1]
        state[1] = twist_rad[step]
        parts = 1 + int(abs(way_rad) / (0.02 * half_rad))  # so fine that neither speed nor time step shows
        if parts > 200:
            parts = 200
        for _ in range(parts):
            lean = state[0] / half_rad
            if lean * way_rad < 0.0:
                lean = 0.0
            state[0] += way_rad / parts * (1.0 - min(abs(lean), 1.0) ** firmness)
            state[0] = min(max(state[0], -half_rad), half_rad)
        out[step] = state[0]
    return out


class Hidden(Concealed):
    """Play of a fifth of a turn, and more."""

    claim = Claim(
        "reversals of twist",
        altered_motion.WOUND_UP_ONCE,
        (altered_motion.AT_HALF_SPEED, altered_motion.UNDER_TWICE_THE_LOAD),
    )
    grows, most, wanders = ("turns",), 2.0, 0.034

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How firmly the dogs meet."""
        return {"turns": 0.2, "firmness": uniform(rng, 2.0, 4.0)}
