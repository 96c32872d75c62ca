"""Ringing: load and string oscillate after every start and stop."""

import numpy as np
from scipy.ndimage import median_filter

from ...ground.kinematics import Array
from ..numerics.recursions import resonator
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import pulled_in

# length of its stretches; bins of its background; times that; lines: of the spectrum that tells where a residual rings
STRETCH_S, AROUND, RINGING, MOST = 20.0, 31, 4.0, 3
LEAKS = 4  # bins, into which a line leaks
NEAR = (0.98, 1.0, 1.02)  # of a line's frequency
LOWEST_HZ, LOWEST_STIFF_HZ = 0.4, 3.0  # of a load that hangs on a string; of what a stiff drive moves


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Frequency in Hz (at 10 N) and damping; a spring under a dead weight swings slower the heavier it is."""
    highest = min(0.35 / drivers.step_s, 25.0)
    kinds = (0.0, 1.0) if drivers.loaded else (0.0,)
    return [
        {"frequency_hz": float(f"{hz:.6g}"), "damping": damping, "heavy_slow": kind}
        for hz in np.geomspace(LOWEST_HZ if drivers.levered else LOWEST_STIFF_HZ, highest, 16)
        for damping in (0.04, 0.15)
        for kind in kinds
    ]


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Frequencies at which a residual rings: the strongest lines of its spectrum, and the first two together.

    It has the shape (samples,), in the reading's unit.
    """
    if not drivers.levered:
        return []
    time_s = drivers.time_s[: len(residual)]
    height, step_hz = ringing(pulled_in(residual, 8.0), time_s)
    hz = step_hz * np.arange(len(height))
    height[(hz < LOWEST_HZ) | (hz > min(0.45 / drivers.step_s, 25.0))] = 0.0
    power, lines_hz = _lines(residual, drivers.step_s)
    peaks: list[float] = []
    for _ in range(MOST):
        peak = int(np.argmax(height))
        if height[peak] < RINGING:
            break
        near = np.abs(lines_hz - hz[peak]) <= step_hz
        peaks.append(float(lines_hz[near][np.argmax(power[near])]))
        height[np.abs(hz - hz[peak]) < max(0.12 * hz[peak], LEAKS * step_hz)] = 0.0
    suggested: list[Nonlinear] = []
    for peak_hz in peaks:
        for share in NEAR:
            nonlinear = {"frequency_hz": float(f"{share * peak_hz:.6g}"), "heavy_slow": 0.0}
            suggested += [{**nonlinear, "damping": damping} for damping in (0.015, 0.04, 0.1)]
    if len(peaks) > 1:
        both = {"frequency_hz": float(f"{peaks[0]:.6g}"), "second_hz": float(f"{peaks[1]:.6g}"), "heavy_slow": 0.0}
        suggested += [{**both, "damping": damping} for damping in (0.015, 0.04, 0.1)]
    return suggested


def _lines(residual: Array, step_s: float) -> tuple[Array, Array]:
    """Power of the whole residual's spectrum, and where its lines lie, in Hz; each of shape (lines,).

    A swing that dies slowly keeps its beat for longer than a stretch. The residual has the shape (samples,).
    """
    power = np.square(np.abs(np.fft.rfft(residual * np.hanning(len(residual)))))
    return power, np.asarray(np.fft.rfftfreq(len(residual), step_s), float)


def ringing(residual: Array, time_s: Array) -> tuple[Array, float]:
    """Power of a residual over its background, by bin of the mean spectrum of its stretches, and the bins' width.

    Both given have the shape (samples,), time in s; powers have the shape (bins,), the width is in Hz.
    """
    step_s = float(np.median(np.diff(time_s)))
    length = int(min(len(residual) // 4, STRETCH_S / step_s))
    window = np.hanning(length)
    starts = range(0, len(residual) - length + 1, max(length // 2, 1))
    power = np.mean([np.square(np.abs(np.fft.rfft(window * residual[at : at + length]))) for at in starts], axis=0)
    return power / (median_filter(power, AROUND, mode="nearest") + 1e-300), 1.0 / (length * step_s)


def mark(drivers: Drivers, residual: Array, predicted: Array) -> float:
    """How far the strongest line of a residual's spectrum stands out.

    Both have the shape (samples,), in the reading's unit.
    """
    height, step_hz = ringing(pulled_in(residual, 8.0), drivers.time_s[: len(residual)])
    lowest = int(np.ceil(LOWEST_HZ / step_hz))
    return float(np.clip(np.log(max(float(height[lowest:].max(initial=1.0)), 1.0)), 0.0, 6.0))


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Response of a damped oscillator to the acceleration of the contraction, in two phases."""
    load = np.maximum(drivers.load, 0.05)
    hz = nonlinear["frequency_hz"] * (load**-0.5 if nonlinear["heavy_slow"] else np.ones_like(load))
    hz = np.minimum(hz, 0.45 / drivers.step_s)
    all_terms = mode(drivers, hz, nonlinear["damping"], "swing")
    if "second_hz" in nonlinear:
        all_terms += mode(drivers, np.full_like(load, nonlinear["second_hz"]), nonlinear["damping"], "second_swing")
    return all_terms


def mode(drivers: Drivers, hz: Array, damping: float, name: str) -> list[Term]:
    """One mode's response, in two phases. `hz` has the shape (samples,), in Hz."""
    position, velocity = resonator(drivers.contraction, drivers.time_s, hz, damping)
    ahead = velocity - np.gradient(drivers.contraction, drivers.time_s) / (2.0 * np.pi * hz)
    return [
        Term(name, "length", drivers.contraction - position - 2 * damping * velocity, "1", -np.inf),
        Term(f"{name}_late", "length", ahead, "1", -np.inf),
    ]


MECHANISM = Mechanism(
    id="load_swing",
    driver="acceleration",
    columns=("acceleration",),
    equation="dx = k q, q'' + 2 z w q' + w^2 q = -a",
    letters={
        "a": "the acceleration of the string's end",
        "q": "how far the load swings",
        "w": "how fast it swings: 2 pi x frequency_hz, over the root of F/F_ref where heavy_slow is 1",
        "z": "damping",
    },
    meanings={
        "damping": "how fast the swing dies: 0 never, 1 at once",
        "frequency_hz": "how fast it swings, under 10 N",
        "heavy_slow": "1 means: it swings slower under a heavier load, and 0: always alike",
        "second_hz": "how fast the second swing is",
    },
    strengths=("k",),
    names={"late": "-(q'/w + 2 z q), which comes a quarter of a swing after q"},
    source="Den Hartog, Mechanical Vibrations, 1956 (a damped mass on a spring whose support moves)",
    confused_with="sensor_lag, eccentricity",
    told_apart_by="an abrupt stop followed by a hold",
    meaning="the load swings on the string, and rings after starts and stops.",
    sentence="Load and {string} ring after starts and stops, {size}.",
    details=("at {frequency_hz}, with a damping ratio of {damping}",),
    candidates=candidates,
    terms=terms,
    suggest=suggest,
    mark=mark,
    optional=("second_hz",),
)
