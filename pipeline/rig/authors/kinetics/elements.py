"""Populations with memory, stepped element by element: sliders, relays, coils, contacts that stick and slip."""

import numpy as np
from numba import njit

from pipeline.ground.kinematics import Array


@njit(cache=True)
def sliders(drive: Array, bounds: Array, weights: Array, scale: Array) -> Array:
    """Weighted sum of what sliders hold back of a drive, each up to its bound times `scale`."""
    held = -bounds * scale[0]
    out = np.empty(len(drive))
    before = drive[0]
    for k in range(len(drive)):
        step = drive[k] - before
        before = drive[k]
        total = 0.0
        for i in range(len(bounds)):
            bound = bounds[i] * scale[k]
            held[i] = min(max(held[i] + step, -bound), bound)
            total += weights[i] * held[i]
        out[k] = total
    return out


@njit(cache=True)
def relays(drive: Array, up: Array, down: Array, weights: Array) -> Array:
    """Weighted share of relays that are on; each goes on above its `up` and off below its `down`."""
    on = drive[0] > up
    out = np.empty(len(drive))
    for k in range(len(drive)):
        total = 0.0
        for i in range(len(up)):
            if drive[k] > up[i]:
                on[i] = True
            elif drive[k] < down[i]:
                on[i] = False
            if on[i]:
                total += weights[i]
        out[k] = total
    return out


@njit(cache=True)
def hopping(drive: Array, barriers: Array, rate: float, step_s: float) -> Array:
    """Mean occupation of two-state elements; `drive` tilts the barrier that each has to cross, both ways."""
    filled = np.zeros(len(barriers))
    out = np.empty(len(drive))
    for k in range(len(drive)):
        tilt = min(max(drive[k], -40.0), 40.0)
        total = 0.0
        for i in range(len(barriers)):
            forth = rate * np.exp(tilt - barriers[i])
            back = rate * np.exp(-tilt - barriers[i])
            rest = forth / (forth + back)
            filled[i] = rest + (filled[i] - rest) * np.exp(-(forth + back) * step_s)
            total += filled[i]
        out[k] = total / len(barriers)
    return out


@njit(cache=True)
def eyring(drive: Array, barriers: Array, start: Array, softness: float, step_s: float) -> Array:
    """Mean strain of Eyring dashpots beside springs: each flows by sinh of the stress that its spring leaves."""
    strain = start.copy()
    out = np.empty(len(drive))
    for k in range(len(drive)):
        total = 0.0
        for i in range(len(barriers)):
            # exact over a step: tanh(u/2) of the reduced stress u falls exponentially
            half = np.tanh((drive[k] - strain[i]) / (2.0 * softness)) * np.exp(-np.exp(-barriers[i]) * step_s)
            strain[i] = drive[k] - 2.0 * softness * np.arctanh(half)
            total += strain[i]
        out[k] = total / len(barriers)
    return out


@njit(cache=True)
def slipping(drive: Array, bounds: Array, drop: float, ageing: float, step_s: float) -> Array:
    """What one contact holds back of a drive until it lets go; `bounds` are met in turn, and grow with its age."""
    held = 0.0
    age_s = 0.0
    at = 0
    out = np.empty(len(drive))
    before = drive[0]
    for k in range(len(drive)):
        held += drive[k] - before
        before = drive[k]
        age_s += step_s
        if abs(held) > bounds[at % len(bounds)] * (1.0 + ageing * np.log1p(age_s / 0.1)):
            held *= 1.0 - drop
            age_s = 0.0
            at += 1
        out[k] = held
    return out


@njit(cache=True)
def rung(push: Array, omega: float, damping: float, friction: float, step_s: float) -> Array:
    """An oscillator under a push, with viscous damping and damping that grows with its own speed."""
    place = 0.0
    speed = 0.0
    out = np.empty(len(push))
    for k in range(len(push)):
        for _ in range(4):
            force = push[k] - omega * omega * place - 2.0 * damping * omega * speed - friction * abs(speed) * speed
            speed += force * step_s / 4.0
            place += speed * step_s / 4.0
        out[k] = place
    return out
