"""The zero of the displacement sensor drifts with time, whatever the rig does."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .plain_drag import drag, drag_along, leaves
from .shared_wander import half_waves, passed, wandering

SETTLING = 0.1  # of the recording: time constant of a drift that settles
WARMINGS = (0.25, 0.5, 1.0, 4.0)  # of the recording: time constants with which a true zero is left as it begins
CLEARLY = 0.8  # of the mean square that an offset leaves
MEANS = {"straight_mm": 1.0 / 2.0, "bent_mm": 1.0 / 3.0, "settling_mm": 1.0 - SETTLING}  # of each over the recording


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """A law, or one about which the zero wanders by so many `half_waves`; `whole_s` is how long a fit sees it.

    Where the zero is a true one, the law is one about its mean, for an offset is another name.
    """
    law = {"whole_s": drivers.seen_s}
    return [law, *wandering(drivers, law)] if drivers.free_zero and drivers.levered else [law]


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """A drift from a true zero at the beginning of the recording, where it is clearly more likely than an offset.

    The residual has the shape (samples,), in the reading's unit.
    """
    if drivers.free_zero:
        return []
    whole_s = drivers.seen_s
    laws = [{"whole_s": whole_s, "warming_s": float(f"{share * whole_s:.6g}")} for share in WARMINGS]
    drag_columns = [*drag(drivers), *drag_along(drivers)]
    drifting = min(leaves(residual, [*drag_columns, warming(drivers, law)]) for law in laws)
    return laws if drifting <= CLEARLY * leaves(residual, [*drag_columns, np.ones_like(drivers.motion)]) else []


def warming(drivers: Drivers, nonlinear: Nonlinear) -> Array:
    """From 0 at the first sample towards 1. Shape (samples,), without a unit."""
    return np.asarray(1.0 - np.exp(-drivers.elapsed_s / nonlinear["warming_s"]))


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Straight, bent, settling and wandering drift, of either sign; about its mean where the zero is a true one.

    A drift that wanders stays where it stood when the fit's last sample was taken.
    """
    if "warming_s" in nonlinear:
        return [Term("warming_mm", "sensor", warming(drivers, nonlinear), "mm", -np.inf)]
    share = passed(drivers, nonlinear)
    signals = {"straight_mm": share, "bent_mm": share**2, "settling_mm": 1.0 - np.exp(-share / SETTLING)}
    means = dict.fromkeys(signals, 0.0) if drivers.free_zero else MEANS
    for count, wave in half_waves(share, nonlinear, 2).items():
        name = f"wandering_{count}_mm"
        signals[name], means[name] = wave, 0.0
    return [Term(name, "sensor", signal - means[name], "mm", -np.inf) for name, signal in signals.items()]


MECHANISM = Mechanism(
    id="sensor_drift",
    driver="absolute time",
    columns=("time",),
    equation="x_m = x + c(t)",
    letters={
        "c": "how far the zero has moved by then",
    },
    meanings={
        "warming_s": "in which time the zero has moved by 63 % of all that it will",
    },
    source=(
        "JCGM 200:2012, International vocabulary of metrology (instrumental drift: a definition, no law); "
        "zero drift: Doebelin, Measurement Systems: Application and Design, 1966"
    ),
    confused_with="creep, thermal, plastic_elongation",
    told_apart_by="a long rest: a drifting zero goes on in it as before",
    meaning="the sensor's zero moves with time.",
    sentence=(
        "The sensor's zero drifts with time, {span} in all ({size}), at work and at rest, and {lowers} the {reading}."
    ),
    candidates=candidates,
    units={"warming_s": "s"},
    terms=terms,
    suggest=suggest,
)
