"""Permanent lengthening that grows with worked strokes and with new highest tensions."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import saturations

SHARES = {"root": 0.5, "whole": 1.0}  # powers of the load of the moment, with which a grown length is seen
STEEPER = {"flat": 0.0, "half": 0.5, "twice": 2.0}  # by how much a tension grows from no helix to the steepest
YIELDS = (0.5, 0.65, 0.8, 0.9)  # of the highest tension: below it nothing yields
YIELDS_WITHIN_S = 1.0  # time constant of sudden yielding: after it about a third is still to come


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Work weighs with the load to the power 0 or 1; `work` is the recording's whole work, for scale.

    `loaded`: whether the load varies, so that its new maxima show. For scale, `steepest` is the largest tangent of the
    helix angle, and `highest_…` the highest tension by each way in which it may grow with that.
    """
    powers = (0.0, 1.0, 2.0) if drivers.loaded else (1.0,)
    scales = {"loaded": float(drivers.loaded)}
    if drivers.levered:
        scales["steepest"] = float(f"{max(float(np.max(drivers.tangent)), 1e-6):.6g}")
        for name in STEEPER:
            highest = float(np.max(tension(drivers, name, scales["steepest"])))
            scales[f"highest_{name}"] = float(f"{max(highest, 1e-6):.6g}")
    return [
        {"load_power": power, "work": float(f"{drivers.worked(power)[-1]:.6g}") or 1.0, **scales} for power in powers
    ]


def tension(drivers: Drivers, name: str, steepest: float) -> Array:
    """The load, plus a share of it that grows with the helix's steepness, up to `STEEPER` at the `steepest`.

    Shape (samples,), in units of 10 N. A strand at an angle pulls harder than the load, and is bent over its
    neighbours.
    """
    return np.asarray(np.abs(drivers.load) * (1.0 + STEEPER[name] * np.square(drivers.tangent / steepest)))


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
    pressed = np.maximum.accumulate(drivers.load * drivers.tangent**2)
    all_terms.append(Term("new_highest_twist_mm", "length", pressed - pressed[0]))
    return [*all_terms, *_yielding(drivers, nonlinear)] if "steepest" in nonlinear else all_terms


def _yielding(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Beyond a yield point, lengthening with the highest tension so far, within a second, and with the time there."""
    all_terms = []
    step_s = np.diff(drivers.time_s, prepend=drivers.time_s[0])
    step_s[drivers.breaks] = 0.0  # nobody says what the string carried between two runs
    for name in STEEPER:
        if name == "flat" and not nonlinear["loaded"]:
            continue
        share = tension(drivers, name, nonlinear["steepest"]) / nonlinear[f"highest_{name}"]
        for at in YIELDS:
            beyond = np.maximum(share - at, 0.0) / (1.0 - at)
            hardened = np.maximum.accumulate(beyond)
            yielded = lowpass(hardened, drivers.time_s, YIELDS_WITHIN_S, float(hardened[0])) - hardened[0]
            all_terms.append(Term(f"yields_{at:g}_{name}_mm", "length", yielded))
            all_terms.append(Term(f"flows_{at:g}_{name}_mm_per_s", "length", np.cumsum(beyond * step_s), "mm/s"))
    return all_terms


MECHANISM = Mechanism(
    id="plastic_elongation",
    driver="worked strokes",
    columns=("work", "travel"),
    equation="dx = -P, P = P_L (F/F_ref)^n g(c) + k max(T - T_y, 0) + q A",
    letters={
        "P_L": "the strengths within_… and steady_…, of growth with the work",
        "c": "the work so far: the load to the power of load_power, over the way that winding adds",
        "g": "how it grows with the work, by the words in the names",
        "k": "the strengths new_highest_… and yields_…, of growth with the highest load or tension so far",
        "q": "the strengths flows_…, of growth with the time beyond the yield point",
        "A": "the sum of max(T - T_y, 0) over the time so far",
        "T": "the tension: its highest so far beside k",
        "T_y": "the yield point, of the highest tension the share in the name; 0 in new_highest_…",
        "n": "0, with root_load in the name 0.5, with whole_load 1 | by its name",
    },
    strengths=("P_L", "k", "q"),
    rows={"P_L": "within|steady", "k": "new_highest|yields", "q": "flows"},
    meanings={
        "highest_flat": "the highest load of the recording, {scale}",
        "highest_half": "the highest tension, if it grows by half of the load up to the steepest helix, {scale}",
        "highest_twice": "the highest tension, if it grows by twice the load up to the steepest helix, {scale}",
    },
    scale_units={"highest_flat": "10N", "highest_half": "10N", "highest_twice": "10N"},
    source=(
        "McKenna, Hearle and O'Hear, Handbook of Fibre Rope Technology, 2004 (bedding-in); Bingham, Fluidity and "
        "Plasticity, 1922 (nothing flows below a yield point)"
    ),
    confused_with="creep, thermal, sensor_drift, stiffening (opposite sign), clamp_slip",
    told_apart_by="a pause at low tension: what grows with strokes or high tension stands still and is not recovered",
    meaning="the string grows longer for good, stroke by stroke.",
    sentence="Every worked stroke leaves the {string} longer, {span} in all ({size}), and no rest takes it back.",
    names={
        "within_*": "1 - exp(-s/w), which ends as work goes on: s is the share of `work` so far, w the number in it",
        "steady": "the share of `work` done so far",
        "root_load": "the root of the load",
        "whole_load": "the load",
        "new_highest_load": "the highest load so far, less the first one",
        "new_highest_twist": "the highest load x tan(helix angle)^2 so far, less the first one",
        "yields_*": "how far the highest tension so far is beyond the yield point in its name, as a share of the most",
        "flows_*": "the time at a tension beyond the yield point in its name, weighed by how far beyond",
        "flat": "the tension as the load",
        "half": "the tension as the load, and higher by half of it at the steepest helix",
        "twice": "the tension as the load, and higher by twice that at the steepest helix",
    },
    optional=("steepest", *(f"highest_{name}" for name in STEEPER)),
    candidates=candidates,
    terms=terms,
)
