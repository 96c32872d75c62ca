"""Past a critical twist the string coils up: it runs ahead, and uncoils only at a smaller twist.

Source: Preisach, "Über die magnetische Nachwirkung", Zeitschrift für Physik 94, 1935 (a sum of relays); the coils are
this rig's own.
"""

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled

COILS = 40


class Model(Effect):
    """Forty coils, each a relay: it nucleates at a twist of its own and melts at a smaller one.

    While it is there it takes up gain_mm_per_turn / 40 for each turn past its melting. The nucleation twists are
    spread logistically about `critical_turns`; each coil melts `memory_turns`, more for late coils, below its own.
    """

    acts_on = "length"

    def __init__(
        self,
        critical_turns: float = 15.0,
        gain_mm_per_turn: float = 0.5,
        spread_turns: float = 0.6,
        memory_turns: float = 2.0,
    ) -> None:
        rank = (np.arange(COILS) + 0.5) / COILS
        self.nucleates_turns = critical_turns + spread_turns * np.log(rank / (1.0 - rank))
        self.melts_turns = self.nucleates_turns - memory_turns * (0.5 + rank)
        self.gain_mm_per_turn = gain_mm_per_turn / COILS
        self.coiled = np.zeros(COILS)

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm, which is negative: coils shorten the string."""
        turns = lived.twist_rad / (2.0 * np.pi)
        taken_mm = self.gain_mm_per_turn * _coil(turns, self.nucleates_turns, self.melts_turns, self.coiled)
        return np.asarray(-taken_mm)


@compiled
def _coil(turns: Array, nucleates_turns: Array, melts_turns: Array, coiled: Array) -> Array:
    out = np.zeros(len(turns))
    for step in range(len(turns)):
        for coil in range(len(coiled)):
            if turns[step] >= nucleates_turns[coil]:
                coiled[coil] = 1.0
            elif turns[step] <= melts_turns[coil]:
                coiled[coil] = 0.0
            out[step] += coiled[coil] * (turns[step] - melts_turns[coil])
    return out


class Hidden(Concealed):
    """Coils in the upper part of the twist."""

    claim = Claim(
        "large twist", altered_motion.HALF_WOUND, (altered_motion.AT_HALF_SPEED, altered_motion.UNDER_TWICE_THE_LOAD)
    )
    grows, wanders = ("gain_mm_per_turn",), 0.034

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """From which twist on, how softly it begins, and how much later it ends."""
        top = scene.top_turns
        return {
            "critical_turns": top * uniform(rng, 0.6, 0.8),
            "gain_mm_per_turn": 0.3,
            "spread_turns": top * uniform(rng, 0.015, 0.03),
            "memory_turns": top * uniform(rng, 0.08, 0.2),
        }
