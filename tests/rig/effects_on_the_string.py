"""State equations of docs/concealment.md: effects on the length and the radius of the string, as functions."""

import math

import numpy as np
from effect_motion import GEOMETRY, STEP_S, states, torque


@states(
    "plastic_elongation", "populations that lose the share dW/W_i of what is left, dW = F sin α dx⁺",
    stretch_mm=[0.5, 0.2], work_n_mm=[60.0, 15.0],
)  # fmt: skip
def plastic(at, p, out):
    work = np.cumsum(at.load_n * at.helix_sine * np.maximum(at.advance_mm, 0.0))
    return sum(s * (1.0 - np.exp(-work / w)) for s, w in zip(p["stretch_mm"], p["work_n_mm"], strict=True))


@states(
    "creep", "branches dz/dt = (y/τ) sinh((c F sin α − z)/y)",
    compliance_mm_per_n=[0.01, 0.02], tau_s=[2.0, 9.0], yield_mm=0.05,
)  # fmt: skip
def creep(at, p, out):
    total, pull, y = np.zeros_like(at.load_n), at.load_n * at.helix_sine, p["yield_mm"]
    for c, tau in zip(p["compliance_mm_per_n"], p["tau_s"], strict=True):
        z = 0.0
        for i in range(len(pull)):
            z += STEP_S * y / tau * math.sinh((c * pull[i] - z) / y)
            total[i] += z
    return total


@states(
    "stiffening", "contacts lock, dm/dW = (1 − m)^p / W0; length F c / (1 + g m)",
    compliance_mm_per_n=0.05, gain=0.5, work_n_mm=300.0, order=2.6,
)  # fmt: skip
def stiffening(at, p, out):
    m, c, locked = 0.0, p["compliance_mm_per_n"], np.empty_like(at.load_n)
    for i, work in enumerate(at.load_n * np.abs(at.advance_mm)):
        m += (1.0 - m) ** p["order"] * work / p["work_n_mm"]
        locked[i] = m
    return at.load_n * c / (1.0 + p["gain"] * locked) - at.load_n * c


@states(
    "axial_elasticity", "fibres bear one after the other, F = δ²/(δ + toe)/c; a tenth of it after 4 to 8 s",
    compliance_mm_per_n=0.03, toe_n=4.0,
)  # fmt: skip
def stretch(at, p, out):
    toe_mm = p["compliance_mm_per_n"] * p["toe_n"]
    return at.load_n, out**2 / (out + toe_mm) / p["compliance_mm_per_n"]


@states(
    "thermal", "two bodies exchange heat with each other and the room; heated by torque or room",
    room_k=3.0, warm_s=(10.0, 25.0), string_s=20.0, rig_s=50.0,
)  # fmt: skip
def thermal(at, p, out):
    """The string is warmed by 2 K for each joule, and lengthens by 0.02 mm for each K; a fifth goes to the rig."""
    time_s, length = STEP_S * np.arange(len(out)), np.empty_like(out)
    room = 0.5 * (np.tanh((time_s - p["warm_s"][0]) / 12.0) - np.tanh((time_s - p["warm_s"][1]) / 12.0)) * p["room_k"]
    heat = 2.0 * 1e-3 * torque(at, at.twist_rad) * np.abs(at.turned_rad)
    string, rig = 0.0, 0.0
    for i in range(len(out)):
        flows = (string - rig) / p["string_s"]
        string += heat[i] - STEP_S * flows
        rig += STEP_S * (0.2 * flows + (room[i] - rig) / p["rig_s"])
        length[i] = 0.02 * string
    return length


@states(
    "radius_compaction", "bed of fibres bears p = B((φ/φ0)^n − 1) against F sin²α/r²", bed_mpa=8.0, exponent=6.0,
)  # fmt: skip
def compaction(at, p, out):
    """At constant volume of the fibres the radius falls with the root of φ."""
    r, dense = at.radius_mm * out, out**-2.0
    tangent = (GEOMETRY.separator_mm + at.twist_rad * r) / GEOMETRY.torsion_zone_mm
    pressed = at.load_n * tangent**2 / (1.0 + tangent**2) / r**2
    return pressed, p["bed_mpa"] * (dense ** p["exponent"] - 1.0)


@states(
    "wear", "dr/ds = −k (F/20)^0.3 (1 + e u), du/ds = −u²/s0, ds = r sin α dθ",
    share_per_m=0.4, edge=0.6, first_m=0.05,
)  # fmt: skip
def wear(at, p, out):
    r, u, radii = 1.0, 1.0, np.empty_like(out)
    ways = at.radius_mm * at.helix_sine * np.abs(np.diff(at.twist_rad, prepend=at.twist_rad[0])) / 1e3
    for i, ds in enumerate(ways):
        u -= u**2 / p["first_m"] * ds
        r -= p["share_per_m"] * (at.load_n[i] / 20.0) ** 0.3 * (1.0 + p["edge"] * u) * ds
        radii[i] = r
    return radii
