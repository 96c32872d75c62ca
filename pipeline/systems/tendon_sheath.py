"""A tendon in a sheath: the pull at one end turns a pulley at the other end, in degrees.

Source: Kaneko, Yamashita and Tanie, "Basic considerations on transmission characteristics for tendon drive robots",
1991.
"""

from collections.abc import Mapping

import numpy as np

from ..ground.kinematics import Array
from .interface import Described, Inputs, Parameter, System, sigma_of


class TendonSheath(System):
    """Tip angle = pull / radius of its pulley, the tendon inextensible and without friction; its zero arbitrary."""

    name = "tendon_sheath"
    driver, channel, load, load_unit = "pull_mm", "tip_deg", "tension_n", 10.0
    working_hz = 50.0
    rig: Mapping[str, str] = {"pulley_radius_mm": "radius of the pulley at the tip in mm"}
    never_zero = frozenset({"pulley_radius_mm"})
    tolerance: Mapping[str, float] = {"pulley_radius_mm": 0.05}
    ports: Mapping[str, str] = {"twist": "pull", "length": "tip", "resistance": "tip", "sensor": "sensor"}

    def parameters(self, run: Described) -> list[Parameter]:
        """The radius, with its relative tolerance."""
        radius = run.rig["pulley_radius_mm"]
        return [Parameter("pulley_radius_mm", radius, sigma_of(self, run, "pulley_radius_mm") * radius, lowest=1e-3)]

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Tip angle in degrees, without its zero."""
        (radius,) = values
        turned = np.degrees((inputs.motion + acts.get("pull", 0.0)) / radius)
        return np.asarray(turned - acts.get("tip", 0.0))


SYSTEMS = (TendonSheath(),)
