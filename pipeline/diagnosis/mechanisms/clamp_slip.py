"""A sudden permanent offset: the string slips in its clamp or a knot gives."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import at_once, happens_within, jump_mark, slipped, slips, slips_seen


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """When it slips, in s since the start, and how fast."""
    return slips(drivers)


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Times at which a residual jumps. It has the shape (samples,), in the reading's unit."""
    return slips_seen(drivers, residual)


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """A step of the length, at once or within a second."""
    return [Term("mm", "length", slipped(drivers, nonlinear), "mm", -np.inf)]


MECHANISM = Mechanism(
    id="clamp_slip",
    driver="sudden events on the length",
    equation="dx = -sum s_i [t >= t_i]",
    letters={
        "s_i": "how far it slips",
        "t_i": "at_s",
    },
    strengths=("s_i",),
    source=(
        "McKenna, Hearle and O'Hear, Handbook of Fibre Rope Technology, 2004 (terminations that slip); "
        "a step at an unknown time: Basseville and Nikiforov, Detection of Abrupt Changes, 1993"
    ),
    confused_with="count_slip (which grows with twist), plastic_elongation",
    told_apart_by="a mark on the string at the clamp: it moves when the clamp slips",
    meaning="the clamp gives way suddenly and for good.",
    sentence="The {string} slipped in its clamp and stayed so, worth {size}.",
    details=("by {mm} after {at_s}",),
    candidates=candidates,
    terms=terms,
    suggest=suggest,
    at_once=at_once,
    tells=happens_within,
    mark=jump_mark,
    steps=4,
)
