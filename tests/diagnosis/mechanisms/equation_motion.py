"""A made motion for the equations of docs/physics.md, in N, mm, rad and s, and the same as drivers of a mechanism.

Two loads, holds, three speeds, a temperature: as much as each mechanism asks for. Lengths follow the paper's equations
as the page has them, written down here once more.
"""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from scipy.signal import lfilter

from pipeline.diagnosis.recording.drivers import Drivers
from pipeline.diagnosis.recording.system_units import Units

STEP_S, USUAL_N, TURN = 0.01, 10.0, 2.0 * np.pi
RADIUS_MM, SEPARATOR_MM, ZONE_MM = 0.4, 8.0, 150.0
# until when (s), to which twist (turns), under which load (N)
LEGS = (
    (1.5, 0.5, 9.0), (7.5, 12.0, 9.0), (9.5, 12.0, 9.0), (15.5, 1.0, 9.0), (17.0, 1.0, 24.0), (20.0, 14.0, 24.0),
    (22.0, 14.0, 24.0), (26.0, 4.0, 24.0), (28.0, 9.0, 24.0), (32.0, 0.5, 24.0), (34.0, 0.5, 13.0), (43.0, 13.0, 13.0),
    (44.0, 13.0, 17.0), (53.0, 0.5, 17.0), (55.0, 0.5, 17.0),
)  # fmt: skip
STROKES_S = (0.0, 16.0, 33.0)  # when each begins


@dataclass(frozen=True)
class Motion:
    """What equations listen to, each of shape (samples,), in N, mm, rad and s."""

    t: np.ndarray
    theta: np.ndarray
    rate: np.ndarray  # rad/s
    F: np.ndarray
    x: np.ndarray  # displacement from the first sample on; on a rig without a string, what it reads
    sin_a: np.ndarray
    tan_a: np.ndarray
    T: np.ndarray
    current: np.ndarray
    acceleration: np.ndarray  # rad/s²

    @property
    def turns(self) -> np.ndarray:
        """The motion in turns, which is the unit of its own on a rig without a string."""
        return self.theta / TURN

    @property
    def v(self) -> np.ndarray:
        """Turns a second."""
        return self.rate / TURN

    @property
    def load(self) -> np.ndarray:
        """The load over that at which the numbers hold: F / F_ref."""
        return self.F / USUAL_N


def _moved() -> dict[str, np.ndarray]:
    """The legs, each with a soft beginning and end."""
    t = np.arange(0.0, LEGS[-1][0], STEP_S)
    turns, v, acceleration, load = (np.zeros_like(t) for _ in range(4))
    begin, place, weight = 0.0, LEGS[0][1], LEGS[0][2]
    for end, to, newton in LEGS:
        inside, lasts = (t >= begin) & (t < end), end - begin
        share = (t[inside] - begin) / lasts
        soft = share - np.sin(TURN * share) / TURN
        turns[inside], load[inside] = place + (to - place) * soft, weight + (newton - weight) * soft
        v[inside] = (to - place) / lasts * (1.0 - np.cos(TURN * share))
        acceleration[inside] = (to - place) / lasts**2 * TURN * np.sin(TURN * share)
        begin, place, weight = end, to, newton
    return {"t": t, "theta": TURN * turns, "rate": TURN * v, "acceleration": TURN * acceleration, "F": load}


@cache
def motion(rig: str) -> Motion:
    """The motion of a `string`, or of a `drive` without one, which goes to both sides of 0."""
    moved = _moved()
    t = moved["t"]
    rest = {"T": 21.0 + 4.0 * (1.0 - np.exp(-t / 30.0)) + 0.5 * np.sin(0.2 * t), "current": 0.3 + 0.1 * moved["rate"]}
    ones = np.ones_like(t)
    if rig != "string":
        moved["theta"] = moved["theta"] - 6.0 * TURN
        x = 0.05 * moved["theta"]
        return Motion(**moved, **rest, x=x - x[0], sin_a=ones, tan_a=ones)
    y = SEPARATOR_MM + RADIUS_MM * moved["theta"]
    length = np.sqrt(ZONE_MM**2 + y**2)
    return Motion(**moved, **rest, x=length - length[0], sin_a=y / length, tan_a=y / ZONE_MM)


@cache
def drivers(rig: str, rates: bool = True) -> Drivers:
    """The same as a mechanism has it; without `rates` it must find the rate in the motion."""
    m, samples = motion(rig), np.arange(len(motion(rig).t))
    units = Units("turns", "mm", "N", USUAL_N)
    stroke = np.searchsorted(STROKES_S, m.t, side="right")
    return Drivers(
        units, m.t, m.turns, m.v if rates else None, m.acceleration / TURN, m.load, True, rig == "string",
        rig == "string", 1.0, m.sin_a, m.tan_a, m.x, stroke, np.zeros_like(samples), samples, m.T, m.current,
    )  # fmt: skip


def under_one_load(of: Drivers) -> Drivers:
    """The same under a load that never varies."""
    return replace(of, load=np.full_like(of.load, 1.2), loaded=False)


def behind(signal: np.ndarray, tau_s: float, start: float = 0.0) -> np.ndarray:
    """z of dz/dt = (signal - z)/tau, by the trapezoidal rule from z = start."""
    k = STEP_S / (2.0 * tau_s)
    earlier = np.concatenate([[0.0], (signal[1:] + signal[:-1]) * k])
    earlier[0] = start * (1.0 + k)
    return np.asarray(lfilter([1.0], [1.0 + k, -(1.0 - k)], earlier))


def play(theta: np.ndarray, half_width: np.ndarray | float) -> np.ndarray:
    """What follows within a dead band of half a width to each side; it begins in the middle."""
    followed, width = np.empty_like(theta), np.broadcast_to(half_width, theta.shape)
    last = theta[0]
    for i, (now, half) in enumerate(zip(theta, width, strict=True)):
        last = now - half if now - half > last else now + half if now + half < last else last
        followed[i] = last
    return followed


def stop(theta: np.ndarray, half_width: float) -> np.ndarray:
    """What a play leaves, from -1 to 1: it turns with the direction, within twice the half width."""
    state, out = 0.0, np.zeros_like(theta)
    for i in range(1, len(theta)):
        state = min(max(state + (theta[i] - theta[i - 1]) / half_width, -1.0), 1.0)
        out[i] = state
    return out


def highest(signal: np.ndarray) -> np.ndarray:
    """The highest so far."""
    return np.maximum.accumulate(signal)


def over_time(signal: np.ndarray) -> np.ndarray:
    """The sum over the time so far."""
    return np.cumsum(signal) * STEP_S


def work(m: Motion, power: float) -> np.ndarray:
    """The load to a power over the displacement that winding adds, as a share of all of it."""
    done = np.concatenate([[0.0], np.cumsum(m.F[1:] ** power * np.maximum(np.diff(m.x), 0.0))])
    return done / done[-1]


def growth(name: str, share: np.ndarray) -> np.ndarray:
    """How it grows with a share of the whole, by the word in the name: within_*, steady or faster."""
    if name.startswith("within_"):
        return 1.0 - np.exp(-share / float(name.split("_")[1]))
    return share**2 if name.startswith("faster") else share
