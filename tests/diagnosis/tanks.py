"""Two tanks, one above the other, as a rig of a user's own: what flows out goes with the root of the level."""

from collections.abc import Mapping
from types import SimpleNamespace

import numpy as np
import pandas as pd

from pipeline.systems.interface import Parameter, System, sigma_of

TRUE = {"inflow": 0.05, "out_1": 0.06, "in_2": 0.06, "out_2": 0.055, "level_1_v": 3.0, "level_2_v": 3.0}
NOISE_V = 0.02


class Tanks(System):
    """Level of the lower tank, which the upper one feeds."""

    name = "tanks"
    driver, channel = "pump_v", "level_v"
    free_zero, remembers = False, True
    rig = dict.fromkeys(TRUE, "a dimension")
    never_zero = frozenset(TRUE)
    tolerance = dict.fromkeys(TRUE, 0.3)
    ports: Mapping[str, str] = {"twist": "pump", "resistance": "level", "sensor": "sensor"}

    def parameters(self, run):
        """All dimensions, each known to its share."""
        return [Parameter(key, run.rig[key], sigma_of(self, run, key) * run.rig[key]) for key in self.rig]

    def simulate(self, values, inputs, acts):
        """Level in V, by four steps a sample."""
        inflow, out_1, in_2, out_2, upper, lower = values.tolist()
        pumped = inflow * np.broadcast_to(inputs.motion + acts.get("pump", 0.0), len(inputs.time_s))
        level = []
        for step_s, flow in zip(
            np.diff(inputs.time_s, append=inputs.time_s[-1]).tolist(), pumped.tolist(), strict=True
        ):
            level.append(lower)
            for _ in range(4):
                root, below = max(upper, 0.0) ** 0.5, max(lower, 0.0) ** 0.5
                upper += step_s / 4 * (flow - out_1 * root)
                lower += step_s / 4 * (in_2 * root - out_2 * below)
        return np.array(level) + acts.get("level", 0.0)


def recorded(guess, seed, step_s=1.0, missing=lambda level: level):
    """A run whose dimensions were measured `guess` times too large, and its samples; `missing` changes the reading."""
    time_s = np.arange(0.0, 1600.0, step_s)
    pump = 2.5 + 1.8 * np.sin(2.0 * np.pi * time_s / 400.0) + 0.5 * np.sin(2.0 * np.pi * time_s / 90.0)
    values = np.array(list(TRUE.values()))
    level = missing(Tanks().simulate(values, SimpleNamespace(time_s=time_s, motion=pump), {}))
    level = level + NOISE_V * np.random.default_rng(seed).standard_normal(len(time_s))
    rig = {key: value * share for (key, value), share in zip(TRUE.items(), guess, strict=True)}
    run = SimpleNamespace(run="tanks-01", system=Tanks(), string=None, rig=rig, tolerance={}, simulation=[], adopted=[])
    return run, pd.DataFrame({"time_s": time_s, "pump_v": pump, "level_v": level})
