"""The commands of a cable drive: the motor's angle and the load on the jaw, 1 kHz for 20 s."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from ...ground.kinematics import Array

STEP_S = 1e-3
TIME_S: Array = np.arange(20_000, dtype=np.float64) * STEP_S
AMPLITUDE_DEG = 30.0
LOADS_NM = (0.010, 0.024, 0.038, 0.050)
STEPS = ("steps",)
KINDS = ("sine", "loads", "swing")  # each followed by -0.1 ... -0.6, in Hz


@dataclass(frozen=True)
class Told:
    """Motor angle in deg and torque of the load device in Nm; both of shape (samples,)."""

    motor_deg: Array
    torque_nm: Array


def told(plan: str, loads_nm: Sequence[float] | None, rng: np.random.Generator) -> Told:
    """The motion and the load of a plan; raises ValueError for a plan that is not known.

    `sine-HZ`: a sine under one load; `loads-HZ`: the load changes after every cycle or few; `swing-HZ`: the load
    swings slowly by itself; `steps`: trapezoids with pauses, the load changes within some of them. `loads_nm` are
    the levels gone through, one for `sine`, drawn from 0.01 to 0.05 Nm when not given.
    """
    kind, _, hertz = plan.partition("-")
    if plan not in STEPS and (kind not in KINDS or not 0.05 <= float(hertz or 0) <= 2.0):
        raise ValueError(f"{plan} is no plan; known are steps and sine-, loads- and swing- with 0.05 to 2 Hz")
    levels = np.array(loads_nm if loads_nm is not None else rng.permutation(LOADS_NM), float)
    motor_deg = _trapezoids(rng) if kind == "steps" else _sine(float(hertz), rng)
    if kind == "sine":
        level_nm = np.full(len(TIME_S), levels[0])
    elif kind == "swing":
        low, high = levels.min(), levels.max()
        middle, half = (low + high) / 2, (high - low) / 2 or 0.4 * high
        swing_hz = float(hertz) * rng.uniform(0.28, 0.41)
        level_nm = middle + half * np.sin(2 * np.pi * swing_hz * TIME_S + rng.uniform(0, 2 * np.pi))
    else:
        changes = max(len(levels), 4)
        bounds = np.linspace(0, len(TIME_S), changes + 1) + rng.uniform(-400, 400, changes + 1)
        part = np.clip(np.searchsorted(bounds[1:-1], np.arange(len(TIME_S))), 0, changes - 1)
        level_nm = gaussian_filter1d(levels[part % len(levels)], 60.0, mode="nearest")
    return Told(motor_deg, _torque(level_nm, motor_deg, rng))


def _sine(hertz: float, rng: np.random.Generator) -> Array:
    """A sine from 0 to twice the amplitude as a motor follows it: a little late at first, a little distorted."""
    begun_s = np.maximum(TIME_S - 0.3, 0.0)
    turn = 2 * np.pi * hertz * begun_s
    bent = rng.uniform(-0.01, 0.01) * np.sin(2 * turn) + rng.uniform(-0.004, 0.004) * np.sin(3 * turn)
    return np.asarray(AMPLITUDE_DEG * (1.0 - np.cos(turn) + bent))


def _trapezoids(rng: np.random.Generator) -> Array:
    """Ways up and down at several speeds, every other one with a stop half way, with pauses between."""
    corners_s, corners_deg, at_deg = [0.5], [0.0], 0.0
    low_deg, high_deg, way = 0.0, 2 * AMPLITUDE_DEG, 0
    while corners_s[-1] < TIME_S[-1]:
        to_deg = (high_deg if way % 2 == 0 else low_deg) + rng.uniform(-3.0, 3.0) * (way > 0)
        stops = [(at_deg + to_deg) / 2, to_deg] if way % 4 in (1, 2) else [to_deg]
        speed = rng.uniform(25.0, 75.0)
        for stop in stops:
            corners_s += [corners_s[-1] + abs(stop - corners_deg[-1]) / speed]
            corners_deg += [stop]
            corners_s += [corners_s[-1] + rng.uniform(0.35, 0.9)]
            corners_deg += [stop]
        at_deg, way = to_deg, way + 1
    return np.asarray(gaussian_filter1d(np.interp(TIME_S, corners_s, corners_deg), 25.0, mode="nearest"))


def _torque(level_nm: Array, motor_deg: Array, rng: np.random.Generator) -> Array:
    """The load device: it lets in gently, pulls a little harder further out, and drags either way."""
    coming = 0.2 + 0.8 * -np.expm1(-TIME_S / 0.12)
    leaning = 1.0 + rng.uniform(-0.08, 0.02) * (motor_deg / AMPLITUDE_DEG - 1.0)
    drag = np.zeros(len(motor_deg))
    reach_deg = rng.uniform(1.5, 3.0)
    steps = np.diff(motor_deg, prepend=motor_deg[0])
    for k in range(1, len(drag)):
        drag[k] = drag[k - 1] + (np.sign(steps[k]) - drag[k - 1]) * -np.expm1(-abs(steps[k]) / reach_deg)
    return np.asarray(level_nm * coming * (leaning - rng.uniform(0.06, 0.13) * drag))
