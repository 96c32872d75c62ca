"""The radius falls with twist or tension as the bundle is pressed together."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

PRESSED = (0.03, 0.1, 0.3)  # of the highest pressure of the strands on each other: where voids have closed
SATURATING = (0.15, 0.4)  # of the steepest helix: where a bundle that settles early has settled
SETTLING = (0.2, 0.45)  # of the steepest helix: the same, for one that begins slowly
STAGES, WIDE = (0.5, 0.7), 0.09  # of the steepest helix: where fibres rearrange late, and over how much of it


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """The laws of twist and tension add up; `loaded`: whether the recording can show the tension's.

    `steepest` is the largest tangent of the helix angle, `highest_pressure` that of load times tangent squared.
    """
    steepest = float(f"{max(float(np.percentile(drivers.tangent, 99.9)), 1e-6):.6g}")
    pressure = float(np.percentile(np.maximum(drivers.load, 0.0) * drivers.tangent**2, 99.9))
    highest = float(f"{max(pressure, 1e-9):.6g}")
    return [{"loaded": float(drivers.loaded), "steepest": steepest, "highest_pressure": highest}]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Relative loss of radius: powers of the helix angle's tangent, with and without load, and the load's logarithm."""
    slope = np.maximum(drivers.tangent, 0.0)
    all_terms = [Term(f"tangent_{power}", "radius", -(slope**power), "1", high=1.0) for power in (1, 2, 4)]
    for share in SATURATING:
        all_terms.append(
            Term(f"within_{share:g}", "radius", np.expm1(-slope / (share * nonlinear["steepest"])), "1", high=0.5)
        )
    for share in SETTLING:
        early = np.expm1(-((slope / (share * nonlinear["steepest"])) ** 2))
        all_terms.append(Term(f"settled_{share:g}", "radius", early, "1", high=0.5))
    for share in STAGES:
        late = -1.0 / (1.0 + np.exp((share - slope / nonlinear["steepest"]) / WIDE))
        all_terms.append(Term(f"stage_at_{share:g}", "radius", late, "1", high=0.5))
    pressure = np.maximum(drivers.load, 0.0) * slope**2 / nonlinear["highest_pressure"]
    for share in PRESSED:
        for name, power in (("closing", 1), ("ordering", 2)):
            all_terms.append(
                Term(f"{name}_at_{share:g}", "radius", np.expm1(-((pressure / share) ** power)), "1", high=0.5)
            )
    if nonlinear["loaded"]:
        load = np.maximum(drivers.load, 0.05)
        all_terms += [Term(f"load_tangent_{power}", "radius", -load * slope**power, "1/10N") for power in (1, 2)]
        all_terms.append(Term("log_load", "radius", -np.log(load), "1", high=0.5))
    return all_terms


MECHANISM = Mechanism(
    id="radius_compaction",
    driver="twist and tension",
    columns=("twist", "twist squared"),
    equation="r_e = r (1 - k(tan a, F) - s ln(F/F_ref))",
    letters={
        "s": "by how much a load of e times as much presses it thinner",
    },
    strengths=("k", "s"),
    rows={"k": "tangent|within|settled|stage|closing|ordering", "s": "log_load"},
    meanings={
        "highest_pressure": "the highest load x tan(helix angle)^2 of the recording, {scale}",
    },
    scale_units={"highest_pressure": "10N"},
    names={
        "tangent_*": "minus tan(helix angle) to the power in its name",
        "load_tangent_*": "minus the load x tan(helix angle) to the power in its name",
        "within_*": "exp(-s/w) - 1: s is tan(helix angle) as a share of `steepest`, w the number in its name",
        "settled_*": "exp(-(s/w)^2) - 1: s is tan(helix angle) as a share of `steepest`, w the number in its name",
        "stage_at_*": "a soft step from 0 to -1, where tan(helix angle) as a share of `steepest` is as in its name",
        "closing_at_*": (
            "exp(-p/w) - 1: p is load x tan(helix angle)^2 as a share of `highest_pressure`, w the number in its name"
        ),
        "ordering_at_*": (
            "exp(-(p/w)^2) - 1: p is load x tan(helix angle)^2 as a share of `highest_pressure`, "
            "w the number in its name"
        ),
        "log_load": "minus ln(load / 10 N)",
    },
    source="Popov, Gaponov and Ryu, A study on twisted string actuation systems, IEEE/RSJ IROS 2012 (variable radius)",
    confused_with="a wrong radius, shaft_windup, jam",
    told_apart_by="more than 20 turns at two loads; an image of the bundle",
    meaning="the twist or the tension presses the bundle thinner.",
    sentence="The twist presses the bundle thinner: its radius falls, which costs up to {span} of {reading} ({size}).",
    candidates=candidates,
    terms=terms,
)
