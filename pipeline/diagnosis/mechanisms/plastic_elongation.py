"""Permanent lengthening that grows with worked strokes and with new highest tensions."""

import numpy as np

from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import saturations

SHARES = {"root": 0.5, "whole": 1.0}  # powers of the load of the moment, with which a grown length is seen
STEEPER = (0.0, 0.5, 2.0)  # how much higher the tension is at the steepest helix than at none, as a share of the latter
YIELDS = (0.5, 0.65, 0.8, 0.9)  # of the highest tension: below it nothing yields
YIELDS_WITHIN_S = 1.0


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Work weighs with the load to the power 0 or 1; `work` is the recording's whole work, for scale.

    `loaded`: whether the load varies, so that its new maxima show.
    """
    powers = (0.0, 1.0, 2.0) if drivers.loaded else (1.0,)
    return [
        {"load_power": power, "work": float(f"{drivers.worked(power)[-1]:.6g}") or 1.0, "loaded": float(drivers.loaded)}
        for power in powers
    ]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Saturating and straight growth with work, the same or more under load, and with each new highest tension."""
    grown = saturations(drivers.worked(nonlinear["load_power"]), nonlinear["work"])
    all_terms = [Term(f"{name}_mm", "length", signal) for name, signal in grown.items()]
    if nonlinear["loaded"] and drivers.levered:
        for name, signal in grown.items():
            for power, share in SHARES.items():
                all_terms.append(Term(f"{name}_{power}_load_mm", "length", signal * np.abs(drivers.load) ** share))
        highest = np.maximum.accumulate(drivers.load)
        all_terms.append(Term("new_highest_load_mm", "length", highest - highest[0]))
    tension = np.maximum.accumulate(drivers.load * drivers.tangent**2)
    all_terms.append(Term("new_highest_twist_mm", "length", tension - tension[0]))
    return [*all_terms, *_yielding(drivers)] if drivers.levered else all_terms


def _yielding(drivers: Drivers) -> list[Term]:
    """Lengthening in proportion to the highest tension so far beyond a yield point, which hardens, within a second."""
    all_terms = []
    steepness = (drivers.tangent / max(float(np.max(drivers.tangent)), 1e-9)) ** 2
    for steeper in STEEPER:
        tension = np.abs(drivers.load) * (1.0 + steeper * steepness)
        highest = np.maximum.accumulate(tension)
        for share in YIELDS:
            flow = np.maximum(tension / highest[-1] - share, 0.0) * np.diff(drivers.time_s, prepend=drivers.time_s[0])
            flowed = np.cumsum(flow) / max(float(np.sum(flow)), 1e-9)
            all_terms.append(Term(f"flows_{share:g}_steeper_{steeper:g}_mm", "length", flowed))
            beyond = np.maximum(highest / highest[-1] - share, 0.0) / (1.0 - share)
            if beyond[0] < 1.0:
                yielded = lowpass(beyond, drivers.time_s, YIELDS_WITHIN_S, float(beyond[0]))
                all_terms.append(Term(f"yields_{share:g}_steeper_{steeper:g}_mm", "length", yielded - yielded[0]))
    return all_terms


MECHANISM = Mechanism(
    id="plastic_elongation",
    driver="worked strokes",
    equation="dx = -P, P = P_L (F/F_ref)^m ln(1 + c), or k max T: any sum of saturating growths with work",
    letters={
        "P_L": "the strengths within_… and steady_…, of growth with the work",
        "c": "the work so far, as a share of a part of all work",
        "k": "the strengths new_highest_…, of growth with the highest load or tension so far",
        "T": "the tension",
        "m": "load_power",
    },
    strengths=("P_L", "k"),
    rows={"P_L": "within|steady", "k": "new_highest"},
    source="McKenna, Hearle and O'Hear, Handbook of Fibre Rope Technology, 2004 (bedding-in)",
    confused_with="creep, thermal, sensor_drift, stiffening (opposite sign), clamp_slip",
    told_apart_by="a pause: what grows with strokes alone stands still in it and is not recovered",
    meaning="the string grows longer for good, stroke by stroke.",
    sentence="Every worked stroke leaves the {string} longer, {span} in all ({size}), and no rest takes it back.",
    names={
        "within_*": "1 - exp(-s/w), which grows as ln(1 + c) does: s is the share of `work` so far, w the number in it",
        "steady": "the share of `work` done so far",
        "root_load": "the root of the load",
        "whole_load": "the load",
        "new_highest_load": "the highest load so far, less the first one",
        "new_highest_twist": "the highest load x tan(helix angle)^2 so far, less the first one",
    },
    candidates=candidates,
    terms=terms,
)
