"""The improved simulator alone: inputs and a diagnosis → predicted displacement; no measurement but for the tare."""

import json
import math
import re
from pathlib import Path
from typing import Any, cast

import numpy as np
import pandas as pd

from ...ground.errors import BadInput
from ...ground.input.complaint import short
from ...ground.kinematics import Array
from ...ground.stored.regular_file import read_regular
from ...run.description import Fitted, Run
from ...systems import System
from ..choice.outcome import rms
from ..document.content import Simulated, Verdict
from ..document.effects_named import Dimension
from ..fit.adopt import acts_from, is_number
from ..fit.problem import Problem, State
from ..recording.working_samples import averaged, despiked, means, wild

TARE_S = 1.0
LARGEST_DIAGNOSIS = 100_000_000  # bytes


def state_of(content: Simulated, problem: Problem, path: Path, run: str) -> State:
    """The simulator that a diagnosis describes; its zero is left at 0 when the diagnosis has none."""
    values = [value_of(content, parameter.name, path, parameter.nominal) for parameter in problem.parameters]
    together = content.get("run")
    if isinstance(together, list) and run in together[1:] and problem.runs == 1:  # the zero of its motor is its own
        names = [parameter.name for parameter in problem.parameters]
        own = f"{problem.system.homed}_{together.index(run) + 1}"
        if problem.system.homed and own in content["parameters"]:
            values[names.index(problem.system.homed)] += value_of(content, own, path, 0.0)
    acts = acts_from(content["simulation"], problem.drivers, str(path))
    return State(np.array(values), np.zeros(problem.runs), acts)


def value_of(content: Simulated, name: str, path: Path, otherwise: float) -> float:
    """Value of a parameter in a diagnosis; raises BadInput when it is no number."""
    entry = content["parameters"].get(name, {"value": otherwise})
    value: Any = entry.get("value") if isinstance(entry, dict) else None
    if not is_number(value):
        problem = f"is {short(entry)}, without a value"
        raise BadInput(path, f"parameters.{name}", problem, "give a diagnosis.json as it was made")
    return float(value)


def read_diagnosis(path: Path) -> Verdict:
    """Content of a `diagnosis.json`; raises BadInput for anything else."""
    try:
        content = json.loads(read_regular(path, LARGEST_DIAGNOSIS))
    except (ValueError, RecursionError) as error:
        raise BadInput(path, "file", f"cannot be read ({short(str(error))})", "give a diagnosis.json") from None
    for field, kind in (("parameters", dict), ("simulation", list)):
        if not isinstance(content, dict) or not isinstance(content.get(field), kind):
            raise BadInput(path, field, "is missing or is not what a diagnosis gives", "give a diagnosis.json")
    closest = content.get("closest") or {"parameters": {}, "simulation": [], "ids": []}
    parts = [closest.get(key) for key in ("parameters", "simulation", "ids")] if isinstance(closest, dict) else []
    if [type(part) for part in parts] != [dict, list, list]:
        raise BadInput(path, "closest", f"is {short(closest)}, no simulator", "give a diagnosis.json as it was made")
    together = content.get("run", "")
    if not isinstance(together, str) and not (isinstance(together, list) and together):
        raise BadInput(path, "run", f"is {short(together)}, no run and no list of runs", "give a diagnosis.json")
    return cast(Verdict, content)


def of_run(run: Run) -> Simulated:
    """What a run's own `run.yaml` simulates, in the form of a diagnosis: the adopted effects and dimensions.

    Dimensions are those of run.yaml where none were adopted, or where one has been measured again since.
    """
    adopted_parameters: dict[str, Dimension] = (
        {} if measured_since(run) else {name: {"value": dimension.fitted} for name, dimension in _adopted(run).items()}
    )
    content: Simulated = {"run": run.run, "parameters": adopted_parameters, "simulation": run.simulation}
    acting = {entry["id"] for entry in run.simulation}
    against = [each.against_advice[0] for each in run.adopted if each.against_advice and acting & set(each.effects)]
    return content | {"against_advice": against} if against else content


def measured_since(run: Run) -> list[str]:
    """The dimensions that run.yaml gives another value than it had when effects were adopted."""
    now = {parameter.name: parameter.nominal for parameter in run.system.parameters(run)}
    then = _adopted(run)
    return [name for name in now if name in then and not math.isclose(now[name], then[name].nominal, rel_tol=1e-4)]


def _adopted(run: Run) -> dict[str, Fitted]:
    """The dimensions that were adopted last; nothing where run.yaml has no effects, or none that brought dimensions.

    The zero of a reading stays with the recording that it was fitted to. That of a later run of several keeps its
    number, for it is known beside what the runs before it left behind. The motor's zeros of these stay out.
    """
    with_some = [adopted for adopted in run.adopted if adopted.dimensions]
    if not with_some or not run.simulation:
        return {}
    runs, dimensions = with_some[-1].runs or [], with_some[-1].dimensions or {}
    number = runs.index(run.run) + 1 if run.run in runs else 0
    kept = {name: fitted for name, fitted in dimensions.items() if not re.match("zero|.*_[0-9]+$", name)}
    own = "zero_" if len(runs) == number == 1 else f"zero_{number}_"
    zeros = {name: fitted for name, fitted in dimensions.items() if number and name.startswith(own)}
    return kept | {name.replace("zero_1_", "zero_"): fitted for name, fitted in zeros.items()}


def has_zero(content: Simulated, system: System, run: str, runs: int = 1) -> bool:
    """Whether a diagnosis, or what a run has adopted, holds the zero of this run's reading."""
    return zero_name(content, system, run, runs) in content["parameters"]


def zero_name(content: Simulated, system: System, run: str, runs: int = 1) -> str:
    """The name of the zero of a run's reading; `runs` are simulated up to it. Empty where no zero is known.

    That of a later run of several is known beside what those before it left behind, so with all of these alone.
    """
    together, unit = content.get("run"), system.channel.rpartition("_")[2]
    if together == run:
        return f"zero_{unit}"
    number = together.index(run) + 1 if isinstance(together, list) and run in together else 0
    return f"zero_{number}_{unit}" if number == runs else ""


def simulated(problem: Problem, content: Simulated, path: Path, run: str) -> Array:
    """The simulation of a run by a diagnosis; raises BadInput where a sample of it is not a number.

    Shape (samples,), in the channel's unit.
    """
    state = state_of(content, problem, path, run)
    try:
        with np.errstate(all="ignore"):
            predicted = problem.simulate(state)
    except (ArithmeticError, LookupError, ValueError) as error:
        reason, predicted = f" ({type(error).__name__}: {short(str(error))})", np.full(1, np.nan)
    else:
        reason = ""
    if not np.isfinite(predicted).all():
        field = "simulation" if state.acts else "parameters"
        raise BadInput(path, field, f"gives no number at some samples{reason}", "give a diagnosis.json as it was made")
    return predicted


def tare(predicted: Array, measured: Array, time_s: Array) -> float:
    """What to add so that prediction and measurement agree on the first second.

    Both of shape (samples,) in the channel's unit, as the answer; time in s.
    """
    start = time_s - time_s[0] <= TARE_S
    return float(np.median((measured - predicted)[start]))


def tared(problem: Problem, content: Simulated, path: Path, run: str) -> Array:
    """The simulation of a run by a diagnosis, with the zero of its reading; raises BadInput as `simulated` does.

    Of several runs the zero is that of the last, which is the run's. Shape (samples,), in the channel's unit.
    """
    predicted = simulated(problem, content, path, run)
    name = zero_name(content, problem.system, run, problem.runs)
    if name in content["parameters"]:
        return predicted + value_of(content, name, path, 0.0)
    if not problem.system.free_zero:
        return predicted
    own = problem.record.run_index == problem.runs - 1
    return predicted + tare(predicted[own], problem.measured[own], problem.record.time_s[own])


def at_its_best_zero(problem: Problem, content: Simulated, path: Path, run: str) -> Array:
    """The simulation of a run by a diagnosis, with the zero that fits its reading best; raises BadInput as `simulated`.

    Shape (samples,), in the channel's unit.
    """
    predicted = simulated(problem, content, path, run)
    return predicted + float(np.median(problem.measured - predicted)) if problem.system.free_zero else predicted


def off(measured: Array, predicted: Array) -> tuple[float, float]:
    """The rms error of a prediction, lonely wild readings left out: as it is, and about its median.

    The median is the zero that a verdict gives the nominal simulator. Both given have the
    shape (samples,); they and both numbers that it gives are in the channel's unit.
    """
    residual = measured - predicted
    residual = residual[~wild(residual)[0]]
    return rms(residual), rms(residual - np.median(residual))


def compared(run: Run, problem: Problem, predicted: Array) -> tuple[Array, Array]:
    """Measured and predicted in the form in which a diagnosis compares them: means, where derivatives are followed.

    What is predicted is predicted at the recording's own rate: between means, a jump of a force would be a ramp. Both
    of shape (working samples,), in the channel's unit.
    """
    time_s = problem.record.time_s
    width = averaged(run.system, pd.DataFrame({"time_s": time_s})) if run.system.differentiates else 1
    if width == 1:
        return problem.measured, predicted
    return means(time_s, despiked(problem.measured), width), means(time_s, predicted, width)
