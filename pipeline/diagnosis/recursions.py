"""The recursions of the simulator and of the fit, compiled: plays, filters, resonators, whitening."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from ..ground.kinematics import Array


@njit(cache=True)
def play(motion: Array, half_width: Array) -> Array:
    """Play operator: what follows a motion with a dead band of ± half_width (one value a sample); starts centred."""
    out = np.empty_like(motion)
    state = motion[0]
    for i in range(motion.size):
        state = min(max(state, motion[i] - half_width[i]), motion[i] + half_width[i])
        out[i] = state
    return out


@njit(cache=True)
def lowpass(signal: Array, time_s: Array, tau_s: float, start: float) -> Array:
    """First-order low-pass dz/dt = (signal − z)/τ, exact for a signal that is constant within a step."""
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
    """Position and velocity/ω of q″ + 2ζω q′ + ω² q = ω² drive, by exact steps of constant drive; starts at rest."""
    position, velocity = np.zeros_like(drive), np.zeros_like(drive)
    q, v = 0.0, 0.0
    for i in range(1, drive.size):
        omega = 2.0 * np.pi * frequency_hz[i]
        step = time_s[i] - time_s[i - 1]
        damped = omega * np.sqrt(1.0 - damping * damping)
        decay = np.exp(-damping * omega * step)
        c, s = np.cos(damped * step), np.sin(damped * step)
        target = 0.5 * (drive[i] + drive[i - 1])
        gap = q - target
        slope = (v + damping * omega * gap) / damped
        q = target + decay * (gap * c + slope * s)
        v = decay * ((slope * damped - damping * omega * gap) * c - (gap * damped + damping * omega * slope) * s)
        position[i], velocity[i] = q, v / omega
    return position, velocity


@njit(cache=True)
def sticking(motion: Array, reach: float, back: float) -> Array:
    """What sticks until a motion is `reach` ahead, then jumps to `back` behind it; moves in steps, both ways."""
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
    """
    out = columns.copy()
    taps = np.zeros(6 * ((ar.size + 5) // 6))  # six at a time: a pass over the samples costs more than a product
    taps[: ar.size] = ar
    breaks = np.append(np.flatnonzero(first[1:] == 0) + 1, columns.shape[1])
    start = 0
    for end in breaks:
        count = end - start
        before = np.zeros(taps.size + count)
        for j in range(columns.shape[0]):
            before[taps.size :], predicted = columns[j, start:end], np.zeros(count)
            for k in range(0, taps.size, 6):
                a, b, c, d, e, f = taps[k], taps[k + 1], taps[k + 2], taps[k + 3], taps[k + 4], taps[k + 5]
                late = before[taps.size - k - 6 : taps.size - k + count]
                for i in range(count):
                    predicted[i] += a * late[i + 5] + b * late[i + 4] + c * late[i + 3] + d * late[i + 2]
                    predicted[i] += e * late[i + 1] + f * late[i]
            out[j, start:end] -= predicted
        start = end
    return out


@njit(cache=True)
def boxed(gram: Array, moment: Array, low: Array, high: Array, start: Array) -> Array:
    """Least ½βᵀGβ − hᵀβ with low ≤ β ≤ high: active set (bounded-variable least squares), for small problems."""
    k = moment.size
    x = np.minimum(np.maximum(start, low), high)
    scale = np.sqrt(np.maximum(np.diag(gram), 1e-300))
    free = (x > low) & (x < high)
    barred = np.zeros(k, np.bool_)
    for _ in range(6 * k + 20):
        # inner: solve on the free set, walking back to the first bound that is met
        for _inner in range(3 * k + 5):
            index = np.flatnonzero(free)
            if index.size == 0:
                break
            m = index.size
            a = np.empty((m, m))
            r = np.empty(m)
            for p in range(m):
                r[p] = moment[index[p]] / scale[index[p]]
                for q in range(k):
                    if not free[q]:
                        r[p] -= gram[index[p], q] * x[q] / scale[index[p]]
                for q in range(m):
                    a[p, q] = gram[index[p], index[q]] / (scale[index[p]] * scale[index[q]])
                a[p, p] += 1e-9
            solution = np.linalg.solve(a, r)
            step, hit = 1.0, -1
            for p in range(m):
                j = index[p]
                target = solution[p] / scale[j]
                if target < low[j] or target > high[j]:
                    bound = low[j] if target < low[j] else high[j]
                    move = target - x[j]
                    share = (bound - x[j]) / move if move != 0.0 else 0.0
                    if share < step:
                        step, hit = max(share, 0.0), j
            for p in range(m):
                j = index[p]
                x[j] += step * (solution[p] / scale[j] - x[j])
            if hit < 0:
                break
            x[hit] = low[hit] if abs(x[hit] - low[hit]) <= abs(x[hit] - high[hit]) else high[hit]
            free[hit] = False
            if step == 0.0:
                barred[hit] = True
        # outer: free the bound variable whose gradient points inside most
        best, chosen = 1e-7 * (1.0 + np.max(np.abs(moment / scale))), -1
        for j in range(k):
            if free[j] or barred[j] or low[j] == high[j]:
                continue
            slope = moment[j]
            for q in range(k):
                slope -= gram[j, q] * x[q]
            slope /= scale[j]
            if x[j] >= high[j]:
                slope = -slope
            if slope > best:
                best, chosen = slope, j
        if chosen < 0:
            break
        free[chosen] = True
    return x


@njit(cache=True)
def fitted(
    gram: Array, moment: Array, columns: NDArray[np.intp], low: Array, high: Array, start: Array
) -> tuple[Array, float]:
    """Bounded solution on some columns of a large problem, and its misfit less the target's square."""
    k = columns.size
    part, side = np.empty((k, k)), np.empty(k)
    for p in range(k):
        side[p] = moment[columns[p]]
        for q in range(k):
            part[p, q] = gram[columns[p], columns[q]]
    solution = boxed(part, side, low, high, start)
    misfit = 0.0
    for p in range(k):
        misfit -= 2.0 * side[p] * solution[p]
        for q in range(k):
            misfit += solution[p] * part[p, q] * solution[q]
    return solution, misfit


@njit(cache=True)
def scan(
    gram: Array,
    moment: Array,
    given: NDArray[np.intp],
    starts: NDArray[np.intp],
    counts: NDArray[np.intp],
    low: Array,
    high: Array,
    start: Array,
    known: int,
) -> tuple[Array, NDArray[np.intp]]:
    """Misfit (less the target's square) and active columns of fits on given columns and each of several blocks."""
    misfit, active = np.empty(starts.size), np.empty(starts.size, np.intp)
    for block in range(starts.size):
        columns = np.concatenate((given, starts[block] + np.arange(counts[block])))
        solution, misfit[block] = fitted(gram, moment, columns, low[columns], high[columns], start[columns])
        active[block] = 0
        for p in range(known, columns.size):
            if np.abs(solution[p]) * np.sqrt(gram[columns[p], columns[p]]) > 1.0:
                active[block] += 1
    return misfit, active
