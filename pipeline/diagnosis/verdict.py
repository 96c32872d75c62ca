"""The whole result of a diagnosis, as the content of `diagnosis.json`.

Source: Björck, Numerical Methods for Least Squares Problems, 1996 (which driver's smooth functions leave least of the
mismatch).
"""

from typing import Any, Literal, cast

import numpy as np

from ..ground.code.fingerprint import fingerprint
from ..ground.kinematics import Array
from ..run.description import Run
from .choice import chance
from .choice.outcome import Study, rms
from .document.bounds import at_bound
from .document.content import Relative, Verdict
from .document.rounded import DIGITS, tidy
from .facts.beyond_seen import beyond_seen
from .facts.detectable import detectable
from .facts.evidence import evidence
from .facts.mechanism_entries import as_entry, listed
from .facts.stand_ins import stand_ins
from .facts.told_floor import told_fine_floor
from .facts.zero_effects import without_zero_effects
from .fit import generic, locate
from .fit.adopt import entries
from .fit.intervals import intervals
from .fit.linear import Linear
from .fit.problem import Problem, State
from .fit.uncertainty import doubts
from .fit.zero_entries import zero_entries
from .mechanisms.interface import physics
from .mechanisms.library import mechanisms
from .numerics import residual_band
from .numerics.noise import white
from .proposal import next_runs
from .study.engine import fine_floor
from .study.heldout import Errors, runs_of, worse_than_nominal
from .study.rivals import named_simulator, rivals
from .words.pages.spoken import spoken

HELD_OUT: tuple[Literal["nominal", "calibrated", "explained", "without_physics"], ...] = (
    "nominal", "calibrated", "explained", "without_physics",
)  # fmt: skip


def mismatch_signal(study: Study) -> tuple[Array, list[str]]:
    """The mismatch without its noise, and the drivers it follows: by the best explanation, or by the dictionary.

    Shape (samples,), in the reading's unit.
    """
    problem = study.problem
    before = problem.simulate(study.base)
    if study.verdict in ("explained", "ambiguous") or (study.sets and not physics(study.sets[0].ids)):
        driven = [mechanisms()[id_].driver for id_ in study.sets[0].ids]
        signal = problem.simulate(study.best) - before
        if study.random:
            signal = np.hypot(signal, chance.trace(problem, study.best, study.floor))
        return signal, driven
    return systematic(study, study.base)


def systematic(study: Study, state: State) -> tuple[Array, list[str]]:
    """The part of a simulator's residual that the generic dictionary fits, and the driver of most of it.

    Shape (samples,), in the reading's unit.
    """
    problem = study.problem
    columns = generic.groups(problem.drivers)
    linear = Linear(problem, state, white(study.floor), {}, np.vstack(list(columns.values())))
    table, target = linear.table[:-1], (problem.measured - problem.simulate(state))[: problem.rows]
    whole = np.concatenate([linear.calibration, linear.extra])
    calibration_columns = table[linear.calibration]
    energy_by_driver: dict[str, float] = {}
    at = len(linear.calibration)
    for name, group in columns.items():
        part = np.vstack([calibration_columns, table[at : at + len(group)]])
        at += len(group)
        solution = np.linalg.lstsq(part.T, target, rcond=1e-8)[0]
        energy_by_driver[name] = float(np.mean(np.square(target - part.T @ solution)))
    solution = np.linalg.lstsq(table[whole].T, target, rcond=1e-8)[0]
    return np.asarray(table[whole].T @ solution), [min(energy_by_driver, key=lambda name: energy_by_driver[name])]


def relative(study: Study) -> Relative:
    """The rms residual of each simulator over that of the reading, after the filter that is stated with it."""
    problem, below_hz = study.problem, study.problem.system.stated_below_hz
    first, step_s, rows = problem.drivers.first, problem.drivers.step_s, problem.rows

    def size(signal: Array) -> float:
        return rms(residual_band.within(signal, first, step_s, below_hz)[:rows])

    states, whole = (study.nominal, study.base, study.state), size(problem.measured)
    nominal, calibrated, explained = (size(problem.measured - problem.simulate(at)) / whole for at in states)
    averages = f"averages of {step_s * 1e3:.3g} ms, then {residual_band.words(below_hz, step_s)}"
    return {"nominal": nominal, "calibrated": calibrated, "explained": explained, "filter": averages}


def own_alone(study: Study) -> bool:
    """Whether only mechanisms of a user's own explain: their ids begin with `x_`, and none of them is a helper."""
    ids = study.sets[0].ids if study.sets else ()
    return bool(ids) and not physics(ids) and not any(mechanisms()[id_].helper for id_ in ids)


def next_experiment(study: Study, run: Run) -> next_runs.Proposal | None:
    """What to record next."""
    if study.verdict == "unknown":
        return next_runs.after_unknown(study.problem, run, " and ".join(mismatch_signal(study)[1]))
    if study.verdict != "ambiguous":
        return None
    return next_runs.best(study.problem, run, study.noise, study.search, study.sets)


def diagnosis(
    study: Study,
    fine: Problem,
    heldout: Errors | None,
    runs: list[Run],
    experiment: next_runs.Proposal | None,
    without: frozenset[str],
) -> Verdict:
    """The content of `diagnosis.json`; `fine` is the problem at the recording's own rate."""
    problem = study.problem
    unit = problem.system.channel.rpartition("_")[2]
    bands = intervals(problem, study.state, study.noise).at_least(study.spreads)
    named = study.verdict in ("explained", "ambiguous")
    mismatch: dict[str, Any] | None = None
    pattern: dict[str, Any] | None = None
    if study.verdict != "consistent":
        signal, driver = mismatch_signal(study)
        if study.verdict == "parameters":
            pattern = {"location": locate.box(signal, problem), "driver": driver}
            signal = problem.simulate(study.base) - problem.simulate(study.nominal)
            driver = ["the dimensions themselves"]
        elif named and not study.random:
            rest, follows = systematic(study, study.state)
            pattern = {"location": locate.box(rest, problem), "driver": follows, f"rms_{unit}": rms(rest)}
            pattern["half"] = locate.box(rest, problem, 0.5)
        place = locate.box(signal, problem)
        mismatch = {f"rms_{unit}": study.mismatch, "location": place, "driver": driver}
    by_name = {parameter.name: parameter for parameter in problem.parameters}
    fit: dict[str, Any] = {f"noise_floor_{unit}": told_fine_floor(fine_floor(fine, study), fine, study)}
    fit[f"detectable_{unit}"] = detectable(study.search, study.noise.floor)
    fit["heldout"] = (
        {
            "split": heldout["split"],
            **({"runs": [runs[at].run for at in runs_of(problem.record, heldout["until_s"])]} if runs[1:] else {}),
            **{f"{name}_{unit}": heldout[name] for name in HELD_OUT if name in heldout},
        }
        if heldout
        else None
    )
    if heldout and (worse := worse_than_nominal(heldout)):
        fit["worse_than_nominal"] = worse
    if not problem.system.free_zero:
        fit["relative_residual"] = relative(study)
    content: dict[str, Any] = {
        "run": runs[0].run,
        "verdict": study.verdict,
        "mismatch": mismatch,
        "mechanisms": listed(study, fine, bands, unit) if named else [],
        "alternatives": [list(other.ids) for other in study.sets[1:]] if study.verdict == "ambiguous" else [],
        "next_experiment": None,
        "next_run": experiment.entry(runs[0], float(np.ptp(problem.record.load)) == 0.0) if experiment else None,
        "parameters": {
            name: {"nominal": by_name[name].nominal, **as_entry(interval)}
            for name, interval in bands.parameters.items()
        },
        "fit": fit,
        "simulation": entries(tuple(sorted(study.state.acts, key=problem.beside.count)), problem.drivers),
        "code": fingerprint("pipeline.diagnose", "pipeline.diagnosis.*", "pipeline.systems.*"),
    }
    content["evidence"] = evidence(study) | ({"pattern": pattern} if pattern else {})
    if heldout:
        content["evidence"]["chosen_without_them"] = heldout["chosen"]
        if heldout["closest"]:
            content["evidence"]["closest_without_them"] = heldout["closest"]
        if "decided" in heldout:
            content["evidence"]["likely_without_them"] = heldout["decided"]
        content["evidence"]["beyond_seen"] = beyond_seen(problem.record, heldout["until_s"])
    if heldout and "left" in heldout:
        content["evidence"]["left_of_unseen"] = heldout["left"]
    for name, which in at_bound(content["evidence"]["moved_sigma"]).items():
        content["parameters"][name]["at_bound"] = which
    content |= {"beside": stand_ins(study, unit)} if problem.beside else {}
    content |= {"without": sorted(without)} if without else {}
    if study.verdict == "unknown" and own_alone(study):
        own = {"mechanisms": listed(study, fine, intervals(problem, study.best, study.noise), unit)}
        content["of_your_own"] = own | {"simulation": entries(study.best.acts, problem.drivers)}
    tidied: Verdict = cast(Verdict, tidy(content))  # numbers alone were rounded
    tidied |= {"simulation": content["simulation"], "uncertainty": doubts(problem, study.state, bands.covariance, unit)}
    if study.closest:
        tidied["closest"] = named_simulator(problem, study.closest, list(study.best_ids), unit)
    if study.verdict == "ambiguous":
        tidied["rivals"] = rivals(study, unit)
    for name, interval in bands.parameters.items():
        tidied["parameters"][name]["value"] = float(f"{interval.value:.{DIGITS + 1}g}")
    tidied["parameters"] |= zero_entries(problem, bands, unit)
    return spoken(without_zero_effects(tidied, unit), problem.system)
