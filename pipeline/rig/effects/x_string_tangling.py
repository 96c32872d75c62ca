"""The strands lie down otherwise in every stroke: the radius is drawn anew each time. No library holds it.

Source: the law is this rig's own; scatter from one winding to the next: Joint Committee for Guides in Metrology, JCGM
100:2008 (repeatability).
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Whenever the string is untwisted to below `open_turns` and wound again, its radius is drawn anew."""

    acts_on = "radius"

    def __init__(self, scatter: float = 0.01, open_turns: float = 3.0, seed: int = 0) -> None:
        self.open_rad = 2.0 * np.pi * open_turns
        self.factors = 1.0 + scatter * np.random.default_rng(seed).standard_normal(500)
        self.state = np.zeros(2)  # times tangled, and whether the string is open

    def run(self, lived: Lived) -> Array:
        """Factor on the radius."""
        return _tangle(lived.twist_rad, self.open_rad, self.factors, self.state)


@compiled
def _tangle(twist_rad: Array, open_rad: float, factors: Array, state: Array) -> Array:
    out = np.empty(len(twist_rad))
    for step in range(len(twist_rad)):
        if twist_rad[step] < open_rad:
            state[1] = 1.0
        elif state[1] == 1.0:
            state[0], state[1] = state[0] + 1.0, 0.0
        out[step] = factors[int(state[0]) % len(factors)]
    return out


class Hidden(Concealed):
    """A radius that scatters by half a hundredth, and more."""

    claim = Claim(
        "a new winding",
        altered_motion.NEVER_UNWOUND,
        (altered_motion.AT_HALF_SPEED, altered_motion.UNDER_TWICE_THE_LOAD),
    )
    grows = ("scatter",)

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How the strands lie down."""
        return {"scatter": 0.005, "open_turns": 0.15 * scene.top_turns, "seed": int(rng.integers(1 << 31))}
