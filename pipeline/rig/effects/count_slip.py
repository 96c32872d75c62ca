"""Twist is lost between encoder and string: a set screw that lets go now and then.

Source: Miner, "Cumulative damage in fatigue", Journal of Applied Mechanics 12, 1945 (damage that adds up); how it slips
is this rig's own.
"""

from collections.abc import Sequence

import numpy as np

from ...ground.kinematics import RAD_PER_TURN, Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """A screw tires under torque, dD/dt = (τ / torque_n_mm)², and slips by turns[i] when D reaches lives_s[i].

    While it slips it goes at `slip_turns_per_s`; what is lost stays lost.
    """

    acts_on = "twist"

    def __init__(
        self,
        turns: Sequence[float] = (0.5,),
        lives_s: Sequence[float] = (20.0,),
        torque_n_mm: float = 4.0,
        slip_turns_per_s: float = 8.0,
    ) -> None:
        if len(turns) != len(lives_s):
            raise TypeError("turns and lives_s must have one value for each slip")
        self.slips_rad = 2.0 * np.pi * np.array(turns, float)
        self.lives_s = np.array(lives_s, float)
        self.torque_n_mm, self.rad_per_s = torque_n_mm, 2.0 * np.pi * slip_turns_per_s
        self.state = np.zeros(2)  # damage, and the twist that is lost

    def run(self, lived: Lived) -> Array:
        """Twist lost, in rad."""
        geometry = lived.geometry
        open_mm = geometry.separator_mm + lived.twist_rad * lived.radius_mm
        torque = lived.load_n * lived.radius_mm * open_mm / np.hypot(geometry.torsion_zone_mm, open_mm)
        tired_s = (torque / self.torque_n_mm) ** 2 * lived.step_s
        return _slip(tired_s, self.lives_s, self.slips_rad, self.rad_per_s * lived.step_s, self.state)


@compiled
def _slip(tired_s: Array, lives_s: Array, slips_rad: Array, most_rad: float, state: Array) -> Array:
    out = np.empty(len(tired_s))
    for step in range(len(tired_s)):
        state[0] += tired_s[step]
        due_rad = 0.0
        for slip in range(len(lives_s)):
            if state[0] >= lives_s[slip]:
                due_rad += slips_rad[slip]
        gap_rad = due_rad - state[1]
        state[1] += min(max(gap_rad, -most_rad), most_rad)
        out[step] = state[1]
    return out


class Hidden(Concealed):
    """A screw that lets go one to three times."""

    claim = Claim("an event", altered_motion.IN_NO_TIME)
    grows, most, wanders, by_chance = ("turns",), 2.0, 0.032, True

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """One to three slips, somewhere in the middle of the recording."""
        commands, true = scene.commands, scene.geometry
        open_mm = true.separator_mm + commands.motor_turns * RAD_PER_TURN * true.radius_mm
        sine = open_mm / np.hypot(open_mm, true.torsion_zone_mm)
        tires = (commands.load_n * true.radius_mm * sine / scene.torque_n_mm) ** 2
        events = int(rng.integers(1, 4))
        lives_s = scene.lives(tires, events, rng)
        turns = (0.3 * rng.uniform(0.6, 1.4, events)).tolist()
        return {"turns": turns, "lives_s": lives_s, "torque_n_mm": scene.torque_n_mm}
