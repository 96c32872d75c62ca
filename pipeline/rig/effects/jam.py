"""Past a critical twist the coils touch, and further twist presses them together instead of shortening the string.

Source: the law is this rig's own; that contacts close one after the other is the idea of Greenwood and Williamson,
"Contact of nominally flat surfaces", Proceedings of the Royal Society A 295, 1966.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Contacts that close one after the other: beyond the critical twist a share of each turn goes into them.

    In units of the spread the way q that they are pressed in obeys q + √q = z for the twist z past the critical
    one: the first contacts give the root, so that nothing jams at once. Nothing is remembered.
    """

    acts_on = "twist"

    def __init__(self, critical_turns: float = 15.0, share: float = 0.5, spread_turns: float = 3.0) -> None:
        self.critical_rad, self.spread_rad = 2.0 * np.pi * critical_turns, 2.0 * np.pi * spread_turns
        self.share = share

    def run(self, lived: Lived) -> Array:
        """Twist that goes into the contacts, in rad."""
        past = np.maximum(lived.twist_rad - self.critical_rad, 0.0) / self.spread_rad
        return self.share * self.spread_rad * _press(past)


@compiled
def _press(past: Array) -> Array:
    """Solve q + √q = z for the twist past the critical one, in units of the spread; of the shape of `past`."""
    out = np.zeros(len(past))
    for step in range(len(past)):
        pressed = 0.0
        if past[step] > 0.0:
            root = min(past[step], np.sqrt(past[step]))
            for _ in range(20):
                root -= (root * root + root - past[step]) / (2.0 * root + 1.0)
            pressed = root * root
        out[step] = pressed
    return out


class Hidden(Concealed):
    """Coils that touch in the upper part of the twist."""

    claim = Claim(
        "large twist", altered_motion.HALF_WOUND, (altered_motion.AT_HALF_SPEED, altered_motion.UNDER_TWICE_THE_LOAD)
    )
    grows, most, wanders = ("share",), 0.95, 0.036

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """From which twist on, and how softly it begins."""
        top = scene.top_turns
        critical_turns, spread_turns = top * uniform(rng, 0.55, 0.8), top * uniform(rng, 0.05, 0.15)
        return {"critical_turns": critical_turns, "share": 0.3, "spread_turns": spread_turns}
