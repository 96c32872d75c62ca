"""A steady oscillation in time that nothing on the rig drives: a swaying floor, a fan, the day's humidity."""

import numpy as np
from scipy.ndimage import median_filter

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import pulled_in

LEAST_PERIODS = 3  # in the recording: slower is no wave
AROUND = 61  # bins of the spectrum that make the background of a line
LINE = 30.0  # times the background: once in 10^9 bins by chance
MOST = 3  # lines of a spectrum that are tried
STEPS = np.linspace(-0.45, 0.45, 7)  # bins beside a line at which its frequency is tried


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """None before a recording suggests one."""
    return []


def lines(signal: Array, time_s: Array) -> Array:
    """Power of a signal over its background, by bin of its spectrum (1/duration each).

    Both given have the shape (samples,), time in s; the answer has the shape (bins,).
    """
    even_s = np.linspace(time_s[0], time_s[-1], len(signal))
    even = np.interp(even_s, time_s, signal - signal.mean())
    power = np.square(np.abs(np.fft.rfft(even * np.hanning(len(even)))))
    return np.asarray(power / (median_filter(power, AROUND, mode="nearest") / np.log(2.0) + 1e-300))


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Frequencies (Hz) of the strongest lines of a residual that are no lines of the motion.

    It has the shape (samples,), in the reading's unit.
    """
    count = len(residual)
    time_s = drivers.time_s[:count]
    height = lines(pulled_in(residual, 6.0), time_s)
    height[lines(drivers.contraction[:count], time_s) > LINE] = 0.0
    height[:LEAST_PERIODS] = 0.0
    whole_s = float(drivers.elapsed_s[count - 1])
    suggested: list[Nonlinear] = []
    for _ in range(MOST):
        peak = int(np.argmax(height))
        if height[peak] < LINE:
            break
        suggested += [{"hz": float(f"{(peak + step) / whole_s:.8g}")} for step in STEPS]
        height[max(peak - 4, 0) : peak + 5] = 0.0
    return suggested


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Sine and cosine of the time."""
    angle = 2.0 * np.pi * nonlinear["hz"] * drivers.elapsed_s
    waves = {"sine_mm": np.sin(angle), "cosine_mm": np.cos(angle)}
    return [Term(name, "sensor", wave, "mm", -np.inf) for name, wave in waves.items()]


MECHANISM = Mechanism(
    id="x_wave",
    driver="time, as a steady oscillation",
    equation="x_m = x + A sin(2 pi f t + p)",
    letters={
        "f": "hz",
        "p": "where the wave begins",
    },
    meanings={
        "hz": "how often it comes in a second",
    },
    source="Den Hartog, Mechanical Vibrations, 1956 (motion of a support)",
    confused_with="load_swing (which follows starts and stops), eccentricity",
    told_apart_by="a rest with the motor off: it goes on",
    meaning="a steady oscillation in time, whatever the rig does; a stand-in, no physics of the library.",
    sentence="The reading oscillates steadily in time, {size}, whatever the rig does.",
    details=("at {hz}",),
    candidates=candidates,
    helper=True,
    units={"hz": "Hz"},
    terms=terms,
    suggest=suggest,
)
