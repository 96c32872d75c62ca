"""Twist lost suddenly between encoder and string: missed steps, a slipping screw or knot."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import at_once, happens_within, jump_mark, slipped, slips, slips_seen

LEAST_WOUND = 0.1  # of the whole travel: a string that moved less was not wound yet


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """When it slips, in s since the start; −1: a little at every stroke.

    None where a constant gear makes twist and reading one: there a sudden step is `clamp_slip`.
    """
    return [*_wound(drivers, slips(drivers)), {"at_s": -1.0, "within_s": 0.0}] if drivers.levered else []


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Times at which a residual jumps. It has the shape (samples,), in the reading's unit."""
    return _wound(drivers, slips_seen(drivers, residual)) if drivers.levered else []


def wound_before(drivers: Drivers, nonlinear: Nonlinear) -> bool:
    """Whether a slip lies within a run and after the string was wound: what slips before is a zero of the motor.

    A slip at every stroke does.
    """
    before = drivers.motion[drivers.elapsed_s < nonlinear["at_s"]]
    wound = nonlinear["at_s"] < 0 or (len(before) > 0 and float(np.ptp(before)) >= LEAST_WOUND * drivers.span)
    return wound and happens_within(drivers, nonlinear)


def _wound(drivers: Drivers, slipping: list[Nonlinear]) -> list[Nonlinear]:
    return [nonlinear for nonlinear in slipping if wound_before(drivers, nonlinear)]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """A step of the string's twist against the encoder's, at once or within a second."""
    if nonlinear["at_s"] < 0:
        return [
            Term("turns_per_stroke", "twist", -(drivers.stroke - drivers.stroke[0]).astype(float), "turns", -np.inf)
        ]
    return [Term("turns", "twist", -slipped(drivers, nonlinear), "turns", -np.inf)]


MECHANISM = Mechanism(
    id="count_slip",
    driver="sudden events on the twist",
    equation="theta_s = theta - sum k_i [t >= t_i]",
    letters={
        "k_i": "how much twist is lost",
        "t_i": "at_s",
    },
    strengths=("k_i",),
    source=(
        "Acarnley, Stepping Motors: A Guide to Theory and Practice, 2002 (lost steps); "
        "a step at an unknown time: Basseville and Nikiforov, Detection of Abrupt Changes, 1993"
    ),
    confused_with="clamp_slip (which is the same at every twist), wear",
    told_apart_by="an index mark on the string's end; unwinding to slack",
    meaning="twist is lost suddenly between encoder and string.",
    sentence="Motion was lost suddenly between encoder and {string}, worth {size}.",
    details=("{turns_per_stroke} at every stroke", "{turns} after {at_s}"),
    candidates=candidates,
    terms=terms,
    suggest=suggest,
    at_once=at_once,
    tells=wound_before,
    mark=jump_mark,
    steps=5,
)
