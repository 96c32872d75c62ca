"""A twisted string under load lengthens with time, and takes it back when it is untwisted.

Source: Eyring, "Viscosity, plasticity, and diffusion as examples of absolute reaction rates", Journal of Chemical
Physics 4, 1936.
"""

import math
from collections.abc import Sequence

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Branches that flow towards a value set by the strands' contact force F sin α, by activated jumps.

    Branch i is pulled by the gap g = compliance_mm_per_n[i] · F sin α − z and flows at
    dz/dt = (yield_mm / tau_s[i]) sinh(g / yield_mm): in proportion to a small gap, faster for a large one.
    """

    acts_on = "length"

    def __init__(self, compliance_mm_per_n: Sequence[float], tau_s: Sequence[float], yield_mm: float = 0.03) -> None:
        if len(compliance_mm_per_n) != len(tau_s):
            raise TypeError("compliance_mm_per_n and tau_s must have one value for each branch")
        self.compliance_mm_per_n = np.array(compliance_mm_per_n, float)
        self.tau_s = np.array(tau_s, float)
        self.yield_mm = yield_mm
        self.flow_mm = np.zeros(len(self.tau_s))

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm."""
        pull_n = lived.load_n * lived.helix_tangent / np.sqrt(1.0 + lived.helix_tangent**2)
        kept = np.array([math.exp(-lived.step_s / tau_s) for tau_s in self.tau_s])
        return _flow(pull_n, self.compliance_mm_per_n, kept, self.yield_mm, self.flow_mm)


@compiled
def _flow(pull_n: Array, compliance_mm_per_n: Array, kept: Array, yield_mm: float, flow_mm: Array) -> Array:
    out = np.empty(len(pull_n))
    for step in range(len(pull_n)):
        total = 0.0
        for branch in range(len(flow_mm)):
            gap_mm = compliance_mm_per_n[branch] * pull_n[step] - flow_mm[branch]
            # sinh flow has a closed solution for a standing pull: tanh(g/2y) falls as exp(−t/τ)
            rest = math.tanh(gap_mm / (2.0 * yield_mm)) * kept[branch]
            flow_mm[branch] += gap_mm - 2.0 * yield_mm * math.atanh(rest)
            total += flow_mm[branch]
        out[step] = total
    return out


class Hidden(Concealed):
    """A string that gives way in three times."""

    claim = Claim("time under load", altered_motion.IN_NO_TIME)
    grows = ("compliance_mm_per_n", "yield_mm")

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Three branches of seconds, of tens of them and of minutes."""
        taus = [uniform(rng, 2.0, 5.0), uniform(rng, 12.0, 25.0), uniform(rng, 60.0, 120.0)]
        compliance = 0.3 * rng.dirichlet([3.0, 4.0, 3.0]) / scene.load_n
        return {"compliance_mm_per_n": compliance.tolist(), "tau_s": taus, "yield_mm": uniform(rng, 0.05, 0.15)}
