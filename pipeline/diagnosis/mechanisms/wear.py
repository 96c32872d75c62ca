"""The radius changes with travel: filaments wear off, settle or fray."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import growths


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Thinner or thicker, with travel or with travel under load; `travel_turns` is the recording's own, for scale."""
    powers = (0.0, 1.0) if drivers.loaded else (0.0,)
    whole = {power: float(f"{travelled(drivers, power)[-1]:.6g}") for power in powers}
    return [
        {"sign": sign, "travel_turns": whole[power], "load_power": power} for sign in (-1.0, 1.0) for power in powers
    ]


def travelled(drivers: Drivers, load_power: float) -> Array:
    """Travel since the start, each bit of it weighed with the load to a power, as Archard has it.

    Shape (samples,), in mm under the usual load.
    """
    if load_power == 0.0:
        return drivers.path
    load = 0.5 * (np.abs(drivers.load[1:]) + np.abs(drivers.load[:-1])) ** load_power
    return np.concatenate([[0.0], np.cumsum(load * np.diff(drivers.path))])


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Relative change of radius with travel, saturating and straight."""
    grown = growths(travelled(drivers, nonlinear["load_power"]), nonlinear["travel_turns"])
    return [Term(name, "radius", nonlinear["sign"] * signal, "1", high=0.5) for name, signal in grown.items()]


MECHANISM = Mechanism(
    id="wear",
    driver="travel",
    columns=("travel x twist",),
    equation="r_e = r (1 -+ k g(travel))",
    letters={
        "travel": "the distance travelled so far, each bit of it times the load to the power of load_power",
        "g": "how it grows with the travel, by the words in the names",
    },
    strengths=("k",),
    meanings={
        "travel_turns": "the whole travel of the recording, {scale}",
    },
    source="Archard, Contact and rubbing of flat surfaces, Journal of Applied Physics 24, 1953",
    confused_with="plastic_elongation (which is the same at every twist), count_slip",
    told_apart_by="the lowest twist, where wear shows nothing; a diameter gauge",
    meaning="the radius changes with the distance travelled.",
    sentence="The radius {grows} with the distance travelled, which {lowers} the {reading} by up to {span} ({size}).",
    names={
        "within_*": "1 - exp(-s/w): s is the travel as a share of travel_turns, w the number in the name",
        "steady": "the travel as a share of travel_turns",
        "faster": "the square of the travel as a share of travel_turns",
    },
    candidates=candidates,
    terms=terms,
)
