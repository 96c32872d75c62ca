"""State equations of docs/concealment.md: what friction, drive, load and sensor do, as functions."""

import math

import numpy as np
from effect_motion import STEP_S, TURN, behind, rise, states, torque


@states(
    "friction_hysteresis", "dg/dθ = −g (g/w)^tail / reach, w = c F", turns_per_n=0.01, reach_turns=0.2, tail=0.5,
)  # fmt: skip
def friction(at, p, out):
    """g is what the held twist lacks to its limit, which is on the side of the motion."""
    held_rad, twist = 0.0, np.empty_like(out)
    for i, turned in enumerate(at.turned_rad):
        w = TURN * p["turns_per_n"] * at.load_n[i]
        for _ in range(8):
            g = math.copysign(w, turned) - held_rad
            held_rad += g * abs(g / w) ** p["tail"] / (TURN * p["reach_turns"]) * abs(turned) / 8
        twist[i] = held_rad
    return twist


@states("backlash", "dogs meet softly, dg = dθ (1 − (g/w)^n)", turns=0.6, firmness=3.0)
def backlash(at, p, out):
    """A gap that leans the other way does not slow the crossing."""
    w, g, gaps = 0.5 * TURN * p["turns"], 0.0, np.empty_like(out)
    for i, turned in enumerate(at.turned_rad):
        for _ in range(8):
            g += turned / 8 * (1.0 - (abs(g) / w if g * turned > 0.0 else 0.0) ** p["firmness"])
        gaps[i] = g
    return gaps


@states("viscous_loss", "τ dσ/dt = ω^n − σ", mm_per_rate=0.05, thinning=0.7, settle_s=0.2)
def viscous(at, p, out):
    turns_per_s = at.turned_rad / TURN / STEP_S
    return p["mm_per_rate"] * behind(np.sign(turns_per_s) * np.abs(turns_per_s) ** p["thinning"], p["settle_s"])


STICKS = "grip ages t/(t + a), film 1/(1 + (v/v0)⁶), slider rebounds"


@states("stick_slip", STICKS, step_mm=0.15, float_mm_per_s=3.0, age_s=0.3, fresh=0.9, rebound=0.9)
def stick_slip(at, p, out):
    """The speed is one over 20 ms; the slider jumps when the spring is stretched by step x grip x film."""
    end_mm, stood_s = at.contraction_mm, 0.0
    slider, behind_mm = end_mm[0], np.empty_like(out)
    v = behind(np.abs(np.diff(end_mm, prepend=end_mm[0])) / STEP_S, 0.02)
    film = 1.0 / (1.0 + (v / p["float_mm_per_s"]) ** 6)
    for i in range(len(out)):
        stood_s += STEP_S
        grip = p["fresh"] + (1.0 - p["fresh"]) * stood_s / (stood_s + p["age_s"])
        gap = end_mm[i] - slider
        if abs(gap) > p["step_mm"] * grip * film[i]:
            slider, stood_s = end_mm[i] + p["rebound"] * gap, 0.0
        behind_mm[i] = end_mm[i] - slider
    return behind_mm


@states(
    "shaft_windup", "φ = c τ (1 + τ/τ0)^−h with τ at θ − φ",
    compliance_rad_per_n_mm=0.3, hardens_n_mm=2.0, hardening=0.4,
)  # fmt: skip
def windup(at, p, out):
    tau = torque(at, at.twist_rad - out)
    return out, p["compliance_rad_per_n_mm"] * tau * (1.0 + tau / p["hardens_n_mm"]) ** -p["hardening"]


SLIPS = "damage dD/dt = τ² or F²; slips when D passes a life"


@states("count_slip", SLIPS, turns=[0.5, 0.3], lives_s=[1.0, 3.0], torque_n_mm=4.0, slip_turns_per_s=1e6)
def count_slip(at, p, out):
    damage = np.cumsum((torque(at, at.twist_rad) / p["torque_n_mm"]) ** 2) * STEP_S
    return sum(TURN * turns * (damage >= life) for turns, life in zip(p["turns"], p["lives_s"], strict=True))


@states("clamp_slip", SLIPS, slips_mm=[0.3, 0.2], lives_s=[4.0, 30.0], load_n=20.0, glide_s=1e-9)
def clamp_slip(at, p, out):
    damage = np.cumsum((at.load_n / p["load_n"]) ** 2) * STEP_S
    return sum(slip * (damage >= life) for slip, life in zip(p["slips_mm"], p["lives_s"], strict=True))


@states(
    "slack", "load shared by a rubber bed F(1 − y/b)^h and a taut string",
    take_up_mm=0.5, bed_mm=0.3, hardness=1.5, stretch_n_per_mm=60.0,
)  # fmt: skip
def slack(at, p, out):
    """The string bears as much less than the load as what it asks for falls short of the rise."""
    y, demand_mm = rise(at) - out, rise(at) - p["take_up_mm"]
    bed = at.load_n * np.maximum(1.0 - y / p["bed_mm"], 0.0) ** p["hardness"]
    string = np.maximum(at.load_n - p["stretch_n_per_mm"] * (y - demand_mm), 0.0)
    return at.load_n, bed + string


@states(
    "jam", "pressed twist q with q + √q = z past the critical twist", critical_turns=12.0, share=0.6, spread_turns=3.0
)
def jam(at, p, out):
    spread = TURN * p["spread_turns"]
    q, z = out / p["share"] / spread, np.maximum(at.twist_rad - TURN * p["critical_turns"], 0.0) / spread
    return z, q + np.sqrt(q)


@states(
    "overtwist", "forty coils, relays that nucleate and melt at twists of their own",
    critical_turns=12.0, gain_mm_per_turn=0.5, spread_turns=0.6, memory_turns=2.0,
)  # fmt: skip
def overtwist(at, p, out):
    turns, taken = at.twist_rad / TURN, np.zeros_like(out)
    for rank in (np.arange(40) + 0.5) / 40.0:
        born = p["critical_turns"] + p["spread_turns"] * math.log(rank / (1.0 - rank))
        melts, is_there = born - p["memory_turns"] * (0.5 + rank), False
        for i, twist in enumerate(turns):
            is_there = twist >= born or (is_there and twist > melts)
            taken[i] += is_there * (twist - melts) / 40.0
    return -p["gain_mm_per_turn"] * taken


@states("sensor_lag", "dead time and two poles", lag_s=0.4)
def lag(at, p, out):
    """Half of it is dead time; the slower pole has three fifths of the rest."""
    late = round(0.5 * p["lag_s"] / STEP_S)
    read = np.concatenate([np.full(late, at.reading_mm[0]), at.reading_mm[:-late]])
    for share in (0.3, 0.2):
        read = behind(read, share * p["lag_s"], read[0])
    return read - at.reading_mm


@states("sensor_drift", "dz/dt = c / (1 + t/t0)^a", mm_per_hour=40.0, settle_s=15.0, ageing=0.6)
def drift(at, p, out):
    t, a = STEP_S * (1.0 + np.arange(len(out))), p["ageing"]
    return p["mm_per_hour"] / 3600.0 * p["settle_s"] / (1.0 - a) * ((1.0 + t / p["settle_s"]) ** (1.0 - a) - 1.0)


@states(
    "eccentricity", "distance in space to a hook on a bent joint, φ = θ + j sin 2θ",
    run_out_mm=0.2, phase_rad=0.7, joint=0.15,
)  # fmt: skip
def eccentricity(at, p, out):
    """From a guide that stands aside by as much as the zone is long, less the distance of the hook's axis."""
    phi = at.twist_rad + p["joint"] * np.sin(2.0 * at.twist_rad) + p["phase_rad"]
    hook = np.array([p["run_out_mm"] * np.cos(phi), p["run_out_mm"] * np.sin(phi), np.zeros_like(phi)])
    guide = np.array([[150.0], [0.0], [150.0]])
    return np.linalg.norm(hook - guide, axis=0) - np.linalg.norm(guide)


@states("end_stop", "Hertz contact p + k p^1.5 = x − x_stop", at_mm=4.0, bumper=40.0, stretch_n_per_mm=15.0)
def end_stop(at, p, out):
    past = np.maximum(rise(at) - p["at_mm"], 0.0)
    into = past - out
    return past, into + p["bumper"] / p["stretch_n_per_mm"] * np.maximum(into, 0.0) ** 1.5


@states(
    "load_swing", "z'' + 2ζω z' + d z'·abs(z') + ω² z = −s x''",
    share=0.4, frequency_hz=0.8, damping=0.03, drag_per_mm=0.2,
)  # fmt: skip
def swing(at, p, out):
    """What the load moves less is minus z."""
    w, z, speed, moved = TURN * p["frequency_hz"], 0.0, 0.0, np.empty_like(out)
    pushed = np.gradient(np.gradient(at.contraction_mm, STEP_S), STEP_S)
    for i, a in enumerate(pushed):
        losses = 2.0 * p["damping"] * w * speed + p["drag_per_mm"] * speed * abs(speed)
        speed += STEP_S * (-p["share"] * a - losses - w**2 * z)
        z += STEP_S * speed
        moved[i] = -z
    return moved
