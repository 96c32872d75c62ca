"""The radius {grows} with time, at work and at rest alike: the string takes up moisture, or dries."""

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import growths


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Thicker or thinner; `whole_s` is the recording's length, for scale. None where nothing is wound."""
    if not drivers.levered:
        return []
    return [{"sign": sign, "whole_s": float(f"{drivers.elapsed_s[-1]:.6g}")} for sign in (-1.0, 1.0)]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Relative change of radius with time, saturating, straight and bent."""
    grown = growths(drivers.elapsed_s, nonlinear["whole_s"])
    return [Term(name, "radius", nonlinear["sign"] * signal, "1", high=0.5) for name, signal in grown.items()]


MECHANISM = Mechanism(
    id="x_swelling",
    driver="time",
    equation="r_e = r (1 +- k g(t))",
    letters={
        "g": "how it grows with time",
    },
    source="Morton and Hearle, Physical Properties of Textile Fibres, 1962 (swelling with humidity)",
    confused_with="wear, which stands still at rest; sensor_drift, which is the same at every twist",
    told_apart_by="a long rest between two strokes: what the air does goes on in it",
    meaning="the radius changes with time, at rest too (damp air); a stand-in, no physics of the library.",
    sentence="The radius {grows} with time, at rest too, which {lowers} the {reading} by up to {span} ({size}).",
    candidates=candidates,
    terms=terms,
    helper=True,
)
