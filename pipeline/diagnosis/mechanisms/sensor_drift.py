"""The zero of the displacement sensor drifts with time, whatever the rig does."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import half_waves

WAVES = 8.0  # half waves over the recording, at most: what a drift does that is no law but a walk
SETTLING = 0.1  # of the recording: time constant of a drift that settles
MEANS = {"straight_mm": 1.0 / 2.0, "bent_mm": 1.0 / 3.0, "settling_mm": 1.0 - SETTLING}  # of each over the recording


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """A law, or one about which the zero wanders by so many `half_waves`; `whole_s` is the recording's length."""
    law = {"whole_s": float(f"{drivers.elapsed_s[-1]:.6g}")}
    return [law, {**law, "half_waves": WAVES}] if drivers.free_zero and drivers.levered else [law]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Straight, bent, settling and wandering drift, of either sign; about its mean where the zero is a true one."""
    share = drivers.elapsed_s / nonlinear["whole_s"]
    signals = {"straight_mm": share, "bent_mm": share**2, "settling_mm": 1.0 - np.exp(-share / SETTLING)}
    means = dict.fromkeys(signals, 0.0) if drivers.free_zero else MEANS
    for count, wave in half_waves(share, nonlinear, 2).items():
        name = f"wandering_{count}_mm"
        signals[name], means[name] = wave, 0.0
    return [Term(name, "sensor", signal - means[name], "mm", -np.inf) for name, signal in signals.items()]


MECHANISM = Mechanism(
    id="sensor_drift",
    driver="absolute time",
    equation="x_m = x + c(t)",
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
    terms=terms,
)
