"""A moving mass: its position, twice differentiated, is the motor's force in newtons.

Source: Janot, Gautier and Brunot, "Data set and reference models of EMPS", Workshop on Nonlinear System Identification
Benchmarks, 2019.
"""

from collections.abc import Mapping

import numpy as np

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of


class MovingMass(System):
    """Force = mass · acceleration + load, with a true zero; changes faster than 100 Hz tell nothing of the mass."""

    name = "moving_mass"
    driver, channel, load, load_unit = "position_m", "force_n", "load_n", 10.0
    free_zero, working_hz, stated_below_hz = False, 100.0, 10.0
    rig: Mapping[str, str] = {"mass_kg": "moving mass in kg, as designed"}
    differentiates = True
    never_zero = frozenset({"mass_kg"})
    tolerance: Mapping[str, float] = {"mass_kg": 0.1}
    ports: Mapping[str, str] = {"resistance": "force", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """The mass, with its relative tolerance."""
        mass = run.rig["mass_kg"]
        return [Parameter("mass_kg", mass, sigma_of(self, run, "mass_kg") * mass)]

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """The motion itself: a force travels nowhere."""
        return inputs.motion

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Force in N."""
        (mass,) = values
        force = mass * inputs.acceleration + inputs.load * self.load_unit
        return np.asarray(force + acts.get("force", np.zeros_like(force)))


SYSTEMS = (MovingMass(),)
