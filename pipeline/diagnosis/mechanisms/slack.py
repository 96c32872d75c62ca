"""The first twist moves nothing: slack is taken up before the string pulls."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import hinge

SHARP = 0.05  # of the take-up: softness of a take-up that ends at once
# of the highest twist: what may be taken up
SHARES = (0.015, 0.03, 0.05, 0.075, 0.1, 0.14, 0.18, 0.24, 0.3, 0.38, 0.46)
FINER = 4  # times as many take-ups that end at once: on a coarse grid each would look like a sag
SAGGING = (0.3, 0.6, 1.0, 1.6)  # of the sag: where parts of the length of a sagging string are taken up


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Twist to take up, in turns: lost (a toe), as a length that a stop holds, or as the sag of the string.

    None without a string.
    """
    if not drivers.levered:
        return []
    top, curve = float(np.percentile(drivers.motion, 99.9)), _sorted(drivers)
    listed: list[Nonlinear] = []
    for share in SHARES:
        turns = float(f"{share * top:.6g}")
        listed += [{"take_up_turns": turns, "stop": 0.0, "softness": soft} for soft in (SHARP, 0.3)]
    between = np.arange(FINER * (len(SHARES) - 1) + 1) / FINER
    for number, turns in enumerate(top * np.interp(between, np.arange(len(SHARES)), SHARES)):
        height = float(np.interp(turns, *curve) - np.interp(0.0, *curve))
        if height > 0.0:
            slack = float(f"{height:.6g}")
            listed.append({"take_up_mm": slack, "stop": 1.0, "softness": SHARP})
            listed += [{"sag_mm": slack}] if number % FINER == 0 else []
    return listed


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Twist that does not reach the string, or contraction that the slack swallows: all of it first, or bit by bit."""
    height = drivers.contraction - float(np.interp(0.0, *_sorted(drivers)))
    if "sag_mm" in nonlinear:
        ends = {part: part * nonlinear["sag_mm"] for part in SAGGING}
        return [
            Term(f"share_to_{part:g}", "length", height - hinge(height, end, SHARP * end), "1", high=1.3)
            for part, end in ends.items()
        ]
    if nonlinear["stop"]:
        slack = nonlinear["take_up_mm"]
        return [Term("share", "length", height - hinge(height, slack, nonlinear["softness"] * slack), "1", high=1.3)]
    onset = nonlinear["take_up_turns"]
    followed = hinge(drivers.motion, onset, nonlinear["softness"] * onset)
    return [Term("share", "twist", followed - drivers.motion, "1", high=1.3)]


def _sorted(drivers: Drivers) -> tuple[np.ndarray, np.ndarray]:
    order = np.argsort(drivers.motion, kind="stable")
    return drivers.motion[order], drivers.contraction[order]


MECHANISM = Mechanism(
    id="slack",
    driver="low twist",
    columns=("low twist",),
    equation="theta_s = max(theta - theta_0, 0)",
    variants={
        "take_up_mm": "x = max(x_0, x_geo - s)",
        "sag_mm": "x = x_geo - sum k_i min(s_i, x_geo - x_0)",
    },
    letters={
        "k_i": "how much of each part of the sag there is",
        "s": "take_up_mm",
        "s_i": "the parts of the sag: the number in each name times sag_mm",
        "theta_0": "take_up_turns",
        "x_0": "the displacement without twist, which stays until the slack ends",
        "x_geo": "the displacement of a taut string",
    },
    strengths=("k_i",),
    meanings={
        "sag_mm": "the whole slack, as a length",
        "softness": "how softly it ends, as a share of the slack",
        "stop": "1 means: a stop holds the slack, as a length, and 0: it is {motion} that does nothing",
        "take_up_mm": "the slack, as a length",
        "take_up_turns": "the {motion} that the slack takes up",
    },
    source="Khalil, Nonlinear Systems, 2002 (dead zone); catenary: Irvine, Cable Structures, 1981",
    confused_with="a wrong separator, backlash",
    told_apart_by="small strokes at low twist",
    meaning="the first turns move nothing.",
    sentence="The first {motion} moves nothing: slack swallows up to {span} ({size}).",
    details=(
        "it is taken up after {take_up_turns}",
        "it is taken up after {take_up_mm} of {reading}",
        "a sag is taken up bit by bit, over about {sag_mm} of {reading}",
    ),
    twisted=True,
    candidates=candidates,
    terms=terms,
)
