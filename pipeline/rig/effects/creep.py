"""A twisted string under load lengthens with time, and takes it back when it is untwisted."""

import math
from collections.abc import Sequence

from pipeline.rig.effect import Effect, Now


class Model(Effect):
    """Branches that flow towards what the strands' contact force F sin α asks of them, by activated jumps.

    Branch i is pulled by the gap g = compliance_mm_per_n[i] · F sin α − z and flows at
    dz/dt = (yield_mm / tau_s[i]) sinh(g / yield_mm): in proportion to a small gap, faster for a large one.
    """

    acts_on = "length"

    def __init__(self, compliance_mm_per_n: Sequence[float], tau_s: Sequence[float], yield_mm: float = 0.03) -> None:
        self.branches = list(zip(compliance_mm_per_n, tau_s, strict=True))
        self.yield_mm = yield_mm
        self.flow_mm = [0.0] * len(self.branches)

    def step(self, now: Now) -> float:
        pull_n = now.load_n * now.helix_tangent / math.sqrt(1.0 + now.helix_tangent**2)
        for branch, (compliance_mm_per_n, tau_s) in enumerate(self.branches):
            gap_mm = compliance_mm_per_n * pull_n - self.flow_mm[branch]
            # sinh flow has a closed solution for a standing pull: tanh(g/2y) falls as exp(−t/τ)
            rest = math.tanh(gap_mm / (2.0 * self.yield_mm)) * math.exp(-now.step_s / tau_s)
            self.flow_mm[branch] += gap_mm - 2.0 * self.yield_mm * math.atanh(rest)
        return sum(self.flow_mm)
