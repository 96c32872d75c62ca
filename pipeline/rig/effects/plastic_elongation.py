"""Winding under load stretches a string for good, ever less as it is worked."""

import math
from collections.abc import Sequence

from pipeline.rig.effect import Effect, Now


class Model(Effect):
    """Populations of fibres that yield as the strands are pressed past each other, each until it is exhausted.

    Population i has stretch_mm[i] to give at the start and loses a share dW / work_n_mm[i] of what is left for
    every dW = F sin α dx of contact work (contact force times contraction) in winding; unwinding does none.
    """

    acts_on = "length"

    def __init__(self, stretch_mm: Sequence[float], work_n_mm: Sequence[float]) -> None:
        self.left_mm = list(stretch_mm)
        self.work_n_mm = list(work_n_mm)
        if len(self.left_mm) != len(self.work_n_mm):
            raise TypeError("stretch_mm and work_n_mm must have one value for each population")
        self.given_mm = 0.0

    def step(self, now: Now) -> float:
        sine = now.helix_tangent / math.hypot(1.0, now.helix_tangent)
        work_n_mm = now.load_n * max(now.advance_mm, 0.0) * sine
        for population, capacity_n_mm in enumerate(self.work_n_mm):
            share = work_n_mm / (capacity_n_mm + work_n_mm)  # implicit: never more than there is
            yielded_mm = self.left_mm[population] * share
            self.left_mm[population] -= yielded_mm
            self.given_mm += yielded_mm
        return self.given_mm
