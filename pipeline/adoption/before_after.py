"""How far the simulator of a run is off its recording before and after it adopts a diagnosis, in words."""

from pathlib import Path
from typing import Any

from ..diagnosis.adopt import is_number
from ..diagnosis.problem import Problem
from ..diagnosis.simulation import off, tared
from ..diagnosis.words.dimensions import LEAVES, name_of
from ..diagnosis.words.error_table import aligned
from ..diagnosis.words.quantity import listing, percent, size, times
from ..diagnosis.words.rivals import called
from ..ground.command import program_name

WHY = (
    "Adopted were the effects alone, not the dimensions: run.yaml keeps those as measured. The effects were fitted "
    "together with the calibrated dimensions, so the simulator may err by more than the verdict says."
)
NEXT = (
    f"The next {program_name('diagnose')} calibrates the dimensions anew, with these effects in the simulator. Give it "
    "another --out: in the same folder the verdict that was adopted is replaced."
)
WORSE = 2.0  # times the error with the dimensions of the verdict: more is no simulator to predict with
CALIBRATED = "now, calibrated"
FAR, MOST = 1.0, 8  # sigma from which a dimension is measured again; dimensions that are named


def why(content: dict[str, Any]) -> str:
    """Why the simulator may err by more than the verdict says, and which dimensions to measure again, by name."""
    moved = moved_by(content, FAR)
    if not moved:
        return WHY
    return f"{WHY} Calibration moved {moved}: measure again, and write what you measured, not the calibrated values."


def waits(content: dict[str, Any]) -> str:
    """Why a diagnosis is not to be adopted yet: the dimensions that calibration moved far; nothing where it may."""
    moved = moved_by(content, LEAVES)
    return f"the verdict says not to adopt yet: calibration moved {moved}" if moved else ""


def moved_by(content: dict[str, Any], least: float) -> str:
    """The dimensions that calibration moved by at least so many tolerances, the farthest first, in words."""
    evidence = content.get("evidence")
    sigmas = evidence.get("moved_sigma") if isinstance(evidence, dict) else None
    found = sigmas.items() if isinstance(sigmas, dict) else []
    far = {name: abs(sigma) for name, sigma in found if is_number(sigma) and abs(sigma) >= least}
    named = sorted(far, key=lambda name: -far[name])[:MOST]
    return listing([f"the {name_of(name)} ({times(far[name])} times its tolerance)" for name in named])


def probable(ids: list[str], content: dict[str, Any]) -> str:
    """An explanation by its name, with its probability where the diagnosis holds one."""
    evidence = content.get("evidence")
    shown = evidence.get("explanations") if isinstance(evidence, dict) else None
    for one in shown if isinstance(shown, list) else []:
        if isinstance(one, dict) and one.get("ids") == ids and is_number(one.get("probability")):
            return f"{called(ids)} ({percent(one['probability'])})"
    return called(ids)


def is_of(content: dict[str, Any], run: str) -> bool:
    """Whether a diagnosis is of a run; one that names none is taken to be."""
    of = content.get("run", run)
    return run in (of if isinstance(of, list) else [of])


def told(
    problem: Problem, run: str, before: list[Any], content: dict[str, Any], path: Path, remove: str = ""
) -> list[str]:
    """What `pipeline.simulate` errs by on a run's own recording: before, from now on, and with the diagnosis itself.

    `problem` is the run's without any effect, `before` what its run.yaml had adopted, `remove` the command that takes
    all of it out, which stands below a warning. Raises BadInput.
    """
    unit = problem.drivers.units.reading
    plain: dict[str, Any] = {"run": run, "parameters": {}}
    columns = {"before": {**plain, "simulation": before}, "now": {**plain, "simulation": content["simulation"]}}
    if content["parameters"] and is_of(content, run):
        columns[CALIBRATED] = content
    errors = [off(problem.measured, tared(problem, one, path, run)) for one in columns.values()]
    rows = [["error on this recording, rms of single samples", *columns]]
    if problem.system.free_zero:
        rows.append([f"zero set in the first second, as {program_name('simulate')} does"])
        rows.append(["zero fitted to the whole recording, as in a verdict"])
    else:
        rows.append([f"as {program_name('simulate')} RUN_DIR errs"])
    for row, found in zip(rows[1:], zip(*errors, strict=True), strict=False):
        row += [size(error, unit) for error in found]
    said = aligned(rows)
    if CALIBRATED not in columns:
        return said
    said.append(
        f"{CALIBRATED}: with the dimensions of the verdict too, as by {program_name('simulate')} --simulation {path}"
    )
    warned = distrust(errors[1][0], errors[2][0], path, unit)
    return [*warned, *([remove] if warned and remove else []), *said]


def distrust(now: float, calibrated: float, path: Path, unit: str) -> list[str]:
    """That nobody should predict with the adopted simulator where it errs far more than the verdict at `path`."""
    if now <= WORSE * calibrated:
        return []
    return [
        f"Beware: do not predict with run.yaml as it is now: it errs by {size(now, unit)}, with the dimensions of the "
        f"verdict by {size(calibrated, unit)}. Measure the dimensions again. If a value changes: write it into "
        "run.yaml, take the effects out, diagnose again and adopt anew. If none changes: take the effects out, and "
        f"predict with {program_name('simulate')} --simulation {path}"
    ]
