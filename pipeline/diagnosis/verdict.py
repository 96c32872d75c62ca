"""Everything found, as the content of `diagnosis.json`."""

from typing import Any

import numpy as np

from pipeline.diagnosis import chance, generic, locate, nextrun, protocol
from pipeline.diagnosis.adopt import entries
from pipeline.diagnosis.detectable import detectable
from pipeline.diagnosis.engine import fine_floor
from pipeline.diagnosis.intervals import Interval, intervals
from pipeline.diagnosis.library import mechanisms
from pipeline.diagnosis.linear import Linear
from pipeline.diagnosis.noise import white
from pipeline.diagnosis.outcome import Study, physics, rms
from pipeline.diagnosis.problem import Act, Problem, State
from pipeline.fingerprint import fingerprint
from pipeline.kinematics import Array
from pipeline.run_yaml import Run

DIGITS = 5  # more of them would be rounding, which processors do each in their own way
RANDOM_ENDS = (0.85, 1.15)  # of the size of a random effect, which is what fits and floor leave


def tidy(value: Any) -> Any:
    """A JSON value with its numbers rounded to five digits, so that it reads well and repeats exactly."""
    if isinstance(value, dict):
        return {key: tidy(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [tidy(entry) for entry in value]
    if isinstance(value, float | np.floating):
        return float(f"{value:.{DIGITS}g}") + 0.0 if np.isfinite(value) else None
    return int(value) if isinstance(value, np.integer) else value


def mismatch_signal(found: Study) -> tuple[Array, str]:
    """The mismatch without its noise, and the driver it follows: by the best explanation, or by the dictionary."""
    problem = found.problem
    before = problem.simulate(found.base)
    if found.verdict in ("explained", "ambiguous") or (found.sets and not physics(found.sets[0].ids)):
        driver = " and ".join(mechanisms()[id_].driver for id_ in found.sets[0].ids)
        signal = problem.simulate(found.best) - before
        if found.random:
            signal = np.hypot(signal, chance.trace(problem, found.best, found.floor))
        return signal, driver
    columns = generic.groups(problem.drivers)
    linear = Linear(problem, found.base, white(found.floor), {}, np.vstack(list(columns.values())))
    table, target = linear.table[:-1], (problem.measured - before)[: problem.rows]
    whole = np.concatenate([linear.calibration, linear.extra])
    known = table[linear.calibration]
    left: dict[str, float] = {}
    at = len(linear.calibration)
    for name, group in columns.items():
        part = np.vstack([known, table[at : at + len(group)]])
        at += len(group)
        solution = np.linalg.lstsq(part.T, target, rcond=1e-8)[0]
        left[name] = float(np.mean(np.square(target - part.T @ solution)))
    solution = np.linalg.lstsq(table[whole].T, target, rcond=1e-8)[0]
    return np.asarray(table[whole].T @ solution), min(left, key=lambda name: left[name])


def _interval(found: Interval) -> dict[str, float]:
    return {"value": found.value, "low": found.low, "high": found.high}


def _effect(problem: Problem, state: State, act: Act) -> Array:
    """The prediction with an act less the prediction without it, all else held."""
    rest = State(state.values, state.zeros, tuple(other for other in state.acts if other is not act))
    return problem.simulate(state) - problem.simulate(rest)


def _mechanisms(
    found: Study, fine: Problem, sizes: dict[str, Interval], shapes: dict[tuple[str, int, str], float], unit: str
) -> list[dict[str, Any]]:
    problem, listed = found.problem, []
    for act in found.best.acts:
        if act in problem.included:
            continue
        mechanism = mechanisms()[act.id]
        effect = _effect(problem, found.best, act)
        if act.id in found.random:
            effect = chance.trace(problem, found.best, found.floor)
            size = Interval(*(found.random_rms * end for end in (1.0, *RANDOM_ENDS)))
        else:
            own_rate = rms(_effect(fine, found.best, act)) / (rms(effect) or 1.0)
            size = Interval(*(own_rate * end for end in (sizes[act.id].value, sizes[act.id].low, sizes[act.id].high)))
        parameters: dict[str, dict[str, Any]] = {}
        relative = (size.low / size.value, size.high / size.value) if size.value else (1.0, 1.0)
        for number, entry in enumerate(entries((act,), problem.drivers)):
            units = {term.name: term.unit for term in problem.terms(mechanism, act.shapes[number])}
            for name, value in entry["parameters"].items():
                label = name if number == 0 else f"{name}_{number + 1}"
                half = shapes.get((act.id, number, name), 0.0)  # none where it was chosen from a few
                factors = relative if name in units else (1.0 - half, 1.0 + half)
                ends = sorted(value * factor for factor in factors)
                parameters[label] = {
                    "value": value,
                    "low": ends[0],
                    "high": ends[1],
                    "unit": units.get(name, _unit(name)),
                }
        listed.append(
            {
                "id": act.id,
                "confidence": confidence(found),
                f"rms_{unit}": _interval(size),
                "parameters": parameters,
                "location": locate.box(effect, problem.drivers),
                "sentence": mechanism.sentence.format(size=f"{size.value:.3g} {unit} rms"),
            }
        )
    return listed


def _unit(name: str) -> str:
    endings = {"_s": "s", "_mm": "mm", "_turns": "turns", "_hz": "Hz"}
    return next((unit for ending, unit in endings.items() if name.endswith(ending)), "1")


def confidence(found: Study) -> float:
    """How far the data carry the name: the explained share, divided among what ties."""
    return float(np.clip(found.share, 0.0, 1.0) / max(len(found.sets), 1))


def next_experiment(found: Study, run: Run) -> nextrun.Proposal | None:
    """What to record next, in words and as legs."""
    if found.verdict == "unknown":
        return nextrun.after_unknown(found.problem, run, mismatch_signal(found)[1])
    if found.verdict != "ambiguous":
        return None
    return nextrun.best(found.problem, run, found.noise, found.search, found.sets)


def diagnosis(
    found: Study, fine: Problem, heldout: dict[str, Any] | None, runs: list[Run], experiment: nextrun.Proposal | None
) -> dict[str, Any]:
    """The content of `diagnosis.json`; `fine` is the problem at the recording's own rate."""
    problem = found.problem
    unit = problem.system.channel.rpartition("_")[2]
    parameters, sizes, shapes = intervals(problem, found.state, found.noise)
    named = found.verdict in ("explained", "ambiguous")
    mismatch = None
    if found.verdict != "consistent":
        signal, driver = mismatch_signal(found)
        if found.verdict == "parameters":
            signal = problem.simulate(found.base) - problem.simulate(found.nominal)
            driver = "the dimensions themselves"
        mismatch = {f"rms_{unit}": found.mismatch, "location": locate.box(signal, problem.drivers), "driver": driver}
    by_name = {parameter.name: parameter for parameter in problem.parameters}
    fit: dict[str, Any] = {f"noise_floor_{unit}": fine_floor(fine, found)}
    fit[f"detectable_{unit}"] = detectable(found.search, found.noise.floor)
    fit["heldout"] = (
        {
            "split": heldout["split"],
            **{f"{name}_{unit}": heldout[name] for name in ("nominal", "calibrated", "explained")},
        }
        if heldout
        else None
    )
    zeros = {
        "zero" if problem.runs == 1 else f"zero_{number + 1}": float(zero)
        for number, zero in enumerate(found.state.zeros)
    }
    content: dict[str, Any] = {
        "run": runs[0].run,
        "verdict": found.verdict,
        "mismatch": mismatch,
        "mechanisms": _mechanisms(found, fine, sizes, shapes, unit) if named else [],
        "alternatives": [list(other.ids) for other in found.sets[1:]] if found.verdict == "ambiguous" else [],
        "next_experiment": experiment[0] if experiment else None,
        "next_run": protocol.as_legs(experiment[1], runs[0]) if experiment else None,
        "parameters": {
            name: {"nominal": by_name[name].nominal, **_interval(interval)} for name, interval in parameters.items()
        }
        | {f"{name}_{unit}": {"nominal": 0.0, "value": v, "low": v, "high": v} for name, v in zeros.items()},
        "fit": fit,
        "simulation": entries(found.state.acts, problem.drivers),
        "code": fingerprint("pipeline.diagnose", "pipeline.diagnosis.*"),
    }
    if problem.without:
        content["without"] = sorted(problem.without)
    tidied: dict[str, Any] = tidy(content)
    tidied["simulation"] = content["simulation"]
    for name, interval in parameters.items():
        tidied["parameters"][name]["value"] = float(f"{interval.value:.{DIGITS + 1}g}")
    return tidied
