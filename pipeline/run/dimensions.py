"""The nominal dimensions of a run's string and rig."""

import math

from ..ground.kinematics import Geometry
from .description import Run


def geometry(run: Run) -> Geometry:
    """Nominal dimensions of a string run."""
    assert run.string is not None
    return Geometry(
        run.actuator,
        run.string.radius_mm,
        run.string.length_mm,
        run.string.nominal_stiffness_n_per_mm,
        run.rig.get("torsion_zone_mm", math.nan),
        run.rig.get("separator_mm", math.nan),
    )
