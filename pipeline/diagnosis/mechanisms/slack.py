"""The first twist moves nothing: slack is taken up before the string pulls."""

import numpy as np

from ..drivers import Drivers
from ..interface import Mechanism, Nonlinear, Term
from ..shared_laws import hinge

SHARES = (0.015, 0.03, 0.05, 0.075, 0.1, 0.14, 0.18, 0.24, 0.3, 0.38, 0.46)


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Twist that is taken up, in turns: lost (a toe), or as a length that a stop holds; none without a string."""
    if not drivers.levered:
        return []
    listed: list[Nonlinear] = []
    for share in SHARES:
        turns = float(f"{share * float(np.percentile(drivers.motion, 99.9)):.6g}")
        listed += [{"take_up_turns": turns, "stop": 0.0, "softness": soft} for soft in (0.05, 0.3)]
        order = np.argsort(drivers.motion, kind="stable")
        height = np.interp([0.0, turns], drivers.motion[order], drivers.contraction[order])
        if height[1] > height[0]:
            listed.append({"take_up_mm": float(f"{height[1] - height[0]:.6g}"), "stop": 1.0, "softness": 0.05})
    return listed


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Twist that does not reach the string, or contraction that the slack swallows."""
    if nonlinear["stop"]:
        height = drivers.contraction - float(np.interp(0.0, *_sorted(drivers)))
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
    equation="theta_s = max(theta - theta_0, 0), or x = max(x_0, x_geo - s)",
    source="a dead zone: textbook; catenary: Irvine, Cable Structures, 1981",
    confused_with="a wrong separator, backlash",
    told_apart_by="small strokes at low twist",
    meaning="the first turns move nothing.",
    sentence="The first {motion} moves nothing: slack swallows up to {span} ({size}).",
    details=("it is taken up after {take_up_turns}", "it is taken up after {take_up_mm} of {reading}"),
    candidates=candidates,
    terms=terms,
)
