"""Equations of what a sensor reads, by functions of numpy."""

import numpy as np
from equation_cases import each, evaluates, one
from equation_motion import STEP_S, TURN, behind

END = "x_m = min(x, x_stop), or max(x, x_stop)"


@evaluates("end_stop", END, {"stop_mm": 4.0, "side": 1.0, "soft_mm": 0.0})
@evaluates("end_stop", END, {"stop_mm": 1.0, "side": -1.0, "soft_mm": 0.0})
@evaluates("end_stop", END, {"stop_mm": 4.0, "side": 1.0, "soft_mm": 1e-3})
def end(m, c, n):
    x_stop = m.x[0] + n["stop_mm"]
    x_m = np.minimum(m.x, x_stop) if n["side"] > 0.0 else np.maximum(m.x, x_stop)
    return one(c, "share_held") * (x_m - m.x)


@evaluates("sensor_drift", "x_m = x + c(t)", {"whole_s": 55.0, "half_waves": 8.0})
@evaluates("sensor_drift", "x_m = x + c(t)", {"whole_s": 55.0, "warming_s": 12.0}, "drive")
def drift(m, c, n):
    share = m.t / n["whole_s"]
    moved = one(c, "straight_mm") * share + one(c, "bent_mm") * share**2
    moved = moved + one(c, "settling_mm") * (1.0 - np.exp(-share / 0.1))
    if "warming_s" in n:
        moved = moved + one(c, "warming_mm") * (1.0 - np.exp(-m.t / n["warming_s"]))
    return moved + sum(size * np.cos(np.pi * float(w[1]) * share) for size, w in each(c, "wandering_([0-9])_mm"))


@evaluates("sensor_drift", "x_m = x + c(t)", {"whole_s": 55.0}, "drive")
def drift_about_its_mean(m, c, n):
    """Where the zero is a true one, what is left of a law after an offset."""
    return drift(m, c, n) - drift(m, c, n).mean()


LAG = "tau dx_m/dt = x - x_m, or x_m(t) = x(t - delay)"


@evaluates("sensor_lag", LAG, {}, left_side="x_m", rates=False, within=0.04)
@evaluates("sensor_lag", LAG, {}, "drive", "x_m", rates=False, within=0.04)
def lag(m, c, n):
    """A clock that runs away by a thousandth is late by a thousandth of the time."""
    x_m = m.x + sum(k * (behind(m.x, float(w[1]), m.x[0]) - m.x) for k, w in each(c, r"filter_([0-9.]+)_s"))
    for k, words in each(c, r"delay_([0-9.]+)_s"):
        late = round(float(words[1]) / STEP_S)
        x_m = x_m + k * (np.concatenate([np.full(late, m.x[0]), m.x[:-late]]) - m.x)
    for k, _ in each(c, "clock_skew"):
        x_m = x_m + 1e3 * (np.interp(m.t - 1e-3 * k * m.t, m.t, m.x) - m.x)
    return x_m - m.x


@evaluates("sensor_lag", LAG, {}, "drive", "x_m")
def late_motion(m, c, n):
    """Where a force follows the acceleration of a motion that is read late: m a(t + delay), m delay being 1."""
    a = m.acceleration / TURN
    return one(c, "late_mm_s3_per_turn") * np.gradient(a, STEP_S)


@evaluates("sensor_offset", "y_m = y + c", {}, "drive", "x_m")
def offset(m, c, n):
    return one(c, "offset_mm") * np.ones_like(m.t)


CLOCK = "x_m(t) = x(t - d(t))"


@evaluates("x_clock", CLOCK, {"whole_s": 55.0, "half_waves": 8.0}, left_side="x_m", strength=0.01, within=0.06)
def clock(m, c, n):
    share = m.t / n["whole_s"]
    d = one(c, "parting_s") * share
    d = d + sum(size * np.cos(np.pi * float(w[1]) * share) for size, w in each(c, "wandering_([0-9])_s"))
    return np.interp(m.t - d, m.t, m.x) - m.x


@evaluates("x_overflow", "x_m = x - d, d' = -d/tau, x_m <= rim", {"rim_mm": 1.5, "forgets_s": 3.0}, "drive")
def overflow(m, c, n):
    rim, d, gone = m.x[0] + n["rim_mm"], 0.0, np.zeros_like(m.x)
    for i, x in enumerate(m.x):
        d -= d / n["forgets_s"] * STEP_S if i else 0.0
        d = max(d, x - rim)
        gone[i] = d
    return -one(c, "share_held") * gone


CURVE = "x_m = x + e(theta), e: any piecewise linear curve"


@evaluates("x_transmission", CURVE, {"from_turns": -5.5, "span_turns": 13.5}, "drive")
def curve(m, c, n):
    """The heights at twelve places, less the straight line that comes nearest to them."""
    places, heights = np.linspace(0.0, 1.0, 12), np.zeros(12)
    for size, words in each(c, "knot_([0-9]+)_mm"):
        heights[int(words[1])] = size
    line = np.polyfit(places, heights, 1)
    theta = ((m.turns - n["from_turns"]) / n["span_turns"]).clip(0.0, 1.0)
    return np.interp(theta, places, heights) - np.polyval(line, theta)


@evaluates("x_wave", "x_m = x + A sin(2 pi f t + p)", {"hz": 0.37})
def wave(m, c, n):
    p = {"sine_mm": 0.0, "cosine_mm": np.pi / 2.0}
    return sum(size * np.sin(2.0 * np.pi * n["hz"] * m.t + p[name]) for name, size in c.items())
