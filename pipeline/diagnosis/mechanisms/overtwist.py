"""Displacement runs ahead past a critical twist, with a loop of its own: the string coils [E5]."""

import numpy as np
from numba import njit

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.recursions import play
from pipeline.diagnosis.shapes import hinge
from pipeline.kinematics import Array

SPREAD = (-2.0, -1.0, 0.0, 1.0, 2.0)  # softnesses about the critical twist at which coils form


def shapes(drivers: Drivers) -> list[Shape]:
    """Critical twist in turns, how softly it begins, and the half-width of the coil's loop; none without a string."""
    if not drivers.levered:
        return []
    top = float(np.percentile(drivers.motion, 99.9))
    return [
        {
            "critical_turns": float(f"{share * top:.6g}"),
            "softness_turns": float(f"{soft * top:.6g}"),
            "loop_turns": float(f"{loop * top:.6g}"),
        }
        for share in np.linspace(0.5, 0.98, 13)
        for soft in (0.01, 0.05)
        for loop in (0.02, 0.06, 0.12)
    ]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Extra contraction beyond the critical twist: at once, by a play, and by coils that form there and melt late."""
    late = play(drivers.motion, np.full(len(drivers.motion), shape["loop_turns"])) + shape["loop_turns"]
    found = []
    for name, turns in (("at_once", drivers.motion), ("late", late)):
        beyond = hinge(turns, shape["critical_turns"], shape["softness_turns"])
        found.append(Term(f"{name}_mm_per_turn", "length", -beyond, "mm/turn"))
        found.append(Term(f"{name}_mm_per_turn2", "length", -(beyond**2), "mm/turn^2"))
    memory = 2.0 * shape["loop_turns"]
    coils = [
        coiled(drivers.motion, shape["critical_turns"] + apart * shape["softness_turns"], memory) for apart in SPREAD
    ]
    return [*found, Term("coiled_mm_per_turn", "length", -np.mean(coils, axis=0), "mm/turn")]


@njit(cache=True)
def coiled(turns: Array, critical: float, memory: float) -> Array:
    """Twist beyond a coil's melting point while there is a coil: from the critical twist until `memory` below it."""
    out = np.zeros_like(turns)
    there = False
    for i in range(turns.size):
        there = turns[i] > critical or (there and turns[i] > critical - memory)
        if there:
            out[i] = turns[i] - (critical - memory)
    return out


MECHANISM = Mechanism(
    id="overtwist",
    driver="high twist",
    equation="dx = +k max(theta' - theta_c, 0), theta' the twist or its play",
    source="physics.md E5",
    confused_with="a wrong radius, jam (opposite sign)",
    told_apart_by="strokes that end above and below the critical twist",
    sentence="Past a critical {motion} the string coils and the {reading} runs ahead, by up to {span} ({size}).",
    details=("it begins at {critical_turns}",),
    shapes=shapes,
    terms=terms,
)
