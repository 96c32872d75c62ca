"""Lengthening under load over time, recovering at least partly."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import AS_THE_FIRST, GOES_ON, LATER_RUNS, LOADED_FOR_LONG, begun, through, time_constants, within

TIMES_S = (
    1.0, 1.4, 2.0, 2.8, 4.0, 5.7, 8.0, 11.0, 15.0, 21.0, 30.0, 42.0, 60.0, 85.0, 120.0, 170.0, 240.0, 340.0, 500.0,
    700.0, 1000.0,
)  # of the branches, so near that one time constant between two of them is followed to 1 %  # fmt: skip


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Freshly loaded at the first sample, or loaded long before it; times that the recording can show.

    A later run goes on from the one before, begins as the first one did, or was loaded for long before it, too.
    """
    taus = time_constants(drivers, TIMES_S)
    scales = {"fastest_s": taus[0], "slowest_s": taus[-1], "loaded": float(drivers.loaded)}
    ways = {1.0: (GOES_ON, AS_THE_FIRST, LOADED_FOR_LONG), 0.0: (GOES_ON, AS_THE_FIRST)}
    return [each for fresh in ways for each in begun(drivers, [{"fresh": fresh, **scales}], ways[fresh])]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Kelvin-Voigt branches that follow the load, and the tension that the twist adds to it."""
    parts = [(drivers.time_s[part], _tensions(drivers, part, nonlinear)) for part in through(drivers, nonlinear)]
    later_fresh = bool(nonlinear["fresh"]) and nonlinear.get(LATER_RUNS) != LOADED_FOR_LONG
    fresh = [bool(nonlinear["fresh"]), *(later_fresh for _ in parts[1:])]
    all_terms = []
    for name in parts[0][1]:
        for tau_s in within(TIMES_S, nonlinear):
            strains = [
                _strain(time_s, *tensions[name], tau_s, is_fresh)
                for (time_s, tensions), is_fresh in zip(parts, fresh, strict=True)
            ]
            all_terms.append(Term(f"{name}_{tau_s:g}_s_mm_per_10_n", "length", np.concatenate(strains), "mm/10N"))
    return all_terms


def _tensions(drivers: Drivers, part: slice, nonlinear: Nonlinear) -> dict[str, tuple[Array, float]]:
    """The tensions that strain the string in some samples, by name, each with its value before them."""
    load, before = drivers.load[part], drivers.load0_of(part)
    tensions = {"load": (load, before)}
    if nonlinear["loaded"] and drivers.levered:
        tensions["steep_load"] = (load * np.abs(load), before * abs(before))
    if drivers.levered:
        for name, power in (("twist", 2), ("steep_twist", 4)):
            twisted = load * drivers.tangent[part] ** power
            tensions[name] = (twisted, float(twisted[0]))
    return tensions


def _strain(time_s: Array, tension: Array, before: float, tau_s: float, fresh: bool) -> Array:
    """The strain of one branch from the first sample on; it starts `fresh`, or long under the tension `before`."""
    start = 0.0 if fresh else before
    return lowpass(tension, time_s, tau_s, start) - start


MECHANISM = Mechanism(
    id="creep",
    driver="time under load",
    columns=("load x time",),
    equation="dx = -sum z_i, dz_i/dt = (a_i F - z_i)/tau_i",
    letters={
        "a_i": "the strengths; F stands for what each multiplies",
        "tau_i": "the time constant of each strength | in its name",
        "z_i": "what each element has lengthened so far",
    },
    strengths=("a_i",),
    meanings={
        "fresh": (
            "1 means: the {string} was first loaded at the first sample, and 0: it had been loaded for long before"
        ),
    },
    source=(
        "Findley, Lai and Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, 1976 (Kelvin-Voigt chain)"
    ),
    confused_with="plastic_elongation, thermal, sensor_drift",
    told_apart_by="a hold under load, then a rest under less: creep goes on in the hold and comes back in the rest",
    meaning="under load the string lengthens with time and takes some of it back.",
    sentence=(
        "Under load the {string} lengthens by up to {span} ({size}), {times}, with a steady load {half}, and shortens "
        "again without it."
    ),
    names={
        "load": "the load",
        "steep_load": "the load squared",
        "twist": "load x tan(helix angle)^2",
        "steep_twist": "load x tan(helix angle)^4",
    },
    optional=(LATER_RUNS,),
    candidates=candidates,
    terms=terms,
)
