"""The simulator that had not seen the last strokes, as `diagnosis.json` holds it; it tests what is learnt from it."""

from pathlib import Path
from typing import Any

import numpy as np
from pydantic import NonNegativeFloat

from ...ground.errors import BadInput
from ..document.content import Simulated, Unseen, Verdict
from ..document.form import Form, formed
from ..fit.problem import Problem
from ..study.heldout import Errors
from ..study.rivals import as_simulator

KEY = "without_last_strokes"


class _Read(Form):
    seen_s: list[NonNegativeFloat]
    parameters: dict[str, Any]
    simulation: list[Any]  # each is checked where it acts


def written(problem: Problem, errors: Errors) -> Unseen:
    """The simulator of the strokes before, and how much of each run it has seen, in s."""
    parameters, simulation = as_simulator(problem, errors["state"], problem.system.channel.rpartition("_")[2])
    record = problem.record
    starts_s = [float(record.time_s[np.argmax(record.run_index == run)]) for run in range(problem.runs)]
    seen_s = [float(f"{max(errors['until_s'] - start_s, 0.0):.9g}") for start_s in starts_s]
    return {"seen_s": seen_s, "parameters": parameters, "simulation": simulation}


def read(content: Verdict, runs: list[str], path: Path, mend: str) -> tuple[Simulated, dict[str, float]]:
    """The simulator that a diagnosis found without the last strokes, and how much of each run it saw, in s.

    Raises BadInput where the diagnosis has none, with `mend`, or where it is none.
    """
    earlier_simulator = content.get(KEY)
    if earlier_simulator is None:
        problem = "is not in it: an earlier program wrote it, or the recording has too few strokes to hold any back"
        raise BadInput(path, KEY, problem, mend)
    form = formed(_Read, earlier_simulator, path, mend, KEY)
    if len(form.seen_s) != len(runs):
        raise BadInput(path, f"{KEY}.seen_s", f"holds {len(form.seen_s)} numbers for {len(runs)} runs", mend)
    simulator: Simulated = {
        "run": content.get("run", ""), "parameters": form.parameters, "simulation": form.simulation,
    }  # fmt: skip
    return simulator, dict(zip(runs, form.seen_s, strict=True))
