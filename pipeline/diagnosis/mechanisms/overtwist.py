"""Displacement runs ahead past a critical twist, with a loop of its own: the string coils."""

import numpy as np
from numba import njit

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass, play
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import hinge

LOOPS = (0.02, 0.06, 0.12)  # of the highest twist: half-widths of the loop of all coils together
COIL_LOOPS = (0.02, 0.04, 0.06, 0.09, 0.12)  # the same for the loop of a single coil
BORN = (0.15, 0.32, 0.5, 0.67, 0.85)  # of the way from the critical to the highest twist: where more coils are born
SUDDEN = 0.03  # of the same way: within which a coil is born
SLOWLY_S = 1.0  # in which coils come over a barrier
SPREAD = (-2.0, -1.0, 0.0, 1.0, 2.0)  # softnesses about the critical twist at which coils form


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Critical twist in turns, and how softly it begins; none without a string. `top_turns` is the highest twist."""
    if not drivers.levered:
        return []
    top = float(np.percentile(drivers.motion, 99.9))
    return [
        {
            "critical_turns": float(f"{share * top:.6g}"),
            "softness_turns": float(f"{soft * top:.6g}"),
            "top_turns": float(f"{top:.6g}"),
        }
        for share in np.linspace(0.5, 0.96, 11)
        for soft in (0.02,)
    ]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Extra contraction beyond the critical twist: at once, by a play, and by coils that form there and melt late."""
    critical, softness = nonlinear["critical_turns"], nonlinear["softness_turns"]
    all_terms = []
    for loop in (0.0, *LOOPS):
        width = loop * nonlinear["top_turns"]
        late = play(drivers.motion, np.full(len(drivers.motion), width)) + width
        beyond = hinge(late, critical, softness)
        all_terms.append(Term(f"loop_{loop:g}_mm_per_turn", "length", -beyond, "mm/turn"))
        all_terms.append(Term(f"loop_{loop:g}_mm_per_turn2", "length", -(beyond**2), "mm/turn^2"))
    for loop in COIL_LOOPS:
        memory = 2.0 * loop * nonlinear["top_turns"]
        coils = [coiled(drivers.motion, critical + apart * softness, memory) for apart in SPREAD]
        all_terms.append(Term(f"coiled_{loop:g}_mm_per_turn", "length", -np.mean(coils, axis=0), "mm/turn"))
        for born in BORN:
            at = critical + born * (nonlinear["top_turns"] - critical)
            width = SUDDEN * (nonlinear["top_turns"] - critical)
            born_share = np.mean([relay(drivers.motion, at + apart * width, memory) for apart in SPREAD], axis=0)
            all_terms.append(Term(f"born_{born:g}_loop_{loop:g}_mm", "length", -born_share))
    beyond = hinge(drivers.motion, critical, softness)
    all_terms.append(Term("slowly_mm_per_turn", "length", -lowpass(beyond, drivers.time_s, SLOWLY_S, 0.0), "mm/turn"))
    return all_terms


@njit(cache=True)
def relay(turns: Array, born: float, memory: float) -> Array:
    """1 while there is a coil: it forms at its twist, and melts `memory` below it.

    Shape (samples,); all in turns but the answer.
    """
    out = np.zeros_like(turns)
    is_born = False
    for i in range(turns.size):
        is_born = turns[i] > born or (is_born and turns[i] > born - memory)
        out[i] = 1.0 if is_born else 0.0
    return out


def coiled(turns: Array, critical: float, memory: float) -> Array:
    """Twist beyond a coil's melting point while there is a coil: from the critical twist until `memory` below it.

    Shape (samples,), all in turns.
    """
    return relay(turns, critical, memory) * (turns - (critical - memory))


MECHANISM = Mechanism(
    id="overtwist",
    driver="high twist",
    columns=("high twist, more",),
    equation="dx = +k max(theta' - theta_c, 0) + h n, theta' the twist or its play",
    letters={
        "h": "what a coil adds that is born past the critical twist",
        "k": "what each turn adds",
        "n": "whether there is such a coil: from the twist at which it is born until it melts | 0 or 1",
    },
    strengths=("k", "h"),
    rows={"k": "^loop|coiled|slowly", "h": "born"},
    meanings={
        "top_turns": "the highest {motion} of the recording, {scale}",
    },
    source=(
        "Haines et al., Artificial muscles from fishing line and sewing thread, Science 343, 2014 (coils beyond a "
        "critical twist)"
    ),
    confused_with="a wrong radius, jam (opposite sign)",
    told_apart_by="strokes that end above and below the critical twist",
    meaning="past a critical twist the displacement runs ahead, with a loop of its own.",
    sentence="Past a critical {motion} the string coils and the {reading} runs ahead, by up to {span} ({size}).",
    details=("it begins at {critical_turns}",),
    names={
        "loop_*": "what has a loop, as wide to each side as the number after loop says, in shares of top_turns",
        "mm_per_turn2": "the square of the twist beyond",
        "coiled_*": (
            "the twist beyond where a coil melts, while there is one: from the critical twist until twice the number "
            "in the name below it, in shares of top_turns"
        ),
        "born_*": "whether there is a coil that is born at that number of the way from theta_c to top_turns",
        "slowly": "what follows within a second",
    },
    twisted=True,
    candidates=candidates,
    remembers_turns=True,
    terms=terms,
)
