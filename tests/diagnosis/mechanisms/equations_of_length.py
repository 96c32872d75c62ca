"""Equations of what lengthens a string, by functions of numpy."""

import numpy as np
from equation_cases import candidate, each, evaluates, one
from equation_motion import (
    STEP_S,
    TURN,
    USUAL_N,
    behind,
    growth,
    highest,
    over_time,
    play,
    work,
)


@evaluates("axial_elasticity", "dx = -(F - F_tare)/K - (toe(F) - toe(F_tare))", {"from_load": 1.4})
def stretch(m, c, n):
    tare, dx = USUAL_N * n["from_load"], np.zeros_like(m.F)
    for straight, _ in each(c, "straight_mm_per_10_n"):
        stiffness = USUAL_N / straight
        dx -= (m.F - tare) / stiffness

    def toe(newton):
        bent = one(c, "yielding_mm") * (newton / USUAL_N) ** 2
        return bent + sum(size * (1.0 - np.exp(-newton / float(w[1]))) for size, w in each(c, r"toe_(.*)_n_mm"))

    return dx - (toe(m.F) - toe(tare))


@evaluates("clamp_slip", "dx = -sum s_i [t >= t_i]", {"at_s": 20.0, "within_s": 0.0}, jumps=True)
def slip(m, c, n):
    return -one(c, "mm") * (m.t >= n["at_s"])


@evaluates("clamp_slip", "dx = -sum s_i [t >= t_i]", {"at_s": 20.0, "within_s": 0.4})
def slip_within(m, c, n):
    return -one(c, "mm") * (m.t >= n["at_s"]) * (1.0 - np.exp(-(m.t - n["at_s"]).clip(0.0) / n["within_s"]))


@evaluates("creep", "dx = -sum z_i, dz_i/dt = (a_i F - z_i)/tau_i", candidate("creep", fresh=1.0))
@evaluates("creep", "dx = -sum z_i, dz_i/dt = (a_i F - z_i)/tau_i", candidate("creep", fresh=0.0))
def creep(m, c, n):
    tension = {
        "load": m.load, "steep_load": m.load**2, "twist": m.load * m.tan_a**2, "steep_twist": m.load * m.tan_a**4
    }  # fmt: skip
    dx = np.zeros_like(m.F)
    for a, words in each(c, r"(.*?)_([0-9.]+)_s_mm_per_10_n"):
        drive = a * tension[words[1]]
        z0 = 0.0 if n["fresh"] else drive[0]
        dx -= behind(drive, float(words[2]), z0) - z0
    return dx


SWING = "dx = k q, q'' + 2 z w q' + w^2 q = -a"


@evaluates("load_swing", SWING, {"frequency_hz": 0.7, "damping": 0.15, "heavy_slow": 0.0}, within=0.01)
@evaluates("load_swing", SWING, {"frequency_hz": 0.9, "damping": 0.04, "heavy_slow": 1.0}, within=0.02)
@evaluates("load_swing", SWING, {"frequency_hz": 0.5, "second_hz": 1.1, "damping": 0.1, "heavy_slow": 0.0}, within=0.02)
def swing(m, c, n):
    """By small steps of the equation; the string's end has the displacement's acceleration."""
    dx, fine = np.zeros_like(m.x), 8
    a = np.gradient(np.gradient(m.x, STEP_S), STEP_S)
    for name, hz in (("swing", n["frequency_hz"]), ("second_swing", n.get("second_hz", 0.0))):
        if not {name, f"{name}_late"} & set(c):
            continue
        w = TURN * hz / (np.sqrt(m.load) if n["heavy_slow"] else np.ones_like(m.load))
        z, q, speed = n["damping"], 0.0, 0.0
        for i in range(1, len(m.x)):
            for part in range(fine):
                now = a[i - 1] + (a[i] - a[i - 1]) * (part + 0.5) / fine
                speed += STEP_S / fine * (-now - 2.0 * z * w[i] * speed - w[i] ** 2 * q)
                q += STEP_S / fine * speed
            dx[i] = one(c, name) * q - one(c, f"{name}_late") * (speed / w[i] + 2.0 * z * q)
    return dx


OVERTWIST = "dx = +k max(theta' - theta_c, 0) + h n, theta' the twist or its play"


@evaluates("overtwist", OVERTWIST, {"critical_turns": 8.0, "softness_turns": 1e-3, "top_turns": 14.0}, within=0.01)
def overtwist(m, c, n):
    critical, top = n["critical_turns"], n["top_turns"]

    def coil(born, wide):
        """1 from where it is born until it melts, twice a share of `top_turns` below."""
        now, out = False, np.zeros_like(m.t)
        for i, twist in enumerate(m.turns):
            now = twist > born or (now and twist > born - 2.0 * wide * top)
            out[i] = now
        return out

    dx = np.zeros_like(m.t)
    for k, words in each(c, r"loop_([0-9.]+)_mm_per_turn(2?)"):
        wide = float(words[1]) * top
        beyond = np.maximum(play(m.turns, wide) + wide - critical, 0.0)  # the play lags at the critical twist alone
        dx += k * (beyond**2 if words[2] else beyond)
    for k, words in each(c, r"coiled_([0-9.]+)_mm_per_turn"):
        melts = critical - 2.0 * float(words[1]) * top
        dx += k * coil(critical, float(words[1])) * (m.turns - melts)
    for h, words in each(c, r"born_([0-9.]+)_loop_([0-9.]+)_mm"):
        way = np.array([-0.06, -0.03, 0.0, 0.03, 0.06]) + float(words[1])  # five coils that are born near each other
        dx += h * np.mean([coil(critical + part * (top - critical), float(words[2])) for part in way], axis=0)
    return dx + one(c, "slowly_mm_per_turn") * behind(np.maximum(m.turns - critical, 0.0), 1.0)


PLASTIC = "dx = -P, P = P_L (F/F_ref)^n g(c) + k max(T - T_y, 0) + q A"


@evaluates("plastic_elongation", PLASTIC, candidate("plastic_elongation", load_power=0.0), within=0.02)
@evaluates("plastic_elongation", PLASTIC, candidate("plastic_elongation", load_power=1.0), within=0.02)
@evaluates("plastic_elongation", PLASTIC, candidate("plastic_elongation", load_power=2.0), within=0.02)
def plastic(m, c, n):
    longer = np.zeros_like(m.F)
    for size, words in each(c, r"((?:within_[0-9.]+|steady))(_root_load|_whole_load|)_mm"):
        power = {"": 0.0, "_root_load": 0.5, "_whole_load": 1.0}[words[2]]
        longer += size * m.load**power * growth(words[1], work(m, n["load_power"]))
    for name, tension in (("load", m.load), ("twist", m.load * m.tan_a**2)):
        longer += one(c, f"new_highest_{name}_mm") * (highest(tension) - tension[0])
    steep = {"flat": 0.0, "half": 0.5, "twice": 2.0}
    for size, words in each(c, r"(yields|flows)_([0-9.]+)_(flat|half|twice)_mm(?:_per_s)?"):
        tension = m.load * (1.0 + steep[words[3]] * (m.tan_a / m.tan_a.max()) ** 2)
        beyond = np.maximum(tension / tension.max() - float(words[2]), 0.0) / (1.0 - float(words[2]))
        longer += size * (over_time(beyond) if words[1] == "flows" else behind(highest(beyond), 1.0))
    return -longer


STICKS = "dx = -k (x - s), s sticks until |x - s| > reach, then slips"


@evaluates("stick_slip", STICKS, {"reach_mm": 0.5, "back_share": 0.0, "usual_rate": 1.3})
@evaluates("stick_slip", STICKS, {"reach_mm": 0.5, "back_share": 0.25, "usual_rate": 1.3})
def sticks(m, c, n):
    s, gap = m.x[0], np.zeros_like(m.x)
    for i, x in enumerate(m.x):
        if abs(x - s) > n["reach_mm"]:
            s = x - n["back_share"] * n["reach_mm"] * (1.0 if x > s else -1.0)
        gap[i] = x - s
    return -(one(c, "always") + one(c, "slow") * np.exp(-((m.v / n["usual_rate"]) ** 2))) * gap


STIFFER = "dx = +(F - F_0) (1/K_0 - 1/K), 1/K = 1/K_0 - k g(c)"


@evaluates("stiffening", STIFFER, lambda drivers: candidate("stiffening")(drivers) | {"from_load": 0.7}, within=0.02)
@evaluates("stiffening", STIFFER.replace("g(c)", "g(t)"), {"whole_s": 55.0, "from_load": 0.7}, strength=0.01)
def stiffer(m, c, n):
    share = m.t / n["whole_s"] if "whole_s" in n else work(m, 1.0)
    yields = 1.0 / 50.0  # mm/N, of no weight
    now = yields - sum(k / USUAL_N * growth(name[1], share) for k, name in each(c, r"(.*)_mm_per_10_n"))
    return (m.F - USUAL_N * n["from_load"]) * (yields - now)


HEAT = "dx = -a (T - T0), dT/dt = (power - T)/tau where T is not measured"


@evaluates("thermal", HEAT, candidate("thermal", measured=1.0, sign=1.0), within=5e-3)
@evaluates("thermal", HEAT, candidate("thermal", measured=1.0, sign=-1.0), within=5e-3)
@evaluates("thermal", HEAT, candidate("thermal", measured=0.0, sign=1.0), within=5e-3)
@evaluates("thermal", HEAT, candidate("thermal", measured=0.0, sign=-1.0), within=5e-3)
def heat(m, c, n):
    fastest = np.percentile(np.abs(m.v), 99)
    powers = {
        "friction": np.abs(m.v) * m.load, "speed": m.v**2, "current": m.current**2,
        "moving": 1.0 - np.exp(-np.abs(m.v) / (0.05 * fastest)), "torque": np.abs(m.v) * m.load * m.sin_a,
        "holding": (m.load * m.sin_a) ** 2,
    }  # fmt: skip
    warm = one(c, "at_once_mm_per_k") * (m.T - m.T[0])
    warm = warm + sum(a * behind(m.T - m.T[0], float(w[1])) for a, w in each(c, r"after_([0-9.]+)_s_mm_per_k"))
    for a, words in each(c, r"([a-z]+)_([0-9.]+)_s(_behind|)_mm"):
        power = powers[words[1]] / np.mean(powers[words[1]])
        warmer = behind(power, float(words[2]))
        warm = warm + a * (behind(warmer, 30.0) if words[3] else warmer)
    return -n["sign"] * warm
