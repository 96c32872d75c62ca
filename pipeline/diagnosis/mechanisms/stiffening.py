"""The string gets stiffer with work, so that it stretches less under the same load."""

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import saturations


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Over work or over time; `work` and `whole_s` are the recording's own, for scale; none without a load."""
    work = float(f"{drivers.worked(1.0)[-1]:.6g}")
    if work <= 0.0:
        return []
    whole_s = float(f"{drivers.elapsed_s[-1]:.6g}")
    refs = (0.0, drivers.load0)
    return [{"work": work, "from_load": ref} for ref in refs] + [{"whole_s": whole_s, "from_load": ref} for ref in refs]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """A stretch that falls with work, in proportion to the load."""
    in_time = "whole_s" in nonlinear
    grown = (
        saturations(drivers.elapsed_s, nonlinear["whole_s"])
        if in_time
        else saturations(drivers.worked(1.0), nonlinear["work"])
    )
    load = drivers.load - nonlinear["from_load"]
    return [Term(f"{name}_mm_per_10_n", "length", -load * signal, "mm/10N") for name, signal in grown.items()]


MECHANISM = Mechanism(
    id="stiffening",
    driver="load x worked strokes",
    columns=("load x work",),
    equation="dx = +(F - F_0) (1/K_0 - 1/K), 1/K = 1/K_0 - k g(c)",
    variants={"whole_s": "dx = +(F - F_0) (1/K_0 - 1/K), 1/K = 1/K_0 - k g(t)"},
    letters={
        "F_0": "from_load",
        "K": "the stiffness of the string now",
        "K_0": "the stiffness before the first stroke, which the strengths hold already | not needed alone",
        "g": "how its yielding falls with the strokes, or over time, by the words in the names",
    },
    strengths=("k",),
    source="McKenna, Hearle and O'Hear, Handbook of Fibre Rope Technology, 2004 (stiffness after working)",
    confused_with="plastic_elongation (opposite sign), creep, wear",
    told_apart_by="small load steps at one twist every few strokes",
    meaning="the string gets stiffer with work.",
    sentence="With work the {string} grows stiffer and stretches up to {span} less under its load ({size}).",
    names={
        "within_*": "1 - exp(-s/w): s is the share of `work` or `whole_s` so far, w the number in the name",
        "steady": "the share of `work` or `whole_s` so far",
    },
    candidates=candidates,
    units={"work": "10mm", "from_load": "10N"},
    terms=terms,
)
