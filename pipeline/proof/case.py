"""One concealed case: what is drawn from its seed, what is recorded of it, and what its sealed answer says."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from ..rig.concealed import Parameters
from ..rig.effects import concealed
from .bench import Bench, draw_bench, mismeasure
from .draws import NAMED, OPEN_SET, draw_effect
from .location import location
from .nuisance import Nuisance, Recorded, draw_nuisance, late_s, record
from .perform import perform
from .protocol import Kind, Protocol, draw_protocol
from .referee import Ruling, rule
from .sealed import Answer
from .size import OutOfReach, Size, measure, rms, strength_for

Stratum = Literal["none", "parameters", "noise", "single", "pair", "open"]
STRATA: tuple[Stratum, ...] = ("none", "parameters", "noise", "single", "pair", "open")
HIDES = {"single": 1, "pair": 2, "open": 1}  # effects in a case, by stratum; the others hide none
ALWAYS = ("radius_compaction", "axial_elasticity", "eccentricity")  # every real string has a little of these
ATTEMPTS = 8
ALWAYS_KAPPA = 0.15  # and together they stay below this
HELD_OUT = 0.30  # of the strokes, the last ones
WITHIN, BEYOND = (0.0, 1.8), (1.0, 3.0)  # sigma of the measuring errors; so far off only in `parameters`


@dataclass(frozen=True)
class Case:
    """Everything about a case before it is performed; the same seed draws the same case."""

    seed: int
    stratum: Stratum
    bench: Bench
    protocol: Protocol
    nuisance: Nuisance
    effects: dict[str, Parameters]  # what the answer names
    sizes: dict[str, Size]  # of each alone
    rulings: dict[str, Ruling]  # of the referee, on each alone
    always: dict[str, Parameters]  # what the answer does not name
    load_cell: bool
    thermocouple: bool


def draw_case(
    seed: int, stratum: Stratum, protocol: Kind, effects: Sequence[str] = (), kappas: Sequence[float] = (1.0,)
) -> Case:
    """Draw a case; effects that are not given are drawn, and one kappa serves for all of them. Raises OutOfReach."""
    # a stream for each thing, so that another effect does not change the bench that it is hidden in
    bench_rng, protocol_rng, nuisance_rng, effect_rng, always_rng = (
        np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(5)
    )
    bench = mismeasure(draw_bench(bench_rng), bench_rng, BEYOND if stratum == "parameters" else WITHIN)
    protocol_drawn = draw_protocol(protocol, bench, protocol_rng)
    nuisance = draw_nuisance(nuisance_rng, trap=stratum == "noise")
    load_cell, thermocouple = protocol == "rich" or nuisance_rng.random() < 0.5, nuisance_rng.random() < 0.2
    count, pool = HIDES.get(stratum, 0), OPEN_SET if stratum == "open" else NAMED
    drawn = effect_rng.permutation(np.array(pool, object)).tolist()
    names = [*effects, *[name for name in drawn if name not in effects]][:count]
    wanted = [*kappas, *[kappas[-1]] * count][:count]
    hidden, sizes = {}, {}
    rulings: dict[str, Ruling] = {}
    for name, kappa in zip(names, wanted, strict=True):
        hidden[name], sizes[name], rulings[name] = _pure(
            name, bench, protocol_drawn, nuisance.floor_mm, kappa, effect_rng
        )
    always = _always(bench, protocol_drawn, nuisance.floor_mm, names, always_rng)
    thermocouple |= any(concealed(name).warms_the_room(parameters) for name, parameters in hidden.items())
    return Case(seed, stratum, bench, protocol_drawn, nuisance, hidden, sizes, rulings, always, load_cell, thermocouple)


def _pure(
    name: str, bench: Bench, protocol: Protocol, floor_mm: float, kappa: float, rng: np.random.Generator
) -> tuple[Parameters, Size, Ruling]:
    """An effect of the wanted size that the referee lets pass under its name; raises OutOfReach after some attempts."""
    for _ in range(ATTEMPTS):
        of = draw_effect(name, bench, protocol, rng)
        strength, size = strength_for(name, of, bench, protocol, floor_mm, kappa)
        ruling = rule(name, of(strength), bench, protocol)
        if ruling.pure:
            return of(strength), size, ruling
    raise OutOfReach(f"{name} of {kappa:g} noise floors is never pure on this bench and protocol")


def _always(
    bench: Bench, protocol: Protocol, floor_mm: float, but: Sequence[str], rng: np.random.Generator
) -> dict[str, Parameters]:
    """Small effects that no diagnosis has to find, by id; an effect that this bench cannot show is left out.

    The size of each is what calibration leaves of it on a bench that was measured exactly. A wrongly measured bench
    leaves something by itself, so that even the smallest strength would seem too large.
    """
    exact_bench = replace(bench, measured=bench.true)
    always = {}
    for name in ALWAYS:
        if name in but:
            continue
        kappa = ALWAYS_KAPPA / len(ALWAYS) * rng.uniform(0.3, 0.9)
        of = draw_effect(name, bench, protocol, rng)
        try:
            always[name] = of(strength_for(name, of, exact_bench, protocol, floor_mm, kappa)[0])
        except OutOfReach:
            continue
    return always


def performed(case: Case) -> Recorded:
    """The case's recording, with all its effects and nuisances."""
    late_rng, record_rng = (np.random.default_rng(child) for child in np.random.SeedSequence([case.seed, 1]).spawn(2))
    count = len(case.protocol.phases[0])
    late = late_s(case.nuisance, case.protocol.rate_hz, count, late_rng)
    signals = perform(case.bench, case.protocol, case.effects | case.always, late)
    return record(signals, case.nuisance, case.protocol.rate_hz, case.load_cell, case.thermocouple, record_rng)


def heldout_noise_mm(recorded: Recorded) -> float:
    """What the true noise-free displacement leaves of the last 30 % of strokes (at least one), outliers aside."""
    strokes = int(recorded.stroke.max())
    late = recorded.stroke > strokes - max(1, round(HELD_OUT * strokes))
    return rms(recorded.error_mm[late & ~recorded.wild])


def answer(case: Case, run: str) -> Answer:
    """The sealed answer: what is hidden in the recording, how much of it calibration leaves, and where."""
    bench, floor_mm = case.bench, case.nuisance.floor_mm
    motion: Any = case.protocol.motion.model_dump()
    size, clean, fit = measure(bench, case.protocol, case.effects, floor_mm)
    extras, _, _ = measure(replace(bench, measured=bench.true), case.protocol, case.always, floor_mm)
    return {
        "run": run,
        "seed": case.seed,
        "stratum": case.stratum,
        "protocol": case.protocol.kind,
        "effects": [
            {"id": name, "parameters": parameters, **case.sizes[name].told(), **case.rulings[name].told()}
            for name, parameters in case.effects.items()
        ],
        "together": size.told(),
        "noise_floor_mm": floor_mm,
        "heldout_noise_mm": heldout_noise_mm(performed(case)),
        "location": location(clean, fit.residual_mm) if case.effects else None,
        "dimensions": {
            name: {"measured": getattr(bench.measured, name), "true": getattr(bench.true, name)}
            for name in ("radius_mm", "separator_mm", "torsion_zone_mm", "length_mm", "stiffness_n_per_mm")
        },
        "measuring_errors_sigma": bench.errors(),
        "calibration_moves_sigma": fit.sigmas,
        "scale": bench.scale,
        "zero_mm": bench.zero_mm,
        "nuisance": case.nuisance.told(),
        "always": {"effects": case.always, "kappa": extras.kappa},
        "motion": motion,
    }
