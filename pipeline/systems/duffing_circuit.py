"""An electronic oscillator: its output, twice differentiated, is the voltage that drives it, in volts.

Source: Wigren and Schoukens, "Three free data sets for development and benchmarking in nonlinear system
identification", ECC 2013.
"""

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import make_interp_spline

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of

DEGREE = 5  # of the spline that is differentiated: a few samples make a period, which plain differences flatten


def derivatives(time_s: Array, response: Array) -> tuple[Array, Array]:
    """Rate and acceleration of a response, in V/s and V/s², by an interpolating spline. Each of shape (samples,)."""
    spline = make_interp_spline(time_s, response, k=DEGREE)
    return np.asarray(spline(time_s, 1)), np.asarray(spline(time_s, 2))


class DuffingCircuit(System):
    """Drive = inertia · acceleration + damping · rate + stiffness · output, its spring straight; with a true zero."""

    name = "duffing_circuit"
    driver, channel = "response_v", "drive_v"
    free_zero, differentiates, working_hz = False, True, 2000.0
    rig: Mapping[str, str] = {
        "inertia_s2": "drive for a second derivative of the output of 1 V/s², in s²",
        "damping_s": "drive for a rate of the output of 1 V/s, in s",
        "stiffness": "drive for a small steady output of 1 V, in V/V",
    }
    never_zero = frozenset({"inertia_s2", "stiffness"})
    tolerance: Mapping[str, float] = {"inertia_s2": 0.1, "damping_s": 0.3, "stiffness": 0.1}
    ports: Mapping[str, str] = {"resistance": "force", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """The three, each with its relative tolerance."""
        return [Parameter(key, run.rig[key], sigma_of(self, run, key) * run.rig[key]) for key in self.rig]

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """The motion itself: a drive travels nowhere."""
        return inputs.motion

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Drive in V."""
        inertia, damping, stiffness = values
        rate, acceleration = derivatives(inputs.time_s, inputs.motion)
        drive = inertia * acceleration + damping * rate + stiffness * inputs.motion
        return np.asarray(drive + acts.get("force", 0.0))


SYSTEMS = (DuffingCircuit(),)
