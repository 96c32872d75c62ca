"""A clamp gives way all at once: the string is longer from then on.

Source: Miner, "Cumulative damage in fatigue", Journal of Applied Mechanics 12, 1945 (damage that adds up); how the slip
runs out is this rig's own.
"""

from collections.abc import Sequence

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """A knot that tires under load, dD/dt = (F / load_n)^2, and pulls through by slips_mm[i] at D = lives_s[i].

    The slip s runs out as ds/dt = (left)² / (slip · glide_s): most of it at once, the rest ever more slowly.
    """

    acts_on = "length"

    def __init__(
        self,
        slips_mm: Sequence[float] = (0.3,),
        lives_s: Sequence[float] = (40.0,),
        load_n: float = 20.0,
        glide_s: float = 0.02,
    ) -> None:
        if len(slips_mm) != len(lives_s):
            raise TypeError("slips_mm and lives_s must have one value for each slip")
        self.slips_mm, self.lives_s = np.array(slips_mm, float), np.array(lives_s, float)
        self.load_n, self.glide_s = load_n, glide_s
        self.tired_s = np.zeros(1)
        self.left = np.ones(len(self.slips_mm))

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        tired_s = (lived.load_n / self.load_n) ** 2 * lived.step_s
        return _pull(tired_s, self.lives_s, self.slips_mm, lived.step_s / self.glide_s, self.tired_s, self.left)


@compiled
def _pull(tired_s: Array, lives_s: Array, slips_mm: Array, glides: float, state: Array, share_left: Array) -> Array:
    out = np.zeros(len(tired_s))
    for step in range(len(tired_s)):
        state[0] += tired_s[step]
        for slip in range(len(lives_s)):
            if state[0] >= lives_s[slip]:
                share_left[slip] /= 1.0 + glides * share_left[slip]
            out[step] += slips_mm[slip] * (1.0 - share_left[slip])
    return out


class Hidden(Concealed):
    """A clamp that gives way once or twice."""

    claim = Claim("an event", altered_motion.IN_NO_TIME, (altered_motion.AT_REST,))
    grows, wanders, by_chance = ("slips_mm",), 0.019, True

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """One or two slips, somewhere in the middle of the recording."""
        load_n = scene.load_n
        events = int(rng.integers(1, 3))
        lives_s = scene.lives((scene.commands.load_n / load_n) ** 2, events, rng)
        return {"slips_mm": (0.3 * rng.uniform(0.6, 1.4, events)).tolist(), "lives_s": lives_s, "load_n": load_n}
