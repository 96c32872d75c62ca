"""Friction of string on string holds back part of the twist, and lets it go only after a reversal.

Source: Dahl, "A solid friction model", The Aerospace Corporation, 1968.
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Dahl's friction on the twist: the gap g of the held twist to its limit closes as dg/dθ = −g (|g|/w)^tail / reach.

    The half width w of the loop grows with the load that presses the strings together, w = turns_per_n · F;
    `reach_turns` is the twist over which a reversal is half forgotten, and `tail` above 0 makes it forget the
    rest ever more slowly, as strands do that let go one after the other.
    """

    acts_on = "twist"

    def __init__(self, turns_per_n: float, reach_turns: float, tail: float = 0.0) -> None:
        self.rad_per_n = math.tau * turns_per_n
        self.reach_rad = math.tau * reach_turns
        self.tail = tail
        self.held_rad = np.zeros(1)

    def run(self, lived: Lived) -> Array:
        """Twist held back, in rad."""
        limit_rad = np.copysign(self.rad_per_n * lived.load_n, lived.turned_rad)
        moved = np.abs(lived.turned_rad) / self.reach_rad
        if self.tail:
            return _hold_with_tail(limit_rad, moved, self.tail, self.held_rad)
        return _hold(limit_rad, -np.expm1(-moved), self.held_rad)


@compiled
def _hold(limit_rad: Array, forgotten: Array, held_rad: Array) -> Array:
    out = np.empty(len(limit_rad))
    for step in range(len(limit_rad)):
        held_rad[0] += (limit_rad[step] - held_rad[0]) * forgotten[step]
        out[step] = held_rad[0]
    return out


@compiled
def _hold_with_tail(limit_rad: Array, moved: Array, tail: float, held_rad: Array) -> Array:
    out = np.empty(len(limit_rad))
    for step in range(len(limit_rad)):
        gap = limit_rad[step] - held_rad[0]
        if moved[step] > 0.0 and limit_rad[step] != 0.0:
            far = abs(gap / limit_rad[step]) ** tail
            gap *= (1.0 + tail * far * moved[step]) ** (-1.0 / tail)  # the equation's own solution over the step
            held_rad[0] = limit_rad[step] - gap
        out[step] = held_rad[0]
    return out


class Hidden(Concealed):
    """A loop of a tenth of a turn under the usual load, and more."""

    claim = Claim("reversals of twist under load", altered_motion.WITHOUT_LOAD, (altered_motion.AT_HALF_SPEED,))
    grows = ("turns_per_n",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How soon after a reversal, and how, the loop closes."""
        reach_turns, tail = uniform(rng, 0.1, 0.5), uniform(rng, 0.7, 1.5)
        return {"turns_per_n": 0.1 / scene.load_n, "reach_turns": reach_turns, "tail": tail}
