"""The string gets stiffer with work, so that it stretches less under the same load [A6]."""

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.shapes import saturations


def shapes(drivers: Drivers) -> list[Shape]:
    """`work` is the recording's whole work, for scale; none without a load, which would show nothing."""
    work = float(f"{drivers.worked(1.0)[-1]:.6g}")
    return [{"work": work, "from_load": ref} for ref in (0.0, drivers.load0)] if work > 0 else []


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """A stretch that falls with work, in proportion to the load."""
    grown = saturations(drivers.worked(1.0), shape["work"])
    load = drivers.load - shape["from_load"]
    return [Term(f"{name}_mm_per_10_n", "length", -load * signal, "mm/10N") for name, signal in grown.items()]


MECHANISM = Mechanism(
    id="stiffening",
    driver="load x worked strokes",
    equation="dx = +F (1/K_0 - 1/K(c)), K = K_0 (1 + k g(c))",
    source="physics.md A6",
    confused_with="plastic_elongation (opposite sign), creep, wear",
    told_apart_by="small load steps at one twist every few strokes",
    sentence="With work the {string} grows stiffer and stretches up to {span} less under its load ({size}).",
    shapes=shapes,
    units={"work": "10mm", "from_load": "10N"},
    terms=terms,
)
