"""Lengthening under load over time, recovering at least partly."""

import numpy as np

from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import time_constants, within

TIMES_S = (1.0, 4.0, 15.0, 60.0, 240.0, 1000.0)  # time constants of the branches


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Freshly loaded at the first sample, or loaded for long before it; the times that the recording can show."""
    taus = time_constants(drivers, TIMES_S)
    scales = {"fastest_s": taus[0], "slowest_s": taus[-1], "loaded": float(drivers.loaded)}
    return [{"fresh": fresh, **scales} for fresh in (1.0, 0.0)]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Kelvin-Voigt branches that follow the load, and the tension that the twist adds to it."""
    all_terms = []
    tensions = {"load": (drivers.load, drivers.load0)}
    if nonlinear["loaded"] and drivers.levered:
        tensions["steep_load"] = (drivers.load * np.abs(drivers.load), drivers.load0 * abs(drivers.load0))
    if drivers.levered:
        for name, power in (("twist", 2), ("steep_twist", 4)):
            twisted = drivers.load * drivers.tangent**power
            tensions[name] = (twisted, float(twisted[0]))
    for name, (tension, before) in tensions.items():
        start = 0.0 if nonlinear["fresh"] else before
        for tau_s in within(TIMES_S, nonlinear):
            strain = lowpass(tension, drivers.time_s, tau_s, start) - start
            all_terms.append(Term(f"{name}_{tau_s:g}_s_mm_per_10_n", "length", strain, "mm/10N"))
    return all_terms


MECHANISM = Mechanism(
    id="creep",
    driver="time under load",
    equation="dx = -sum z_i, dz_i/dt = (a_i F - z_i)/tau_i",
    source=(
        "Findley, Lai and Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, 1976 (Kelvin-Voigt chain)"
    ),
    confused_with="plastic_elongation, thermal, sensor_drift",
    told_apart_by="a hold under load, then a rest without it: creep goes on in the hold and comes back in the rest",
    meaning="under load the string lengthens with time and takes some of it back.",
    sentence="Under load the {string} lengthens by up to {span} ({size}), {times}, and shortens again without it.",
    names={
        "load": "the load",
        "steep_load": "the load squared",
        "twist": "load x tan(helix angle)^2",
        "steep_twist": "load x tan(helix angle)^4",
    },
    candidates=candidates,
    terms=terms,
)
