"""Displacement falls behind past a critical twist: the coils touch."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import hinge

ONSETS = np.linspace(0.5, 0.98, 17)  # of the highest twist
LATE_ONSETS = (0.965, 0.985, 0.992)  # the same, where only the last turn jams: strands that touch do so within it
SOFTNESSES, LATE_SOFTNESSES = (0.01, 0.04, 0.1), (0.002, 0.01)  # of the highest twist


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Critical twist in turns, and how softly it begins (of the range); none without a string to wind."""
    if not drivers.levered:
        return []
    top = float(np.percentile(drivers.motion, 99.9))
    return [
        {"critical_turns": float(f"{share * top:.6g}"), "softness_turns": float(f"{soft * top:.6g}")}
        for shares, softnesses in ((ONSETS, SOFTNESSES), (LATE_ONSETS, LATE_SOFTNESSES))
        for share in shares
        for soft in softnesses
    ]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Twist that contracts nothing any more, in proportion beyond the critical twist and faster."""
    beyond = hinge(drivers.motion, nonlinear["critical_turns"], nonlinear["softness_turns"])
    return [
        Term("share", "twist", -beyond, "1", high=1.2),
        Term("faster_per_turn", "twist", -(beyond**2), "1/turn", high=0.5),
    ]


MECHANISM = Mechanism(
    id="jam",
    driver="high twist",
    columns=("high twist, less",),
    equation="theta_s = theta - s max(theta - theta_c, 0)",
    letters={
        "s": "how much of the twist beyond the corner is lost",
    },
    strengths=("s",),
    source=(
        "Bohr and Olsen, The ancient art of laying rope, EPL 93, 2011 (strands touch at a greatest twist); "
        "how far the displacement falls behind beyond it is no law in print, here a line and a square"
    ),
    confused_with="end_stop (which is flat), radius_compaction (which has no corner)",
    told_apart_by="strokes that end above and below the corner; the torque, which rises in a jam",
    meaning="past a critical twist the displacement falls behind.",
    sentence="Past a critical {motion} the coils touch and the {reading} falls behind, by up to {span} ({size}).",
    details=("it begins at {critical_turns}",),
    names={"faster": "the square of the twist beyond the corner"},
    twisted=True,
    candidates=candidates,
    terms=terms,
)
