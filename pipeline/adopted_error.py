"""How far the simulator of a run is off its recording before and after it adopts a diagnosis, in words."""

from pathlib import Path
from typing import Any

import numpy as np

from pipeline.diagnosis.problem import Problem
from pipeline.diagnosis.record import wild
from pipeline.diagnosis.words.quantity import size
from pipeline.simulate import tared

WHY = (
    "The effects were fitted together with the calibrated dimensions, but run.yaml keeps the dimensions as measured. "
    "So it may err by more than the verdict says. Measure again the dimensions that the verdict names, and write them "
    "into run.yaml."
)
NEXT = "The next pipeline.diagnose calibrates the dimensions anew, with these effects in the simulator."


def off(problem: Problem, content: dict[str, Any], path: Path, run: str) -> float:
    """How far what a diagnosis simulates is off a run's recording, rms, lonely wild readings left out."""
    residual = problem.measured - tared(problem, content, path, run)
    return float(np.sqrt(np.mean(np.square(residual[~wild(residual)[0]]))))


def told(problem: Problem, run: str, before: list[Any], content: dict[str, Any], path: Path) -> list[str]:
    """What `pipeline.simulate` errs by on a run's own recording: before, from now on, and with the diagnosis itself.

    `problem` is the run's without any effect, `before` what its run.yaml had adopted. Raises BadInput.
    """
    unit = problem.drivers.units.reading
    plain: dict[str, Any] = {"run": run, "parameters": {}}
    old, new = (off(problem, {**plain, "simulation": acts}, path, run) for acts in (before, content["simulation"]))
    lines = [
        f"on this recording, its zero set in the first second, pipeline.simulate RUN_DIR errs by {size(new, unit)} rms "
        f"now; before, {size(old, unit)}"
    ]
    of = content.get("run", run)
    if content["parameters"] and run in (of if isinstance(of, list) else [of]):
        whole = off(problem, content, path, run)
        lines.append(
            f"with --simulation {path} it errs by {size(whole, unit)}: that takes the calibrated dimensions too"
        )
    return lines
