"""Play of constant width on the twist, whatever the load."""

import numpy as np

from ..numerics.recursions import play
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import grid

INSIDE = {"share": 1.0, "inner_share": 0.5}  # of the half-width: yielding contacts close a part of it earlier


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Half-widths of the play, in turns."""
    return grid("half_width_turns", 5e-4 * drivers.span, 0.15 * drivers.span, 26)


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """The string's twist follows the motor's with a dead band."""
    all_terms = []
    for name, share in INSIDE.items() if drivers.levered else [("share", 1.0)]:
        followed = play(drivers.motion, np.full(len(drivers.motion), share * nonlinear["half_width_turns"]))
        all_terms.append(Term(name, "twist", followed - drivers.motion, "1", high=1.25))
    return all_terms


def half_play(values: Nonlinear) -> float:
    """Half of the play that is lost at a reversal in turns: each part's share of the width, by its coefficient."""
    return values["half_width_turns"] * sum(share * values.get(name, 0.0) for name, share in INSIDE.items())


MECHANISM = Mechanism(
    id="backlash",
    driver="direction",
    columns=("direction", "direction x twist"),
    equation="theta_s = theta + sum a_i (play(theta, b_i w) - theta); half the play: w sum a_i b_i",
    letters={
        "a_i": "how much of each play counts: share and inner_share",
        "b_i": "how wide each play is, as a share of w | 1 and 0.5",
        "play": "the twist that follows once the play is taken up",
        "w": "half_width_turns",
    },
    strengths=("a_i",),
    meanings={
        "half_width_turns": (
            "the widest part of the play; half the play, which can be measured at the rig, is a share of it"
        ),
    },
    source="Nordin and Gutman, Controlling mechanical systems with backlash: a survey, Automatica 38, 2002",
    confused_with="friction_hysteresis, sensor_lag, viscous_loss",
    told_apart_by="a second load: the play keeps its width",
    meaning="play of constant width on the motor's side, whatever the load.",
    sentence=(
        "After each reversal the motor moves a little before the {string} follows, so that {up} and {down} differ "
        "by {loop} ({size})."
    ),
    details=("half the play is {half_play_turns}",),
    derived={"half_play_turns": half_play},
    names={"share": "the play of the whole width (b = 1)", "inner_share": "the play of half the width (b = 1/2)"},
    candidates=candidates,
    remembers_turns=True,
    terms=terms,
)
