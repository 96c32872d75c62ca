"""Two tanks, one above the other, and a pump: the pump's voltage → the water level in the lower tank, both in volts.

Source: Schoukens and Noël, "Three benchmarks addressing open challenges in nonlinear system identification", IFAC-
PapersOnLine 50, 2017.
"""

from collections.abc import Mapping

import numpy as np
from numba import njit

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of


@njit(cache=True)
def levels(time_s: Array, inflow: Array, upper: float, lower: float, first: float, second: float) -> Array:
    """Level of the lower tank in V, by steps of Runge and Kutta, from the levels that both start from.

    `inflow` in V/s flows into the upper tank; water leaves a tank with `first` or `second` times the level's root.
    `inflow` and the level have the shape (samples,); time in s.
    """
    out = np.empty_like(time_s)
    out[0] = lower
    for i in range(1, time_s.size):
        step_s, flow = time_s[i] - time_s[i - 1], 0.5 * (inflow[i] + inflow[i - 1])
        up, low, slope_up, slope_low = upper, lower, 0.0, 0.0
        for weight, ahead in ((1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)):
            passed = first * np.sqrt(max(up, 0.0))
            rise_up, rise_low = flow - passed, passed - second * np.sqrt(max(low, 0.0))
            slope_up += weight * rise_up / 6.0
            slope_low += weight * rise_low / 6.0
            up, low = upper + ahead * step_s * rise_up, lower + ahead * step_s * rise_low
        upper, lower = max(upper + step_s * slope_up, 0.0), max(lower + step_s * slope_low, 0.0)
        out[i] = lower
    return out


class CascadedTanks(System):
    """Torricelli's law twice. Levels are in volts of the sensor, the upper one too, which nobody reads."""

    name = "cascaded_tanks"
    driver, channel = "pump_v", "level_v"
    free_zero, remembers = False, True
    rig: Mapping[str, str] = {
        "pump_gain": "rise of the upper level with the pump's voltage, in V/s a V",
        "upper_outflow": "fall of the upper level by its outlet, in V/s at a level of 1 V",
        "lower_outflow": "fall of the lower level by its outlet, in V/s at a level of 1 V",
        "upper_start_v": "the upper level at the first sample, in V",
        "lower_start_v": "the lower level at the first sample, in V",
    }
    never_zero = frozenset({"pump_gain", "upper_outflow", "lower_outflow"})
    tolerance: Mapping[str, float] = {
        "pump_gain": 0.1, "upper_outflow": 0.1, "lower_outflow": 0.1, "upper_start_v": 1.0, "lower_start_v": 0.1,
    }  # fmt: skip
    absolute = frozenset({"upper_start_v", "lower_start_v"})
    ports: Mapping[str, str] = {"twist": "pump", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """Gain and outlets with relative tolerances, then the levels at the start, which are never below the ground."""
        listed = []
        for key in self.rig:
            size, start = run.rig[key], key.endswith("_v")
            listed.append(Parameter(key, size, sigma_of(self, run, key) * (1.0 if start else size), lowest=0.0))
        return listed

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Level of the lower tank in V."""
        gain, first, second, upper, lower = values
        inflow = np.maximum(gain * (inputs.motion + acts.get("pump", 0.0)), 0.0)
        return np.asarray(levels(inputs.time_s, inflow, upper, lower, first, second))


SYSTEMS = (CascadedTanks(),)
