"""How far the simulator of a run is off its recording before and after it adopts a diagnosis, in words."""

from pathlib import Path
from typing import Any

from pipeline.diagnosis.problem import Problem
from pipeline.diagnosis.words.quantity import size
from pipeline.simulate import off, tared

WHY = (
    "The effects were fitted together with the calibrated dimensions, but run.yaml keeps the dimensions as measured. "
    "So it may err by more than the verdict says. Do not copy calibrated values into run.yaml: measure again the "
    "dimensions that the verdict names, and write what you measured."
)
NEXT = "The next pipeline.diagnose calibrates the dimensions anew, with these effects in the simulator."


def is_of(content: dict[str, Any], run: str) -> bool:
    """Whether a diagnosis is of a run; one that names none is taken to be."""
    of = content.get("run", run)
    return run in (of if isinstance(of, list) else [of])


def told(problem: Problem, run: str, before: list[Any], content: dict[str, Any], path: Path) -> list[str]:
    """What `pipeline.simulate` errs by on a run's own recording: before, from now on, and with the diagnosis itself.

    `problem` is the run's without any effect, `before` what its run.yaml had adopted. Raises BadInput.
    """
    unit = problem.drivers.units.reading
    plain: dict[str, Any] = {"run": run, "parameters": {}}
    (old, old_fitted), (new, new_fitted) = (
        off(problem, tared(problem, {**plain, "simulation": acts}, path, run))
        for acts in (before, content["simulation"])
    )
    zero = ", its zero set in the first second," if problem.system.free_zero else ""
    now = f"{size(new, unit)} rms now; before, {size(old, unit)}"
    lines = [f"on this recording{zero} pipeline.simulate RUN_DIR errs by {now}"]
    if problem.system.free_zero:
        fitted = f"{size(new_fitted, unit)} rms now; before, {size(old_fitted, unit)}"
        lines.append(
            f"a verdict fits the zero instead: with its zero fitted to the whole recording it errs by {fitted}"
        )
    if content["parameters"] and is_of(content, run):
        whole, _ = off(problem, tared(problem, content, path, run))
        lines.append(
            f"with --simulation {path} it errs by {size(whole, unit)}: that takes the calibrated dimensions too"
        )
    return lines
