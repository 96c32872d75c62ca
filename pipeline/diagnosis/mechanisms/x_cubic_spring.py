"""A spring that is not linear: its force grows or falls with the cube of the way from its rest."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

BOTH_SIDES = 0.2  # of the range of motion, that must lie on either side of the spring's rest


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """One, where a force is read and the motion goes to both sides of its zero, which is the spring's rest."""
    if drivers.levered or drivers.velocity is None:
        return []
    least = BOTH_SIDES * drivers.span
    return [{}] if drivers.motion.min() < -least and drivers.motion.max() > least else []


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Force with the cube of the motion, of either sign: a spring that gets stiffer or softer."""
    return [Term("cubic_mm_per_turn3", "resistance", drivers.motion**3, "mm/turn3", -np.inf)]


MECHANISM = Mechanism(
    id="x_cubic_spring",
    driver="motion cubed",
    equation="F = k x + k3 x^3",
    letters={
        "F": "the force",
        "k": "the stiffness",
        "k3": "how it grows with the square of x",
    },
    source=(
        "Duffing, Erzwungene Schwingungen bei veränderlicher Eigenfrequenz, 1918; on a circuit: Wigren and Schoukens, "
        "Three free data sets for development and benchmarking in nonlinear system identification, ECC 2013"
    ),
    confused_with="a wrong stiffness",
    told_apart_by="a small and a large swing",
    meaning="the force of a spring grows with the cube of how far it is moved; on rigs without a string.",
    sentence="The spring is no straight line: the cube of the {motion} adds up to {span} ({size}).",
    details=("{cubic_mm_per_turn3}",),
    candidates=candidates,
    terms=terms,
)
