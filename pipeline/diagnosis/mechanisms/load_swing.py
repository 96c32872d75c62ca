"""Ringing: load and string oscillate after every start and stop [F14]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.recursions import resonator

LOWEST_HZ, LOWEST_STIFF_HZ = 0.4, 3.0  # of a load that hangs on a string; of what a stiff drive moves


def shapes(drivers: Drivers) -> list[Shape]:
    """Frequency in Hz (at 10 N) and damping; a spring under a dead weight swings slower the heavier it is."""
    highest = min(0.35 / drivers.step_s, 25.0)
    kinds = (0.0, 1.0) if drivers.loaded else (0.0,)
    return [
        {"frequency_hz": float(f"{hz:.6g}"), "damping": damping, "heavy_slow": kind}
        for hz in np.geomspace(LOWEST_HZ if drivers.levered else LOWEST_STIFF_HZ, highest, 26)
        for damping in (0.04, 0.15)
        for kind in kinds
    ]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Response of a damped oscillator to the acceleration of the contraction, in two phases."""
    load = np.maximum(drivers.load, 0.05)
    hz = shape["frequency_hz"] * (load**-0.5 if shape["heavy_slow"] else np.ones_like(load))
    hz = np.minimum(hz, 0.45 / drivers.step_s)
    position, velocity = resonator(drivers.contraction, drivers.time_s, hz, shape["damping"])
    ahead = velocity - np.gradient(drivers.contraction, drivers.time_s) / (2.0 * np.pi * hz)
    return [
        Term("swing", "length", drivers.contraction - position - 2 * shape["damping"] * velocity, "1", -np.inf),
        Term("swing_late", "length", ahead, "1", -np.inf),
    ]


MECHANISM = Mechanism(
    id="load_swing",
    driver="acceleration",
    equation="q'' + 2 z w q' + w^2 q = -a",
    source="physics.md F14",
    confused_with="sensor_lag, eccentricity",
    told_apart_by="an abrupt stop followed by a hold",
    sentence="Load and {string} ring after starts and stops, {size}.",
    details=("at {frequency_hz}, with a damping ratio of {damping}",),
    shapes=shapes,
    terms=terms,
)
