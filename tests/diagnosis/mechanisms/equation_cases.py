"""A case for each equation of the library: its exact string, and a function of a made motion that evaluates it.

Each function is written from the string and from what its letters and the words in its coefficients' names are said to
be, and asks no module of the library. A letter that stands for several strengths is one at a time 1.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from equation_motion import RADIUS_MM, TURN, Motion, drivers, motion

from pipeline.diagnosis.mechanisms.interface import Term
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.drivers import Drivers

Numbers = dict[str, float]
# what stands left in an equation: the ports that act on it, and what 1 at such a port is of it
LEFT = {
    "dx": {"length": -1.0, "resistance": -1.0},
    "theta_s": {"twist": TURN},
    "r_e": {"radius": RADIUS_MM},
    "x_m": {"sensor": 1.0},
    "x": {"length": -1.0},
    "F": {"resistance": 1.0},
}


@dataclass(frozen=True)
class Case:
    """An equation at some nonlinear parameters, on a rig; `evaluated` gives what it adds to its left side."""

    id: str
    equation: str
    evaluated: Callable[[Motion, Numbers, Numbers], np.ndarray]
    nonlinear: Callable[[Drivers], Numbers]
    rig: str
    left: str
    strength: float  # of the coefficient that is tried
    within: float  # of the largest value: how near the equation is to the code
    rates: bool  # whether the rate is given, and need not be found in the motion
    jumps: bool  # whether samples beside a jump are left out

    def drivers(self) -> Drivers:
        """The motion, as the mechanism has it."""
        return drivers(self.rig, self.rates)

    def terms(self) -> list[Term]:
        """Those terms of the mechanism that act on what stands left."""
        of_case = mechanisms()[self.id].terms(self.drivers(), self.nonlinear(self.drivers()))
        return [term for term in of_case if term.port in LEFT[self.left]]

    def coded(self, term: Term) -> np.ndarray:
        """What a term of that strength adds to the left side."""
        signal = term.signal(motion(self.rig).x) if callable(term.signal) else term.signal
        return LEFT[self.left][term.port] * self.strength * signal

    def by_equation(self, term: Term) -> np.ndarray:
        """The same, by the equation."""
        return self.evaluated(motion(self.rig), {term.name: self.strength}, self.nonlinear(self.drivers()))


CASES: list[Case] = []


def evaluates(
    id_: str, equation: str, nonlinear: Numbers | Callable[[Drivers], Numbers] | None = None, rig: str = "string",
    left_side: str = "", strength: float = 1.0, within: float = 2e-3, rates: bool = True, jumps: bool = False,
):  # fmt: skip
    """Add a case of the decorated function; what stands left is read from the equation unless it is given."""
    stands = left_side or equation.partition(" = ")[0]
    assert stands in LEFT, equation

    def added(evaluated):
        values = nonlinear if callable(nonlinear) else lambda drivers: dict(nonlinear or {})
        CASES.append(Case(id_, equation, evaluated, values, rig, stands, strength, within, rates, jumps))
        return evaluated

    return added


def each(c: Numbers, pattern: str) -> Iterator[tuple[float, re.Match[str]]]:
    """The strengths whose names are of a pattern, with what it finds there."""
    for name, value in c.items():
        match = re.fullmatch(pattern, name)
        if match:
            yield value, match


def one(c: Numbers, name: str) -> float:
    """The strength of that name: 0 unless it is tried."""
    return c.get(name, 0.0)


def candidate(id_: str, **values: float) -> Callable[[Drivers], Numbers]:
    """Of a mechanism's own candidates the first with those values; scales and switches of a recording stand there."""

    def of(drivers):
        own = mechanisms()[id_].candidates(drivers)
        return next(nonlinear for nonlinear in own if all(nonlinear.get(key) == value for key, value in values.items()))

    return of
