"""The encoder's two tracks are uneven: its count is wrong several times a turn. No library holds it.

Source: Heydemann, "Determination and correction of quadrature fringe measurement errors in interferometers", Applied
Optics 20, 1981.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene
from ..effect import Effect, Lived


class Model(Effect):
    """Tracks of `lines` periods a turn, unequal in offset (once a period) and gain (twice a period)."""

    acts_on = "twist"

    def __init__(self, error_turns: float = 0.03, lines: int = 4, phase_rad: float = 0.0) -> None:
        self.error_rad, self.lines, self.phase_rad = 2.0 * np.pi * error_turns, lines, phase_rad

    def run(self, lived: Lived) -> Array:
        """The encoder's count minus the true twist, in rad."""
        line = self.lines * lived.twist_rad + self.phase_rad
        return np.asarray(self.error_rad * (np.sin(line) + 0.4 * np.cos(2.0 * line)))


class Hidden(Concealed):
    """A count that errs by a fiftieth of a turn, and more."""

    claim = Claim("the angle within a turn", altered_motion.BY_WHOLE_TURNS, (altered_motion.AT_HALF_SPEED,))
    grows = ("error_turns",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Where the tracks begin, and how many periods they have."""
        return {"error_turns": 0.02, "lines": int(rng.integers(2, 4)), "phase_rad": scene.phase_rad}
