"""Shaft and coupling twist elastically under the string's torque [D2]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term


def shapes(drivers: Drivers) -> list[Shape]:
    """One shape; none without a lever that changes, where wind-up is stretch: `axial_elasticity`."""
    return [{}] if drivers.levered else []


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Twist lost in proportion to the torque F r sin a, and a part that stiffens."""
    torque = drivers.load * drivers.sine
    return [
        Term("turns_per_10_n", "twist", -torque, "turns/10N"),
        Term("stiffening_turns_per_10_n", "twist", -np.sign(torque) * np.sqrt(np.abs(torque)), "turns/10N"),
    ]


MECHANISM = Mechanism(
    id="shaft_windup",
    driver="torque (load x twist)",
    equation="theta_s = theta - F r sin a / k_t",
    source="physics.md D2",
    confused_with="radius_compaction, a wrong radius (under one load)",
    told_apart_by="two loads; or lock the string's end and twist",
    sentence="The shaft winds up under the torque of the {string}, which costs up to {span} of {reading} ({size}).",
    details=("{turns_per_10_n} in proportion to the torque",),
    shapes=shapes,
    terms=terms,
)
