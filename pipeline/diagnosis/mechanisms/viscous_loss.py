"""Stretch that follows the twisting rate, also at low twist [C6]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term


def shapes(drivers: Drivers) -> list[Shape]:
    """`loaded`: whether the loss may grow with the load, which a constant load cannot show."""
    return [{"loaded": float(drivers.loaded)}]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Loss with the rate, straight, with its root, and with the load.

    The root is a string's: where a guide rubs, it would only blur the step of friction into the straight line.
    """
    rate = drivers.rate
    found = [Term("straight_mm_per_turn_s", "resistance", rate, "mm s/turn")]
    if drivers.levered:
        found.append(Term("root_mm", "resistance", np.sign(rate) * np.sqrt(np.abs(rate)), "mm"))
    if shape["loaded"]:
        found.append(Term("loaded_mm_per_turn_s_10_n", "resistance", rate * drivers.load, "mm s/turn/10N"))
    return found


MECHANISM = Mechanism(
    id="viscous_loss",
    driver="twisting rate",
    equation="dx = -c dtheta/dt",
    source="physics.md C6",
    confused_with="sensor_lag (which shows nothing at low twist), friction_hysteresis (which ignores the speed)",
    told_apart_by="three speeds and small strokes at low twist",
    sentence="A loss follows the {rate}, up to {span} ({size}), and is gone as soon as the motor stands.",
    details=("{straight_mm_per_turn_s}",),
    shapes=shapes,
    terms=terms,
)
