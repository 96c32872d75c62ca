"""One axis of a robot that moves alone: its angle, twice differentiated, and its weight are the torque in Nm.

Source: Khalil and Dombre, Modeling, Identification and Control of Robots, 2002.
"""

from collections.abc import Mapping

import numpy as np

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of


class RobotAxis(System):
    """Torque = inertia · acceleration + two parts of weight, of the sine and cosine of the angle; none if upright."""

    name = "robot_axis"
    driver, channel = "joint_rad", "torque_nm"
    free_zero, differentiates, working_hz = False, True, 20.0
    rig: Mapping[str, str] = {"inertia_kg_m2": "moment of inertia at the joint in kg m²"}
    optional_rig: Mapping[str, str] = {
        "weight_sine_nm": "torque of the weight at a right angle in Nm",
        "weight_cosine_nm": "torque of the weight at an angle of 0 in Nm",
    }
    never_zero = frozenset({"inertia_kg_m2"})
    may_be_negative = frozenset({"weight_sine_nm", "weight_cosine_nm"})
    tolerance: Mapping[str, float] = {"inertia_kg_m2": 0.1, "weight_sine_nm": 0.1, "weight_cosine_nm": 0.1}
    ports: Mapping[str, str] = {"resistance": "torque", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """The inertia and the weight, with relative tolerances; a weight that nobody gave stays away."""
        sizes = {key: run.rig.get(key, 0.0) for key in self.tolerance}
        return [Parameter(key, size, sigma_of(self, run, key) * abs(size)) for key, size in sizes.items()]

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """The motion itself: a torque travels nowhere."""
        return inputs.motion

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Torque in Nm."""
        inertia, sine, cosine = values
        weight = sine * np.sin(inputs.motion) + cosine * np.cos(inputs.motion)
        return np.asarray(inertia * inputs.acceleration + weight + acts.get("torque", 0.0))


SYSTEMS = (RobotAxis(),)
