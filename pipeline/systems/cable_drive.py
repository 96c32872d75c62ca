"""A rigid cable drive: the motor's angle, through a constant gear, is the jaw's angle in degrees.

Source: Townsend, The Effect of Transmission Design on Force-Controlled Manipulator Performance, MIT, 1988.
"""

from collections.abc import Mapping

import numpy as np

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of


class CableDrive(System):
    """Jaw = gear · motor, its zero arbitrary. The load is the torque that resists a rising jaw."""

    name = "cable_drive"
    driver, channel, load, load_unit = "motor_deg", "jaw_deg", "torque_nm", 0.1
    turn, working_hz = 360.0, 50.0
    rig: Mapping[str, str] = {"gear_ratio": "degrees of the jaw a degree of the motor"}
    may_be_negative = never_zero = frozenset({"gear_ratio"})
    tolerance: Mapping[str, float] = {"gear_ratio": 0.05}
    ports: Mapping[str, str] = {"twist": "twist", "length": "length", "resistance": "resistance", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """The gear, with its relative tolerance."""
        gear = run.rig["gear_ratio"]
        return [Parameter("gear_ratio", gear, sigma_of(self, run, "gear_ratio") * abs(gear))]

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """Jaw angle in degrees, rising with the motor's whatever the sense of the gear."""
        return np.abs(values[0]) * inputs.motion

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Jaw angle in degrees, without its zero."""
        (gear,) = values
        nothing = np.zeros_like(inputs.motion)
        turned = gear * (inputs.motion + acts.get("twist", nothing))
        lost = acts.get("length", nothing) + np.sign(gear) * acts.get("resistance", nothing)
        return np.asarray(turned - lost)


SYSTEMS = (CableDrive(),)
