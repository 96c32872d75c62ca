"""Equations of the twist that a string sees, and of its radius, by functions of numpy."""

import numpy as np
from equation_cases import each, evaluates, one
from equation_motion import RADIUS_MM, STROKES_S, TURN, USUAL_N, growth, play, stop

PLAY = "theta_s = theta + sum a_i (play(theta, b_i w) - theta); half the play: w sum a_i b_i"


@evaluates("backlash", PLAY, {"half_width_turns": 0.4})
def backlash(m, c, n):
    w = TURN * n["half_width_turns"]
    return sum(one(c, a) * (play(m.theta, b * w) - m.theta) for a, b in (("share", 1.0), ("inner_share", 0.5)))


@evaluates("count_slip", "theta_s = theta - sum k_i [t >= t_i]", {"at_s": 20.0, "within_s": 0.0}, jumps=True)
def lost_twist(m, c, n):
    return -TURN * one(c, "turns") * (m.t >= n["at_s"])


@evaluates("count_slip", "theta_s = theta - sum k_i [t >= t_i]", {"at_s": -1.0, "within_s": 0.0}, jumps=True)
def lost_at_each_stroke(m, c, n):
    return -TURN * one(c, "turns_per_stroke") * sum(m.t >= t_i for t_i in STROKES_S[1:])


RIPPLE = "x_m = x + sum A_n sin(n theta + p_n), or theta_s = theta + A_n sin(n theta + p_n)"


@evaluates("eccentricity", RIPPLE, {"wheel_mm": 0.0})
@evaluates("eccentricity", RIPPLE, {"wheel_mm": 2.5})
@evaluates("eccentricity", RIPPLE, {"pitch_turns": 0.7}, "drive")
def ripple(m, c, n):
    return _ripple(m, c, n, "mm")


@evaluates("eccentricity", RIPPLE, {"wheel_mm": 0.0}, left_side="theta_s")
def ripple_of_the_twist(m, c, n):
    return TURN * _ripple(m, c, n, "turns")


def _ripple(m, c, n, unit):
    """A sine of the angle begins at p = 0, a cosine a quarter of a turn before."""
    theta = m.turns / n["pitch_turns"] if "pitch_turns" in n else m.x / n["wheel_mm"] if n["wheel_mm"] else m.turns
    p = {"sine": 0.0, "cosine": np.pi / 2.0}
    waves = each(c, rf"(sine|cosine)_?([0-9]*)_{unit}")
    within = np.gradient(theta) if "wheel_mm" in n else 0.0  # a sample, of which the reading is a mean
    parts = [theta + part * within for part in np.linspace(-0.45, 0.45, 10)]
    return sum(
        size * np.mean([np.sin(float(w[2] or 1) * TURN * part + p[w[1]]) for part in parts], axis=0)
        for size, w in waves
    )


VARIANT = "theta_s = theta + sum a_i (play(theta, b_i w F/F_0) - theta)"


@evaluates("friction_hysteresis", VARIANT, {"play_turns": 0.2, "usual_load": 1.5})
def friction_of_the_twist(m, c, n):
    w, usual_n = TURN * n["play_turns"], USUAL_N * n["usual_load"]
    parts = (("share", 1.0), ("inner_share", 0.4))
    return sum(one(c, a) * (play(m.theta, b * w * m.F / usual_n) - m.theta) for a, b in parts)


@evaluates("jam", "theta_s = theta - s max(theta - theta_c, 0)", {"critical_turns": 9.0, "softness_turns": 1e-3})
def jam(m, c, n):
    beyond = np.maximum(m.theta - TURN * n["critical_turns"], 0.0)
    return -one(c, "share") * beyond - one(c, "faster_per_turn") / TURN * beyond**2


@evaluates("shaft_windup", "theta_s = theta - F r sin a / k_t", {"loop_turns": 0.3, "highest_torque": 2.0})
def windup(m, c, n):
    """Torque in 10 N, which the radius makes N mm."""
    torque, lost = m.load * m.sin_a, np.zeros_like(m.F)
    for straight, _ in each(c, "turns_per_10_n"):
        k_t = USUAL_N * RADIUS_MM / (TURN * straight)
        lost = m.F * RADIUS_MM * m.sin_a / k_t
    lost = lost + TURN * (one(c, "yielding_turns") * torque**2 + one(c, "stiffening_turns_per_10_n") * torque**0.5)
    lost = lost + TURN * one(c, "rubbing_turns_per_10_n") * torque * stop(m.turns, n["loop_turns"])
    for size, words in each(c, r"up_to_([0-9.]+)_turns_per_10_n"):
        lost = lost + TURN * size * np.minimum(torque, float(words[1]) * n["highest_torque"])
    return -lost


@evaluates("slack", "theta_s = max(theta - theta_0, 0)", {"take_up_turns": 3.0, "stop": 0.0, "softness": 1e-3})
def dead_twist(m, c, n):
    return one(c, "share") * (np.maximum(m.theta - TURN * n["take_up_turns"], 0.0) - m.theta)


@evaluates("slack", "x = max(x_0, x_geo - s)", {"take_up_mm": 2.0, "stop": 1.0, "softness": 1e-3})
def slack(m, c, n):
    x_geo, x_0 = m.x, m.x.min()  # where the motion begins and is least, as near to no twist as it comes
    return one(c, "share") * (np.maximum(x_0, x_geo - n["take_up_mm"]) - x_geo)


@evaluates("slack", "x = x_geo - sum k_i min(s_i, x_geo - x_0)", {"sag_mm": 2.0}, within=0.05)
def sag(m, c, n):
    """Each part ends softly, within a twentieth of it."""
    x_geo, x_0, parts = m.x, m.x.min(), each(c, r"share_to_([0-9.]+)")
    return -sum(k_i * np.minimum(float(w[1]) * n["sag_mm"], x_geo - x_0) for k_i, w in parts)


PRESSED = "r_e = r (1 - k(tan a, F) - s ln(F/F_ref))"


@evaluates("radius_compaction", PRESSED, {"loaded": 1.0, "steepest": 0.28, "highest_pressure": 0.15})
def compaction(m, c, n):
    steep, pressed = m.tan_a / n["steepest"], m.load * m.tan_a**2 / n["highest_pressure"]
    k = sum(size * m.load * m.tan_a ** float(w[1]) for size, w in each(c, "load_tangent_([0-9])"))
    k = k + sum(size * m.tan_a ** float(w[1]) for size, w in each(c, "tangent_([0-9])"))
    laws = {
        "within": lambda w: 1.0 - np.exp(-steep / w),
        "settled": lambda w: 1.0 - np.exp(-((steep / w) ** 2)),
        "stage_at": lambda w: 1.0 / (1.0 + np.exp((w - steep) / 0.09)),
        "closing_at": lambda w: 1.0 - np.exp(-pressed / w),
        "ordering_at": lambda w: 1.0 - np.exp(-((pressed / w) ** 2)),
    }
    k = k + sum(size * laws[w[1]](float(w[2])) for size, w in each(c, f"({'|'.join(laws)})_([0-9.]+)"))
    return -RADIUS_MM * (k + one(c, "log_load") * np.log(m.F / USUAL_N))


@evaluates("wear", "r_e = r (1 -+ k g(travel))", {"sign": -1.0, "travel_turns": 60.0, "load_power": 0.0}, within=0.02)
@evaluates("wear", "r_e = r (1 -+ k g(travel))", {"sign": 1.0, "travel_turns": 100.0, "load_power": 1.0}, within=0.02)
def wear(m, c, n):
    travel = np.cumsum(m.load ** n["load_power"] * np.abs(np.diff(m.turns, prepend=m.turns[0])))
    return sum(RADIUS_MM * n["sign"] * k * growth(name, travel / n["travel_turns"]) for name, k in c.items())


@evaluates("x_swelling", "r_e = r (1 +- k g(t))", {"sign": -1.0, "whole_s": 55.0})
@evaluates("x_swelling", "r_e = r (1 +- k g(t))", {"sign": 1.0, "whole_s": 55.0})
def swelling(m, c, n):
    return sum(RADIUS_MM * n["sign"] * k * growth(name, m.t / n["whole_s"]) for name, k in c.items())
