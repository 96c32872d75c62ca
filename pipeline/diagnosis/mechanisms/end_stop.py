"""The displacement is clipped: the carriage meets a stop or the sensor its range."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import hinge

UPPER = np.linspace(0.45, 1.09, 36)  # of the nominal range; calibration may stretch it
SOFT = 0.015  # of the nominal range: how softly a stop of rubber begins
LEAST_HELD = 0.7  # least share: a stop holds all motion beyond it, calibration aside; a softer one is no stop
TOP, FEWEST = 95.0, 20  # percentile of the reading above which it is highest; moving samples there
BELOW = (0.0, 0.001, 0.002, 0.004, 0.007, 0.011)  # of the range of the reading: how far a stop lies below its highest
HIGHEST = 99.7  # percentile of the reading that counts as its highest
LOWER = np.linspace(0.01, 0.3, 14)  # of the nominal range: where a stop at its low end may lie


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Where the motion ends, in mm from where it starts; side 1: at its upper end, −1: at its lower end."""
    low, high = float(drivers.contraction.min()), float(drivers.contraction.max())
    places = [(share, 1.0) for share in UPPER] + [(share, -1.0) for share in LOWER]
    return [
        {"stop_mm": float(f"{low + share * (high - low):.6g}"), "side": side, "soft_mm": float(f"{soft:.6g}")}
        for share, side in places
        for soft in ((0.0, SOFT * (high - low)) if drivers.levered else (0.0,))
    ]


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Stops just below the highest reading; the grid is too coarse for a stop that clips a thousandth of the range.

    Residual and prediction have the shape (samples,), in the reading's unit.
    """
    if not drivers.levered:
        return []
    reading = predicted + residual
    low, high = np.percentile(reading, [100.0 - HIGHEST, HIGHEST])
    return [
        {"stop_mm": float(f"{high - share * (high - low) - predicted[0]:.6g}"), "side": 1.0, "soft_mm": 0.0}
        for share in BELOW
    ]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """The part of the reading beyond the stop, which is taken off."""

    def clipped(reading: Array) -> Array:
        stop = reading[0] + nonlinear["stop_mm"]
        beyond, soft = nonlinear["side"] * (reading - stop), nonlinear["soft_mm"]
        beyond_stop = hinge(beyond, 0.0, soft) if soft > 0.0 else np.maximum(beyond, 0.0)
        return np.asarray(-nonlinear["side"] * beyond_stop)

    return [Term("share_held", "sensor", clipped, "1", LEAST_HELD, 1.4)]


def mark(drivers: Drivers, residual: Array, predicted: Array) -> float:
    """How much less than predicted the reading moves near its highest value: 6 where it stands still.

    Residual and prediction have the shape (samples,), in the reading's unit.
    """
    reading, moved = residual + predicted, np.abs(np.diff(predicted))
    top = (reading[1:] > np.percentile(reading, TOP)) & (moved > 0.2 * np.percentile(moved, 95))
    if top.sum() < FEWEST:
        return 0.0
    share = float(np.sum(np.diff(reading)[top] * np.sign(np.diff(predicted)[top])) / np.sum(moved[top]))
    return 6.0 * float(np.clip(1.0 - share, 0.0, 1.0))


MECHANISM = Mechanism(
    id="end_stop",
    driver="reading at its end",
    columns=("contraction at its end",),
    equation="x_m = min(x, x_stop), or max(x, x_stop)",
    letters={
        "x_stop": "stop_mm",
    },
    meanings={
        "side": "1 means: at the upper end; -1 means: at the lower end",
        "soft_mm": "how softly the stop begins: 0 is hard",
        "stop_mm": "where the reading stops, from where the recording begins",
    },
    source=(
        "Brogliato, Nonsmooth Mechanics, 1999 (contact on one side); "
        "a sensor at its range: Khalil, Nonlinear Systems, 2002 (saturation)"
    ),
    confused_with="jam, slack",
    told_apart_by="a stroke that ends above the stop: behind a stop nothing moves at all",
    meaning="the motion is cut off at an end.",
    sentence="The motion is clipped at a stop, which takes up to {span} away ({size}).",
    details=("the stop is {stop_mm} from where the recording begins",),
    clips=True,
    candidates=candidates,
    suggest=suggest,
    terms=terms,
    mark=mark,
)
