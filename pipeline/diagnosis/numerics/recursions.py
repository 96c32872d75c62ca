"""The recursions of the simulator and of the fit, compiled: plays, filters, resonators, whitening.

Source: Krasnosel'skii and Pokrovskii, Systems with Hysteresis, 1989 (play); Den Hartog, Mechanical Vibrations, 1956
(resonator); Box and Jenkins, Time Series Analysis, 1970 (whitening).
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from ...ground.kinematics import Array

CACHED = 2048  # samples that a filter works on together: what the processor holds near


@njit(cache=True)
def play(motion: Array, half_width: Array) -> Array:
    """Play operator: the output follows a motion with a dead band of ± half_width (one value a sample); starts centred.

    Motion, half-width and answer in one unit, each of shape (samples,).
    """
    out = np.empty_like(motion)
    state = motion[0]
    for i in range(motion.size):
        state = min(max(state, motion[i] - half_width[i]), motion[i] + half_width[i])
        out[i] = state
    return out


@njit(cache=True)
def lowpass(signal: Array, time_s: Array, tau_s: float, start: float) -> Array:
    """First-order low-pass dz/dt = (signal − z)/τ, exact for a signal that is constant within a step.

    Time and τ in s; answer and `start` in the signal's unit, shape (samples,).
    """
    out = np.empty_like(signal)
    state = start
    out[0] = state
    for i in range(1, signal.size):
        keep = np.exp(-(time_s[i] - time_s[i - 1]) / tau_s)
        middle = 0.5 * (signal[i] + signal[i - 1])
        state = middle + (state - middle) * keep
        out[i] = state
    return out


@njit(cache=True)
def resonator(drive: Array, time_s: Array, frequency_hz: Array, damping: float) -> tuple[Array, Array]:
    """Position and velocity/ω of q″ + 2ζω q′ + ω² q = ω² drive, by exact steps of a straight drive; starts at rest.

    A drive at constant rate m is followed at a constant distance, q = drive - 2ζ m/ω, however coarse the steps are.
    Time in s, frequency in Hz; all of shape (samples,), both answers in the drive's unit.
    """
    position, velocity = np.zeros_like(drive), np.zeros_like(drive)
    q, v = 0.0, 0.0
    for i in range(1, drive.size):
        omega = 2.0 * np.pi * frequency_hz[i]
        step = time_s[i] - time_s[i - 1]
        damped = omega * np.sqrt(1.0 - damping * damping)
        decay = np.exp(-damping * omega * step)
        c, s = np.cos(damped * step), np.sin(damped * step)
        rate = (drive[i] - drive[i - 1]) / step if step > 0.0 else 0.0
        behind = 2.0 * damping * rate / omega
        gap = q - (drive[i - 1] - behind)
        slope = (v - rate + damping * omega * gap) / damped
        q = drive[i] - behind + decay * (gap * c + slope * s)
        v = rate + decay * ((slope * damped - damping * omega * gap) * c - (gap * damped + damping * omega * slope) * s)
        position[i], velocity[i] = q, v / omega
    return position, velocity


@njit(cache=True)
def sticking(motion: Array, reach: float, back: float) -> Array:
    """A sticking part: it stays until a motion is `reach` ahead, then jumps to `back` behind it; both ways, in steps.

    All in the motion's unit; shape (samples,).
    """
    out = np.empty_like(motion)
    state = motion[0]
    for i in range(motion.size):
        gap = motion[i] - state
        if abs(gap) > reach:
            state = motion[i] - np.sign(gap) * back
        out[i] = state
    return out


@njit(cache=True)
def whiten(columns: Array, ar: Array, first: NDArray[np.intp]) -> Array:
    """Innovations of each column (shape (columns, samples)) under an AR model; rows before its order are scaled.

    `first[i]` is the number of samples since the last break (start of a run), so that no filter reaches across it.
    Innovations are in the columns' unit; `ar` of shape (order,).
    """
    out = np.empty(columns.shape)
    whiten_from(columns, ar, first, 0, out)
    return out


@njit(cache=True)
def whiten_from(columns: Array, ar: Array, first: NDArray[np.intp], start: int, out: Array) -> None:
    """Write into `out`, shape (columns, stretch), the result of `whiten` for a stretch of samples from `start` on.

    In the columns' unit.
    """
    taps = np.zeros(6 * ((ar.size + 5) // 6))  # six at a time: a pass over the samples costs more than a product
    for k in range(ar.size):  # here and below one by one: sooner, and compiled in half the time
        taps[k] = ar[k]
    order, stop = taps.size, start + out.shape[1]
    before, predicted = np.zeros(order + CACHED), np.empty(CACHED)
    at = start
    while at < stop:
        count = 1
        while count < CACHED and at + count < stop and first[at + count] > 0:
            count += 1
        earlier = min(first[at], order, at)
        for j in range(columns.shape[0]):
            before[: order - earlier] = 0.0
            kept, signal = before[order - earlier : order + count], columns[j, at - earlier : at + count]
            for i in range(earlier + count):
                kept[i] = signal[i]
            predicted[:count] = 0.0
            for k in range(0, order, 6):
                a, b, c, d, e, f = taps[k], taps[k + 1], taps[k + 2], taps[k + 3], taps[k + 4], taps[k + 5]
                late = before[order - k - 6 : order - k + count]
                for i in range(count):
                    predicted[i] += a * late[i + 5] + b * late[i + 4] + c * late[i + 3] + d * late[i + 2]
                    predicted[i] += e * late[i + 1] + f * late[i]
            for i in range(count):
                out[j, at - start + i] = before[order + i] - predicted[i]
        at += count


@njit(cache=True)
def coloured(draws: Array, ar: Array, innovation: float) -> Array:
    """Noise under an AR model from white draws, shape (draws, samples), each from rest: the inverse of `whiten`.

    `innovation` in the noise's unit; `ar` of shape (order,).
    """
    out = np.empty(draws.shape)
    order = ar.size
    for j in range(draws.shape[0]):
        owed = np.zeros(order + 1)  # to the samples that come, by those that were: the transposed direct form
        for i in range(draws.shape[1]):
            value = innovation * draws[j, i] + owed[0]
            for k in range(order):
                owed[k] = owed[k + 1] + ar[k] * value
            out[j, i] = value
    return out
