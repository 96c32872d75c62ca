"""A pendulum on a position servo: its angle and the voltage that it takes are the goal that the servo was told.

Source: Duclusaud and others, "Extended friction models for the physics simulation of servo actuators", 2024.
"""

from collections.abc import Mapping

import numpy as np

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of


class ServoPendulum(System):
    """Goal = angle + voltage / gain; voltage = inertia · acceleration + weight · sin(angle) + back EMF · rate."""

    name = "servo_pendulum"
    driver, channel = "angle_rad", "goal_rad"
    turn = 2.0 * np.pi
    free_zero, differentiates, working_hz = False, True, 20.0
    rig: Mapping[str, str] = {
        "gain_v_per_rad": "voltage of the motor for an error of 1 rad",
        "inertia_v_s2": "voltage for an acceleration of 1 rad/s², in V s²",
        "weight_v": "voltage that holds the pendulum level, in V",
        "back_emf_v_s": "voltage for a rate of 1 rad/s, in V s",
    }
    never_zero = frozenset({"gain_v_per_rad"})
    tolerance: Mapping[str, float] = {"inertia_v_s2": 0.2, "weight_v": 0.1, "back_emf_v_s": 0.1}
    ports: Mapping[str, str] = {"resistance": "lead", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """Inertia, weight and back EMF with relative tolerances; the gain is known, or all would move together."""
        dimensions = [Parameter(key, run.rig[key], sigma_of(self, run, key) * run.rig[key]) for key in self.tolerance]
        return [Parameter("gain_v_per_rad", run.rig["gain_v_per_rad"], 0.0), *dimensions]

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """The motion itself."""
        return inputs.motion

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Goal in rad, where the voltage was not at its limit."""
        gain, inertia, weight, back_emf = values
        volts = inertia * inputs.acceleration + weight * np.sin(inputs.motion) + back_emf * inputs.rate
        return np.asarray(inputs.motion + volts / gain + acts.get("lead", 0.0))


SYSTEMS = (ServoPendulum(),)
