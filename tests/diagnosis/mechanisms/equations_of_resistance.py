"""Equations of what is lost where motion is resisted, or of the force that it takes, by functions of numpy."""

import numpy as np
from equation_cases import candidate, each, evaluates, one
from equation_motion import STEP_S, behind, stop

FRICTION = "dx = -sum k_i f_i g_i s_i, s_i: stop operators of the twist (Prandtl-Ishlinskii), or its direction"


@evaluates("friction_hysteresis", FRICTION, candidate("friction_hysteresis", loaded=1.0))
def friction(m, c, n):
    dx = np.zeros_like(m.F)
    factor = {
        "mm": 1.0,
        "load_mm_per_10_n": m.load,
        "load_twist_mm_per_10_n": m.load * m.tan_a,
        "load_steep_mm_per_10_n": m.load * m.tan_a**3,
        "root_load_twist_mm": np.sqrt(m.load) * m.tan_a,
        "twist_mm_per_10_n": m.load * m.tan_a,
    }
    for k, words in each(c, r"stop_([0-9.]+)_(.*)"):
        dx -= k * factor[words[2]] * stop(m.turns, float(words[1]) * n["span_turns"])
    for k, words in each(c, r"dry_([0-9.]+)_(.*)"):
        dx -= k * factor[words[2]] * np.tanh(m.v / (float(words[1]) * n["fastest_turns_per_s"]))
    return dx


LOOP = "h s; h: half the loop, s: the direction of motion, from -1 to 1, rounded where it turns"
PLACES = {"loaded": 1.0, "from_turns": -6.0, "span_turns": 14.0}


@evaluates("friction_hysteresis", LOOP, {"half_turns": 0.1, "wide_half_turns": 0.7, **PLACES}, "drive", "F")
@evaluates("friction_hysteresis", LOOP, {"slow_turns_per_s": 0.2, **PLACES}, "drive", "F")
def plain_loop(m, c, n):
    place = ((m.turns - n["from_turns"]) / n["span_turns"]).clip(0.0, 1.0)
    h = {
        "mm": 1.0, "load_mm_per_10_n": m.load, "slack_mm": np.exp(-m.load / 0.5), "near_mm": (1.0 - place) ** 2,
        "middle_mm": 2.0 * place * (1.0 - place), "far_mm": place**2,
    }  # fmt: skip
    s = {"dry": lambda: np.tanh(m.v / n["slow_turns_per_s"]), "sharp": lambda: stop(m.turns, n["half_turns"]),
         "round": lambda: stop(m.turns, n["wide_half_turns"])}  # fmt: skip
    return sum(k * h[words[2]] * s[words[1]]() for k, words in each(c, r"(dry|sharp|round)_(.*)"))


def viscous(m, c, n, of_rate):
    """The loss of each strength: a power of the rate, some at once, some through one or two elements that relax."""
    grows = 1.0 + 2.0 * m.tan_a / m.tan_a.max()
    way, v = np.sign(m.v), np.abs(m.v)
    powers = {
        "straight": m.v, "low": way * v**0.3, "root": way * v**0.5, "square": way * v**2, "growing": m.v * grows,
        "growing_root": way * v**0.5 * grows,
    }  # fmt: skip
    lost = one(c, "straight_mm_per_turn_s") * of_rate + one(c, "loaded_mm_per_turn_s_10_n") * of_rate * m.load
    for size, words in each(c, r"(.*?)(_relaxing_)?(twice_)?(?(2)([0-9.]+)_s)_mm"):
        power = powers[words[1]]
        for _ in range(0 if not words[2] else 2 if words[3] else 1):
            power = behind(power, float(words[4]))
        lost = lost + size * power
    return lost


@evaluates("viscous_loss", "dx = -c dtheta/dt", candidate("viscous_loss"), within=0.02)
def viscous_on_a_string(m, c, n):
    return -viscous(m, c, n, np.gradient(m.turns, STEP_S))


@evaluates("viscous_loss", "c v; v: the speed", candidate("viscous_loss"), "drive", "F", rates=False, within=0.03)
def viscous_on_a_drive(m, c, n):
    return viscous(m, c, n, m.v)


@evaluates("x_cubic_spring", "F = k x + k3 x^3", {}, "drive")
def cubic(m, c, n):
    return one(c, "cubic_mm_per_turn3") * m.turns**3


@evaluates("x_stribeck", "F = (F_s - F_c) exp(-(v/v_s)^2) sign(v)", {"falls_turns_per_s": 0.5}, "drive")
def stribeck(m, c, n):
    """The sign turns within a fifth of v_s."""
    share = m.v / n["falls_turns_per_s"]
    return one(c, "more_mm") * np.exp(-(share**2)) * np.tanh(share / 0.2)
