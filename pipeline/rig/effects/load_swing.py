"""The hanging load swings after every start and stop.

Source: Nayfeh and Mook, Nonlinear Oscillations, 1979 (an oscillator with drag of the square).
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """An oscillator with rubbing and air in its way: z'' + 2ζω z' + drag |z'| z' + ω² z = −share · x''.

    x is what the string contracts and z, in mm, what the load hangs off it; a load that swings aside takes only
    a `share` of the string's acceleration.
    """

    acts_on = "contraction"

    def __init__(
        self, share: float = 0.3, frequency_hz: float = 1.2, damping: float = 0.02, drag_per_mm: float = 0.05
    ) -> None:
        self.share, self.omega = share, math.tau * frequency_hz
        self.damping, self.drag_per_mm = damping, drag_per_mm
        self.state = np.array([0.0, 0.0, np.nan, 0.0])  # z, z', and the contraction and its rate a step before

    def run(self, lived: Lived) -> Array:
        """How much less the load moves than the string contracts, in mm."""
        if math.isnan(self.state[2]):
            self.state[2] = lived.contraction_mm[0]
        steps = (lived.step_s, self.omega, self.damping, self.drag_per_mm, self.share)
        return np.asarray(-_swing(lived.contraction_mm, steps, self.state))


@compiled
def _swing(contraction_mm: Array, steps: tuple[float, ...], state: Array) -> Array:
    step_s, omega, damping, drag_per_mm, share = steps
    parts = 1 + int(omega * step_s / 0.05)
    part_s = step_s / parts
    out = np.empty(len(contraction_mm))
    for step in range(len(contraction_mm)):
        rate = (contraction_mm[step] - state[2]) / step_s
        state[1] -= share * (rate - state[3])
        state[2], state[3] = contraction_mm[step], rate
        for _ in range(parts):
            # symplectic in z, implicit in the losses: it neither gains energy nor jumps
            losses = 2.0 * damping * omega + drag_per_mm * abs(state[1])
            state[1] = (state[1] - part_s * omega**2 * state[0]) / (1.0 + part_s * losses)
            state[0] += part_s * state[1]
        out[step] = state[0]
    return out


class Hidden(Concealed):
    """A load of which a third swings, and more."""

    claim = Claim("starts and stops", altered_motion.INFINITELY_SLOWLY, (altered_motion.UNDER_TWICE_THE_LOAD,))
    grows, most = ("share",), 0.95

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """How fast it swings, and for how long."""
        return {"share": 0.3, "frequency_hz": uniform(rng, 0.7, 1.6), "damping": uniform(rng, 0.01, 0.04)}
