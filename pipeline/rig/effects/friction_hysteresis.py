"""Friction of string on string holds back part of the twist, and lets it go only after a reversal."""

import math

from pipeline.rig.effect import Effect, Now


class Model(Effect):
    """Dahl's friction on the twist: the held twist h obeys dh/dθ = (w − h·sign θ̇) / reach.

    The half width w of the loop grows with the load that presses the strings together, w = turns_per_n · F;
    `reach_turns` is the twist over which a reversal is forgotten.
    """

    acts_on = "twist"

    def __init__(self, turns_per_n: float, reach_turns: float) -> None:
        self.rad_per_n = math.tau * turns_per_n
        self.reach_rad = math.tau * reach_turns
        self.held_rad = 0.0

    def step(self, now: Now) -> float:
        limit_rad = math.copysign(self.rad_per_n * now.load_n, now.turned_rad)
        forgotten = -math.expm1(-abs(now.turned_rad) / self.reach_rad)
        self.held_rad += (limit_rad - self.held_rad) * forgotten
        return self.held_rad
