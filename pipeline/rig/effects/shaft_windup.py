"""The shaft between motor and string winds up under the string's torque.

Source: the law is this rig's own; that rubber hardens: Treloar, The Physics of Rubber Elasticity, 1949.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived


class Model(Effect):
    """A rubber coupling that hardens: it gives way by φ = compliance · τ / (1 + τ/τ0)^hardening.

    The torque τ = F r sin α is that of the string's own twist θ − φ, so that φ is solved for.
    """

    acts_on = "twist"

    def __init__(self, compliance_rad_per_n_mm: float = 0.3, hardens_n_mm: float = 4.0, hardening: float = 0.4) -> None:
        self.compliance, self.hardens_n_mm, self.hardening = compliance_rad_per_n_mm, hardens_n_mm, hardening

    def run(self, lived: Lived) -> Array:
        """Wind-up in rad."""
        geometry, wind_up_rad = lived.geometry, np.zeros(len(lived.twist_rad))
        zone_mm, radius_mm = geometry.torsion_zone_mm, lived.radius_mm
        for _ in range(8):  # Newton: the torque falls by little when the shaft gives way, so that it converges at once
            open_mm = geometry.separator_mm + (lived.twist_rad - wind_up_rad) * radius_mm
            strand_mm = np.hypot(zone_mm, open_mm)
            torque = lived.load_n * radius_mm * open_mm / strand_mm
            falls = -lived.load_n * (radius_mm * zone_mm) ** 2 / strand_mm**3
            hard = np.maximum(1.0 + torque / self.hardens_n_mm, 0.1)
            given_rad = self.compliance * torque * hard**-self.hardening
            gives = self.compliance * hard**-self.hardening * (1.0 - self.hardening * (hard - 1.0) / hard)
            wind_up_rad = wind_up_rad - (wind_up_rad - given_rad) / (1.0 - gives * falls)
        return wind_up_rad


class Hidden(Concealed):
    """A coupling that gives way."""

    claim = Claim("torque", altered_motion.WITHOUT_LOAD, (altered_motion.AT_HALF_SPEED,))
    grows, wanders = ("compliance_rad_per_n_mm",), 0.030

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """At which torque, and how, it hardens."""
        return {
            "compliance_rad_per_n_mm": 0.2,
            "hardens_n_mm": scene.torque_n_mm * uniform(rng, 0.3, 1.0),
            "hardening": uniform(rng, 0.3, 0.5),
        }
