# ruff: noqa: E501, SIM905
"""Throw-away recordings for tests and benchmarks: effects written with other formulas than the library's, on purpose.

Time runs at four times the recorded rate; effects are integrated by plain Euler steps, plays are distributed, growth
laws are powers, lags are two poles with a dead time. Sizes are set by what calibration cannot absorb (`kappa`, in
noise floors).
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
import yaml
from scipy.optimize import lsq_linear

OVER = 4
BOUND = np.array([np.inf, 3.0, 3.0, 3.0])  # sigma that calibration may move a dimension


@dataclass
class Motion:
    """Commanded inputs on the fine clock."""

    t: np.ndarray
    turns: np.ndarray
    load: np.ndarray
    stroke: np.ndarray
    kelvin: np.ndarray
    geometry: dict


def protocol(rng, rich: bool, rate_hz: float, top: float) -> tuple[np.ndarray, ...]:
    """Time, turns, load, stroke on the fine clock."""
    dt = 1.0 / (rate_hz * OVER)
    turns, load, stroke = [], [], []
    loads = np.array([8.0, 16.0, 26.0]) * rng.uniform(0.8, 1.2)
    speeds = np.array([1.2, 2.5, 5.0]) * rng.uniform(0.8, 1.2)
    plan = [(loads[i % 3], speeds[(i // 3 + i) % 3]) for i in range(15)] if rich else [(loads[1], speeds[1])] * 12
    if rich:
        rng.shuffle(plan)
    low = 0.0
    at = low

    def hold(seconds, value, f, n):
        k = int(seconds / dt)
        turns.append(np.full(k, value))
        load.append(np.full(k, f))
        stroke.append(np.full(k, n))

    def move(a, b, speed, f, n):
        ramp = speed / 20.0  # turns in which it accelerates, s-curve by raised cosine
        seconds = abs(b - a) / speed + 0.15
        k = max(int(seconds / dt), 2)
        s = np.linspace(0, 1, k)
        w = 0.15 / seconds
        v = np.clip(np.minimum(s / w, (1 - s) / w), 0, 1)
        path = np.cumsum(v)
        turns.append(a + (b - a) * path / path[-1])
        load.append(np.full(k, f))
        stroke.append(np.full(k, n))
        return ramp

    hold(2.0, at, plan[0][0], 1)
    for n, (f, v) in enumerate(plan, 1):
        goal = top * (rng.choice([1.0, 1.0, 0.7, 0.85]) if rich else 1.0)
        move(at, goal, v, f, n)
        hold(rng.choice([1.0, 4.0, 12.0]) if rich else 0.3, goal, f, n)
        move(goal, low, v, f, n)
        at = low
        if rich:
            hold(rng.choice([1.0, 5.0, 20.0]), low, f, n)
        else:
            hold(0.3, low, f, n)
    turns, load, stroke = map(np.concatenate, (turns, load, stroke))
    k = int(0.3 / dt)
    load = np.convolve(np.pad(load, (k, 0), mode="edge"), np.ones(k) / k, mode="full")[k : k + len(load)]
    return np.arange(len(turns)) * dt, turns, load, stroke


def geometric(m: Motion, turns, squeeze, g=None):
    g = g or m.geometry
    r = g["radius"] * np.sqrt(g["length"] / (g["length"] + m.load / g["stiffness"])) * squeeze
    half = g["separator"] + 2 * np.pi * turns * r
    return np.sqrt(g["zone"] ** 2 + half**2) - g["zone"]


def euler(drive, t, tau):
    z = np.zeros_like(drive)
    step = np.diff(t)
    for i in range(1, len(z)):
        z[i] = z[i - 1] + step[i - 1] * (drive[i - 1] - z[i - 1]) / tau
    return z


def rateloop(theta, width, sharp=2.0):
    """Bouc-Wen-like smooth hysteresis of the twist, −1…1."""
    z = np.zeros_like(theta)
    for i in range(1, len(z)):
        d = theta[i] - theta[i - 1]
        z[i] = z[i - 1] + (d - abs(d) * z[i - 1] * abs(z[i - 1]) ** (sharp - 1)) / width
        z[i] = min(max(z[i], -1), 1)
    return z


def simulate(m: Motion, kind: str, a: float, rng_seed: int) -> np.ndarray:
    """Displacement on the fine clock with one effect of amplitude `a` (0: none)."""
    return compound(m, [(kind, a)], rng_seed)


def compound(m: Motion, effects, seed: int) -> np.ndarray:
    t, th, f = m.t, m.turns, m.load / 15.0
    top = th.max()
    twist, squeeze, stretch = th.copy(), np.ones_like(th), np.zeros_like(th)
    late = []
    for kind, a in effects:
        rng = np.random.default_rng(seed + 77 * len(kind))
        u = rng.uniform
        x0 = geometric(m, th, 1.0)
        c = np.cumsum(np.maximum(np.diff(x0, prepend=x0[0]), 0)) / np.ptp(x0)
        alpha = np.arctan((m.geometry["separator"] + 2 * np.pi * th * m.geometry["radius"]) / m.geometry["zone"])
        if kind == "plastic_elongation":
            dc = np.diff(c, prepend=0) * f ** u(0.6, 1.2)
            p = u(0.35, 0.6)
            stretch += a * np.cumsum(dc * p * (c + 0.15) ** (p - 1))
        elif kind == "creep":  # logarithmic recovery by a fractional-like ladder
            for w, tau in zip(u(0.5, 1, 3), u(0.7, 1.3) * np.array([2.5, 11.0, 70.0]), strict=True):
                stretch += a * w * euler(f, t, tau)
        elif kind == "thermal":
            if u() < 0.5:
                stretch += a * (m.kelvin - m.kelvin[0]) * (1 + 0.02 * (m.kelvin - m.kelvin[0]))
            else:
                v = np.abs(np.gradient(th, t))
                heat = euler(v * f * (0.2 + np.sin(alpha)), t, u(30, 60))
                stretch += a * (0.6 * heat + 0.4 * euler(heat, t, 40.0))
        elif kind == "stiffening":
            k = 1 + a * np.log1p(2 * c) / np.log(20)
            stretch += 15 * f / m.geometry["stiffness"] * 3 * (1 / k - 1)
        elif kind == "axial_elasticity":
            stretch += a * (f**0.8 - f[0] ** 0.8)
        elif kind == "radius_compaction":
            s = u(0.2, 0.6)
            phi = 0.6 * (1 + a * f**s * np.tan(alpha) ** 2)
            squeeze *= np.sqrt(0.6 * (1 + a * f**s * np.tan(alpha[0]) ** 2) / phi)
        elif kind == "wear":
            squeeze *= 1 - a * np.sign(u(-1, 1)) * (c / c[-1]) ** u(0.5, 1.1)
        elif kind == "u_swelling":  # damp air thickens the strands
            squeeze *= 1 + a * np.sqrt(t / t[-1])
        elif kind == "friction_hysteresis":
            loop = 0.7 * rateloop(th, u(0.25, 0.5)) + 0.3 * rateloop(th, u(0.8, 1.6))
            stretch += a * loop * (np.exp(0.4 * f * np.sin(alpha)) - 1 + 0.1 * f)
        elif kind == "viscous_loss":
            v = np.gradient(th, t)
            stretch += a * np.sign(v) * np.abs(v) ** 0.85
        elif kind == "backlash":
            w = a
            s = th.copy()
            s[0] = th[0] - w
            for i in range(1, len(s)):
                s[i] = min(max(s[i - 1], th[i] - w), th[i] + w)
            twist += s - th
        elif kind == "shaft_windup":
            torque = f * np.sin(alpha)
            twist -= a * (torque + 0.3 * torque**2)
        elif kind == "count_slip":
            for when in rng.choice(np.flatnonzero(np.abs(np.gradient(th, t)) > 0.5), rng.integers(1, 4), replace=False):
                twist -= a * (t >= t[when])
        elif kind == "slack":
            s = a
            twist = np.where(
                twist > 0, np.sqrt(twist**2 + s**2) - s * (1 - np.exp(-twist / (3 * s + 1e-9))) * 0.0 - s, twist
            )
        elif kind == "jam":
            tc = top * u(0.65, 0.85)
            over = np.maximum(th - tc, 0)
            twist -= over - top * 0.25 / (a + 1e-12) * np.log1p(over * a / (top * 0.25)) if a > 0 else 0
        elif kind == "overtwist":
            tc, back = top * u(0.6, 0.8), top * u(0.04, 0.1)
            on, z = False, np.zeros_like(th)
            for i in range(len(th)):
                on = th[i] > tc if not on else th[i] > tc - back
                goal = max(th[i] - tc + back, 0) if on else 0.0
                z[i] = goal if i == 0 else z[i - 1] + 0.02 * (goal - z[i - 1])
            stretch -= a * z**1.2
        elif kind == "stick_slip":
            v = np.abs(np.gradient(th, t))
            gate = 1 / (1 + (v / 1.6) ** 4)
            s = x0.copy()
            reach = u(0.3, 0.8)
            for i in range(1, len(s)):
                s[i] = s[i - 1]
                if abs(x0[i] - s[i]) > reach:
                    s[i] = x0[i] - 0.1 * reach * np.sign(x0[i] - s[i])
            stretch += a * gate * (x0 - s)
        elif kind == "clamp_slip":
            for when in rng.choice(len(t), rng.integers(1, 3), replace=False):
                stretch += a / (1 + np.exp(-np.clip((t - t[when]) / 0.03, -50, 50)))
        else:
            late.append((kind, a, rng))
    x = geometric(m, twist, squeeze) - stretch
    for kind, a, rng in late:
        u = rng.uniform
        if kind == "sensor_lag":
            k = int(0.3 * a / (t[1] - t[0]))
            y = np.concatenate([np.full(k, x[0]), x[: len(x) - k]])
            x = (
                x[0] + euler(euler(y - x[0], t, max(0.4 * a, t[1] - t[0])), t, max(0.3 * a, t[1] - t[0]))
                if a > 0
                else x
            )
        elif kind == "sensor_drift":
            x = x + a * (t / t[-1]) ** u(0.7, 1.4) * np.sign(u(-1, 1))
        elif kind == "eccentricity":
            x = x + a * np.sin(2 * np.pi * th + u(0, 6)) * (1 + 0.1 * np.cos(2 * np.pi * th))
        elif kind == "end_stop":
            stop = x.max() - a
            x = np.where(x > stop, stop + 0.02 * (x - stop), x)
        elif kind == "load_swing":
            w, z = 2 * np.pi * u(1.5, 4.0) * np.sqrt(1 / f), 0.06
            acc = np.gradient(np.gradient(x, t), t)
            q = v = 0.0
            out = np.zeros_like(x)
            dt = t[1] - t[0]
            for i in range(len(x)):
                v += dt * (-2 * z * w[i] * v - w[i] ** 2 * q - acc[i])
                q += dt * v
                out[i] = q
            x = x + a * out
        elif kind == "u_clock":  # the sensor's clock is slow, and jumps ahead once
            x = np.interp(t - a * (t / t[-1] - 0.7 * (t > 0.6 * t[-1])), t, x)
        elif kind == "u_encoder":  # interpolation error of the displacement encoder
            p = u(1.5, 3.0)
            x = x + a * np.sin(2 * np.pi * x / p) + 0.4 * a * np.sin(4 * np.pi * x / p + 1)
        elif kind == "u_bump":
            tc = top * u(0.35, 0.7)
            x = x + a * np.exp(-0.5 * ((th - tc) / (0.05 * top)) ** 2)
        elif kind == "u_resonance":  # speed-band vibration
            v = np.abs(np.gradient(th, t))
            x = x + a * np.sin(2 * np.pi * 3 * th) * (v > 0.3)
        elif kind == "u_humidity":  # slow wave in time
            x = x + a * np.sin(2 * np.pi * t / (t[-1] * u(0.12, 0.3)) + u(0, 6))
        elif kind == "u_tangle":  # comes and goes by strokes
            x = x - a * (rng.random(m.stroke.max() + 2) < 0.4)[m.stroke] * np.exp(-((((th / top) - 0.6) / 0.15) ** 2))
    return x


SINGLE = (
    "plastic_elongation creep thermal stiffening axial_elasticity radius_compaction wear friction_hysteresis viscous_loss backlash "
    "shaft_windup count_slip slack jam overtwist stick_slip clamp_slip sensor_lag sensor_drift eccentricity end_stop load_swing"
).split()
UNKNOWN = "u_encoder u_bump u_resonance u_humidity u_tangle u_clock u_swelling".split()
START = {"backlash": 0.05, "slack": 0.3, "jam": 0.5, "sensor_lag": 0.03, "radius_compaction": 0.1, "wear": 0.01, "stiffening": 0.1,
         "shaft_windup": 0.05, "u_swelling": 0.01, "count_slip": 0.1, "load_swing": 1.0}  # fmt: skip


def beyond(effect: np.ndarray, m: Motion, floor: float) -> np.ndarray:
    """Part of an effect that calibration (dimensions with their tolerances, and the zero) cannot absorb."""
    g = m.geometry
    columns = [np.ones_like(effect)]
    for name, sd in (("radius", 0.03 * g["radius"]), ("separator", 0.5), ("zone", 1.0)):
        moved = {**g, name: g[name] + 0.01 * sd}
        columns.append((geometric(m, m.turns, 1.0, moved) - geometric(m, m.turns, 1.0)) / 0.01)
    j = np.array(columns).T[::OVER]
    e = effect[::OVER]
    lam = floor**2 * np.eye(j.shape[1])
    lam[0, 0] = 0
    solution = lsq_linear(np.vstack([j, np.sqrt(lam)]), np.concatenate([e, np.zeros(4)]), (-BOUND, BOUND)).x
    return e - j @ solution


def recording(
    folder: Path, name: str, effects: list[tuple[str, float]], seed: int, rich: bool = True, nuisance: str = "plain"
) -> dict:
    """Write `folder/<name>` with effects of given kappa; returns the truth."""
    rng = np.random.default_rng(seed)
    rate = float(rng.choice([25.0, 50.0]))
    g = {"radius": rng.uniform(0.35, 0.6), "separator": rng.uniform(6, 10), "zone": rng.uniform(130, 180), "length": 320.0,
         "stiffness": rng.uniform(20, 60)}  # fmt: skip
    top = 0.5 * g["zone"] / (2 * np.pi * g["radius"]) * rng.uniform(0.8, 1.15)
    t, turns, load, stroke = protocol(rng, rich, rate, top)
    kelvin = 22 + 3 * np.sin(2 * np.pi * t / t[-1] * rng.uniform(0.6, 1.6) + rng.uniform(0, 6)) + 0.5 * np.sin(t / 40)
    m = Motion(t, turns, load, stroke, kelvin, g)
    floor = rng.uniform(0.02, 0.06)
    plain = compound(m, [], seed)
    sized = []
    for kind, kappa in effects:
        a = START.get(kind, 0.2)
        for _ in range(25):
            size = np.sqrt(np.mean(beyond(compound(m, [(kind, a)], seed) - plain, m, floor) ** 2)) / floor
            if size > 0 and abs(size / kappa - 1) < 0.03:
                break
            a *= np.clip((kappa / max(size, 1e-6)) ** 0.8, 0.2, 5)
        sized.append((kind, float(a)))
    x = compound(m, sized, seed)
    effect = x - plain
    keep = np.arange(0, len(t), OVER)
    if nuisance == "jitter":
        keep = np.clip(keep + rng.integers(-1, 2, len(keep)), 0, len(t) - 1)
        keep = np.unique(keep)
    n = len(keep)
    rho = np.exp(-OVER * (t[1] - t[0]) / rng.uniform(0.1, 0.4 if nuisance != "colour" else 1.0))
    share = 0.5 if nuisance != "colour" else 0.85
    e = rng.standard_normal(n + 500)
    colour = np.zeros(n + 500)
    for i in range(1, n + 500):
        colour[i] = rho * colour[i - 1] + np.sqrt(1 - rho**2) * e[i]
    noise = floor * (np.sqrt(1 - share**2) * rng.standard_normal(n) + share * colour[500:])
    measured = x[keep] * (1 + rng.normal(0, 0.002)) + noise
    if nuisance == "outliers":
        at = rng.random(n) < 0.004
        measured[at] += rng.choice([-1, 1], at.sum()) * rng.uniform(10, 60, at.sum()) * floor
    measured = np.round((measured - rng.uniform(-2, 2)) / 0.005) * 0.005
    stay = rng.random(n) > 0.002
    table = pd.DataFrame(
        {"time_s": t[keep], "motor_turns": np.round(turns[keep] * 2000) / 2000, "displacement_mm": measured,
         "load_n": load[keep] + 0.05 * rng.standard_normal(n), "temperature_c": kelvin[keep] + 0.05 * rng.standard_normal(n)}
    )[stay]  # fmt: skip
    folder = folder / name
    folder.mkdir(parents=True, exist_ok=True)
    table.to_parquet(folder / "recording.parquet", index=False)
    wrong = rng.normal(0, 1, 3) if nuisance != "exact" else np.zeros(3)
    content = {
        "run": name,
        "string": {
            "material": "Test",
            "radius_mm": float(g["radius"] * (1 + 0.03 * wrong[0])),
            "length_mm": 320,
            "stiffness_n_per_mm": float(g["stiffness"]),
        },
        "rig": {"torsion_zone_mm": float(g["zone"] + wrong[1]), "separator_mm": float(g["separator"] + 0.5 * wrong[2])},
    }
    (folder / "run.yaml").write_text(yaml.safe_dump(content))
    post = beyond(effect, m, floor)
    rms = {
        kind: float(
            np.sqrt(
                np.mean((compound(m, sized, seed) - compound(m, [o for o in sized if o[0] != kind], seed))[::OVER] ** 2)
            )
        )
        for kind, _ in sized
    }
    return {"effects": [kind for kind, _ in effects], "floor": floor, "geometry": g, "rms_mm": rms, "kappa": float(np.sqrt(np.mean(post**2)) / floor),
            "mismatch": post, "turns": turns[::OVER], "stroke": stroke[::OVER], "nuisance": nuisance}  # fmt: skip
