"""Lateral pressure packs the fibres of a twisted string tighter, so that its radius falls.

Source: van Wyk, "Note on the compressibility of wool", Journal of the Textile Institute 37, 1946 (with an exponent of
3; this one is drawn).
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, number, uniform
from ..effect import Effect, Lived, compiled


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
        self.state = np.array([1.0, np.nan])  # φ/φ0, and the radius of the step before

    def run(self, lived: Lived) -> Array:
        """Factor on the radius."""
        if math.isnan(self.state[1]):
            self.state[1] = lived.geometry.radius_mm
        settled = -math.expm1(-lived.step_s / self.settle_s)
        bed = (self.bed_mpa, 1.0 / self.exponent, self.limit, settled)
        zone = (lived.geometry.torsion_zone_mm, lived.geometry.separator_mm)
        return _pack(lived.load_n, lived.twist_rad, lived.radius_mm, zone, bed, self.state)


@compiled
def _pack(
    load_n: Array, twist_rad: Array, radius_mm: Array, zone: tuple[float, float], bed: tuple[float, ...], state: Array
) -> Array:
    zone_mm, separator_mm = zone
    bed_mpa, inverse_exponent, limit, settled = bed
    out = np.empty(len(load_n))
    for step in range(len(load_n)):
        squared = ((separator_mm + twist_rad[step] * state[1]) / zone_mm) ** 2
        pressure_mpa = load_n[step] * squared / (1.0 + squared) / radius_mm[step] ** 2 * state[0]
        borne = min((1.0 + pressure_mpa / bed_mpa) ** inverse_exponent, limit)
        state[0] += (borne - state[0]) * settled
        out[step] = state[0] ** -0.5
        state[1] = radius_mm[step] * out[step]
    return out


class Hidden(Concealed):
    """A bundle that is pressed thinner."""

    claim = Claim("twist under load", altered_motion.WITHOUT_LOAD, (altered_motion.AT_HALF_SPEED,))
    wanders = 0.036

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How the bed of fibres stiffens."""
        return {"bed_mpa": 300.0, "exponent": uniform(rng, 1.3, 3.0)}

    def at(self, drawn: Parameters, strength: float, scene: Scene) -> Parameters:
        """The stronger, the softer the bed."""
        return {**drawn, "bed_mpa": number(drawn, "bed_mpa") / strength}
