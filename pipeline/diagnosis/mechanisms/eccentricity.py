"""A ripple once per turn: the motor's axis, or the sensor wheel's, is off centre."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

WAVES = {"sine": np.sin, "cosine": np.cos}
HARMONICS = (2, 3)  # of the motor's turn; those of a wheel that turns a few times would copy any curve
LEAST_WHEEL_MM = 8.0  # circumference: no sensor has a smaller wheel


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """On the motor's turn (0), where the motion makes one; or on a sensor wheel by its circumference in mm."""
    reach = float(np.ptp(drivers.contraction))
    seen = drivers.levered and 0.8 * reach > LEAST_WHEEL_MM
    wheels = np.geomspace(LEAST_WHEEL_MM, 0.8 * reach, 10) if seen else np.zeros(0)
    turns = drivers.turn is not None and drivers.span > drivers.turn
    return [
        *([{"wheel_mm": 0.0}] if turns else []), *({"wheel_mm": float(f"{mm:.6g}")} for mm in wheels)
    ]  # fmt: skip


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Sine and cosine of the turn and its harmonics: on the reading, and on the twist, unless a gear is constant."""
    angle = (
        drivers.contraction / nonlinear["wheel_mm"] if nonlinear["wheel_mm"] else drivers.motion / (drivers.turn or 1.0)
    )
    within = np.gradient(angle)  # turns in one sample, over which its reading is a mean
    waves = {name: wave(2.0 * np.pi * angle) * np.sinc(within) for name, wave in WAVES.items()}
    all_terms = [Term(f"{name}_mm", "sensor", wave, "mm", -np.inf) for name, wave in waves.items()]
    if not nonlinear["wheel_mm"] and drivers.levered:
        all_terms += [Term(f"{name}_turns", "twist", wave, "turns", -np.inf) for name, wave in waves.items()]
    for harmonic in HARMONICS if drivers.levered and not nonlinear["wheel_mm"] else ():
        for name, wave in WAVES.items():
            signal = wave(2.0 * np.pi * harmonic * angle) * np.sinc(harmonic * within)
            all_terms.append(Term(f"{name}_{harmonic}_mm", "sensor", signal, "mm", -np.inf))
    return all_terms


MECHANISM = Mechanism(
    id="eccentricity",
    driver="angle within the turn",
    equation="x_m = x + A sin(theta + p)",
    source="Slocum, Precision Machine Design, 1992 (error motion once a turn)",
    confused_with="stick_slip, load_swing",
    told_apart_by="one slow stroke: the ripple follows the turn, not the time",
    meaning="a ripple once a turn.",
    sentence="The {reading} ripples once per turn, {size}.",
    details=("the turn is that of a sensor wheel of {wheel_mm} circumference",),
    candidates=candidates,
    units={"wheel_mm": "mm"},
    terms=terms,
)
