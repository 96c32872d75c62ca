"""The radius changes with travel: filaments wear off, settle or fray [B4-B6]."""

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.shapes import saturations


def shapes(drivers: Drivers) -> list[Shape]:
    """Thinner or thicker; `travel_turns` is the recording's whole travel, for scale."""
    travel = float(f"{drivers.path[-1]:.6g}")
    return [{"sign": sign, "travel_turns": travel} for sign in (-1.0, 1.0)]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Relative change of radius with travel, saturating and straight."""
    grown = saturations(drivers.path, shape["travel_turns"])
    return [Term(name, "radius", shape["sign"] * signal, "1", high=0.5) for name, signal in grown.items()]


MECHANISM = Mechanism(
    id="wear",
    driver="travel",
    equation="r_e = r (1 -+ k g(travel))",
    source="physics.md B4-B6",
    confused_with="plastic_elongation (which is the same at every twist), count_slip",
    told_apart_by="the lowest twist, where wear shows nothing; a diameter gauge",
    sentence="The radius changes with the distance travelled, which moves the {reading} by up to {span} ({size}).",
    shapes=shapes,
    terms=terms,
)
