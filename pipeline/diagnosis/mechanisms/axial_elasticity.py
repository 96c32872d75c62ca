"""The string, or what holds it, stretches with the load."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

TOE_LOADS = (0.15, 0.5)  # of 10 N


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """`from_load` (10 N) is the load of the tare; none where it is constant in each run, which shows nothing."""
    return [{"from_load": float(f"{drivers.load0:.6g}")}] if drivers.loaded_within else []


def saturating(load: Array, toe: float) -> Array:
    """1 − exp(−|load| / toe), with the load's sign: a cable is pulled both ways.

    Shape (samples,), without a unit; load and toe in one unit.
    """
    return np.asarray(np.sign(load) * (1.0 - np.exp(-np.abs(load) / toe)))


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Stretch with the load: straight, with a toe, and growing faster than the load."""
    load, load0 = drivers.load, nonlinear["from_load"]
    all_terms = [Term("straight_mm_per_10_n", "length", load - load0, "mm/10N")]
    yielding = load * np.abs(load) - load0 * abs(load0)
    if drivers.levered:  # what a cable drive yields to is its friction
        all_terms.append(Term("yielding_mm", "length", yielding))
    for toe in TOE_LOADS:
        signal = saturating(load, toe) - saturating(np.array(load0), toe)
        all_terms.append(Term(f"toe_{toe * 10:g}_n_mm", "length", signal))
    return all_terms


MECHANISM = Mechanism(
    id="axial_elasticity",
    driver="load",
    columns=("load",),
    equation="dx = -(F - F_tare)/K - (toe(F) - toe(F_tare))",
    letters={
        "F_tare": "from_load",
        "K": "the stiffness: one over the strength straight_…",
        "toe": "a stretch that is no straight line: of the strengths toe_… it ends as the load grows",
    },
    strengths=("K", "toe"),
    source=(
        "Wuertz et al., The twisted string actuation system: modeling and control, IEEE/ASME AIM 2010; toe "
        "region: McKenna, Hearle and O'Hear, Handbook of Fibre Rope Technology, 2004"
    ),
    confused_with="frame compliance (the same name), creep of short time constant, shaft_windup",
    told_apart_by="load steps at two twists: a stretch is the same at both",
    meaning="the string stretches with the load.",
    sentence="The {string} stretches with its load, by up to {span} ({size}).",
    details=("{straight_mm_per_10_n} in proportion to the load",),
    names={
        "straight": "the load, less that of the tare",
        "yielding": "the load squared, less that of the tare",
        "toe_*": "1 - exp(-F/w), less its value at the tare: F is the load, w the load in the name",
    },
    candidates=candidates,
    units={"from_load": "10N"},
    terms=terms,
)
