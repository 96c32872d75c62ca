"""A constant force or angle on the reading, which has no arbitrary zero [EMPS; cable drive]."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """None where the zero is calibration (a string's displacement): there an offset cannot show."""
    return [] if drivers.free_zero else [{}]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """A constant on the reading."""
    return [Term("offset_mm", "sensor", np.ones_like(drivers.motion), "mm", -np.inf)]


MECHANISM = Mechanism(
    id="sensor_offset",
    driver="nothing: a constant",
    equation="y_m = y + c",
    letters={
        "c": "the constant",
        "y": "the reading, by the dimensions alone",
        "y_m": "what the sensor reads",
    },
    strengths=("c",),
    source="Joint Committee for Guides in Metrology, International vocabulary of metrology, JCGM 200:2012 (zero error)",
    confused_with="end_stop (which holds at one end only)",
    told_apart_by="a reading at rest without load",
    meaning="a constant force or angle is added.",
    sentence="The {reading} carries a constant offset, {size}.",
    details=("{offset_mm}",),
    candidates=candidates,
    terms=terms,
)
