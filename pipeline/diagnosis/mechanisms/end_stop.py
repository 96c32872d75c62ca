"""The displacement is clipped: the carriage meets a stop or the sensor its range [F13]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.kinematics import Array


def shapes(drivers: Drivers) -> list[Shape]:
    """Where the motion ends, as a share of the simulated range; 1: at its upper end, −1: at its lower end."""
    upper = [{"share": float(f"{share:.6g}"), "side": 1.0} for share in np.linspace(0.5, 0.995, 34)]
    return upper + [{"share": float(f"{share:.6g}"), "side": -1.0} for share in np.linspace(0.01, 0.3, 14)]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """The part of the reading that lies beyond the stop is missing."""

    def clipped(reading: Array) -> Array:
        low, high = np.percentile(reading, [0.0, 100.0])
        stop = low + shape["share"] * (high - low)
        return np.asarray(
            np.minimum(reading, stop) - reading if shape["side"] > 0 else np.maximum(reading, stop) - reading
        )

    return [Term("share_held", "sensor", clipped, "1", high=1.1)]


MECHANISM = Mechanism(
    id="end_stop",
    driver="reading at its end",
    equation="x_m = min(x, x_stop)",
    source="physics.md F13",
    confused_with="jam, slack",
    told_apart_by="a stroke that ends above the stop: behind a stop nothing moves at all",
    sentence="The motion is clipped at a stop, which takes {size} away.",
    shapes=shapes,
    terms=terms,
)
