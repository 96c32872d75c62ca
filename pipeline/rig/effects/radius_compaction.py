"""Lateral pressure packs the fibres of a twisted string tighter, so that its radius falls."""

import math

from pipeline.rig.effect import Effect, Now


class Model(Effect):
    """Volume fraction of the fibres, relaxing towards what a stiffening bed of fibres bears.

    A helix under load F presses its strands together with p = F sin²α / r². The bed bears
    p = bed_mpa · ((φ/φ0)^exponent − 1), and at constant fibre volume r ∝ φ^(−1/2), so the pressure rises as the
    string gives way: the balance is found by the relaxation itself. Round fibres pack no tighter than `densest`.
    """

    acts_on = "radius"

    def __init__(
        self, bed_mpa: float, exponent: float, loose: float = 0.60, densest: float = 0.907, settle_s: float = 0.02
    ) -> None:
        self.bed_mpa, self.exponent, self.settle_s = bed_mpa, exponent, settle_s
        self.limit = densest / loose
        self.packing = 1.0  # φ/φ0

    def step(self, now: Now) -> float:
        squared = now.helix_tangent**2
        pressure_mpa = now.load_n * squared / (1.0 + squared) / now.radius_mm**2 * self.packing
        borne = min((1.0 + pressure_mpa / self.bed_mpa) ** (1.0 / self.exponent), self.limit)
        self.packing += (borne - self.packing) * -math.expm1(-now.step_s / self.settle_s)
        return self.packing**-0.5
