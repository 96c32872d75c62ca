"""The hook that turns the string runs out of true: a ripple once a turn.

Source: von Seherr-Thoss, Schmelz and Aucktor, Universal Joints and Driveshafts, 2006 (a bent joint, twice a turn); the
rest is the geometry of this rig.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived


class Model(Effect):
    """A hook that goes round the axis at `run_out_mm`, seen from a guide that stands aside.

    It stands aside by as much as the zone is long, and their distance is worked out in space. The hook is driven
    through a bent joint, so that it goes ahead and behind twice a turn: its angle is θ + phase + joint · sin 2θ.
    """

    acts_on = "length"

    def __init__(self, run_out_mm: float = 0.1, phase_rad: float = 0.0, joint: float = 0.1) -> None:
        self.run_out_mm, self.phase_rad, self.joint = run_out_mm, phase_rad, joint

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm, about the middle of the hook's way."""
        zone_mm = lived.geometry.torsion_zone_mm
        angle = lived.twist_rad + self.phase_rad + self.joint * np.sin(2.0 * lived.twist_rad)
        aside_mm = zone_mm - self.run_out_mm * np.cos(angle)
        level_mm = self.run_out_mm * np.sin(angle)
        straight_mm = np.sqrt(zone_mm**2 + aside_mm**2 + level_mm**2)
        return np.asarray(straight_mm - np.sqrt(2.0) * zone_mm)


class Hidden(Concealed):
    """A hook a tenth of a millimetre out of true, and more."""

    claim = Claim(
        "the angle within a turn",
        altered_motion.BY_WHOLE_TURNS,
        (altered_motion.AT_HALF_SPEED, altered_motion.UNDER_TWICE_THE_LOAD),
    )
    grows = ("run_out_mm",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Where the hook stands, and how bent its joint is."""
        return {"run_out_mm": 0.1, "phase_rad": scene.phase_rad, "joint": uniform(rng, 0.08, 0.2)}
