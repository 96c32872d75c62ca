"""A sudden permanent offset: the string slips in its clamp or a knot gives [F12]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.shapes import times


def shapes(drivers: Drivers) -> list[Shape]:
    """When it slips, in s since the start."""
    return times(drivers, 160)


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """A step of the length."""
    return [Term("mm", "length", (drivers.elapsed_s >= shape["at_s"]).astype(float), "mm", -np.inf)]


MECHANISM = Mechanism(
    id="clamp_slip",
    driver="sudden events on the length",
    equation="dx = -sum s_i [t >= t_i]",
    source="physics.md F12",
    confused_with="count_slip (which grows with twist), plastic_elongation",
    told_apart_by="a mark on the string at the clamp",
    sentence="The {string} slipped in its clamp and stayed so, worth {size}.",
    details=("by {mm} after {at_s}",),
    shapes=shapes,
    terms=terms,
    steps=4,
)
