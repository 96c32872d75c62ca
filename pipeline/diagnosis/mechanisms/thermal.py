"""Length follows temperature, measured or from self-heating [A8, A9]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.recursions import lowpass
from pipeline.diagnosis.shapes import time_constants

TIMES_S = (10.0, 30.0, 90.0, 270.0, 800.0)
LEAST_RANGE_K = 0.3


def shapes(drivers: Drivers) -> list[Shape]:
    """Lengthens or shortens when warm, by the measured temperature where there is one or by self-heating."""
    measured = drivers.temperature_c is not None and np.ptp(drivers.smooth(drivers.temperature_c)) > LEAST_RANGE_K
    return [{"sign": sign, "measured": kind} for kind in ((1.0, 0.0) if measured else (0.0,)) for sign in (1.0, -1.0)]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Strain with the measured temperature (at once or delayed), or with filtered friction and motor power."""
    sign, found = shape["sign"], []
    if shape["measured"]:
        assert drivers.temperature_c is not None
        kelvin = drivers.smooth(drivers.temperature_c)
        kelvin = kelvin - kelvin[0]
        found.append(Term("at_once_mm_per_k", "length", sign * kelvin, "mm/K"))
        for tau_s in time_constants(drivers, TIMES_S[:4:2]):
            delayed = lowpass(kelvin, drivers.time_s, tau_s, 0.0)
            found.append(Term(f"after_{tau_s:g}_s_mm_per_k", "length", sign * delayed, "mm/K"))
        return found
    rate = np.abs(drivers.rate)
    powers = {"friction": rate * np.abs(drivers.load), "speed": rate**2}
    if drivers.current_a is not None:
        powers["current"] = drivers.current_a**2
    for name, power in powers.items():
        usual = float(np.mean(power)) or 1.0
        for tau_s in time_constants(drivers, TIMES_S):
            warm = lowpass(power / usual, drivers.time_s, tau_s, 0.0)
            found.append(Term(f"{name}_{tau_s:g}_s_mm", "length", sign * warm))
    return found


MECHANISM = Mechanism(
    id="thermal",
    driver="temperature",
    equation="dx = -a (T - T0), dT/dt = (power - T)/tau where T is not measured",
    source="physics.md A8, A9",
    confused_with="creep, plastic_elongation, sensor_drift",
    told_apart_by="another speed and a pause at the same load: only heat follows the power; or a thermocouple",
    sentence="The length follows the temperature, by {size}.",
    shapes=shapes,
    terms=terms,
)
