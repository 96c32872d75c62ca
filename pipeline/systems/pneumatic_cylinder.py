"""A pneumatic cylinder: the pressure on its piston, less what its mass takes, is the force of its rod in newtons.

Source: Beater, Pneumatic Drives, 2007.
"""

from collections.abc import Mapping

import numpy as np

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of

N_PER_MM2_BAR, M_PER_MM = 0.1, 1e-3


class PneumaticCylinder(System):
    """Force = pressure · piston area − mass · acceleration, positive where the rod pushes outwards; a true zero."""

    name = "pneumatic_cylinder"
    driver, channel, load, load_unit = "position_mm", "force_n", "pressure_bar", 1.0
    free_zero, differentiates, working_hz = False, True, 20.0
    rig: Mapping[str, str] = {"bore_mm": "diameter of the piston in mm", "mass_kg": "mass of piston and rod in kg"}
    never_zero = frozenset({"bore_mm"})
    tolerance: Mapping[str, float] = {"bore_mm": 0.005, "mass_kg": 0.1}
    ports: Mapping[str, str] = {"resistance": "lost", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """Bore and mass, with relative tolerances."""
        return [Parameter(key, run.rig[key], sigma_of(self, run, key) * run.rig[key]) for key in self.rig]

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """The motion itself: a force travels nowhere."""
        return inputs.motion

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Force in N; what resists the motion takes of it."""
        bore, mass = values
        pushed = 0.25 * np.pi * bore**2 * N_PER_MM2_BAR * inputs.load * self.load_unit
        return np.asarray(pushed - mass * M_PER_MM * inputs.acceleration - acts.get("lost", 0.0))


SYSTEMS = (PneumaticCylinder(),)
