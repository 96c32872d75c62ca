"""A diagnosis from beginning to end, in memory: runs and their samples → what `diagnosis.json` says, and the study."""

import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import pandas as pd

from ..ground.errors import BadInput
from ..run.description import Run
from . import engine, faint, heldout, own_rate, verdict
from .content import Adoption, Verdict
from .judge import Judge
from .outcome import Study, rms
from .simulation import at_its_best_zero, of_run

Result = TypeVar("Result")
Say = Callable[[str], None]


def diagnosed(
    runs: list[Run],
    tables: list[pd.DataFrame],
    folders: list[Path],
    without: frozenset[str] = frozenset(),
    by: Judge | None = None,
    say: Say = lambda _: None,
) -> tuple[Verdict, Study]:
    """Diagnose one run, or several of one rig together: the content of `diagnosis.json`, and what it was made from.

    `tables` holds each run's checked samples, `folders` where each lies or would lie, for what is said of it. The
    library lacks the mechanisms in `without`; `by` judges in place of the library's own judge; `say` is told each step.
    Raises BadInput for runs that are not of one rig, and for recordings too poor to decide anything.
    """
    of_one_rig(runs, tables, folders)
    name = "+".join(folder.name for folder in folders)
    problem = engine.make_problem(runs, tables, folders, without=without, by=by)
    fine = own_rate.to_score(runs, tables)
    to_polish = own_rate.to_polish(runs, tables, fine)
    say("held out")  # first: a study is large, and this one is let go before the other begins
    held = optional("the strokes held out", name, lambda: heldout.held_out(problem, fine, to_polish)[0])
    study = engine.study(problem, say)
    faint.refuse_faint(study, folders[0])
    study = engine.polished(study, to_polish)
    say("writing")
    experiment = optional("the next experiment", name, lambda: verdict.next_experiment(study, runs[0]))
    content = verdict.diagnosis(study, fine, held, runs, experiment, without)
    earlier = [cast(Adoption, adoption.model_dump(exclude_none=True)) for run in runs for adoption in run.adopted]
    if earlier:
        content["adopted"] = [adoption for place, adoption in enumerate(earlier) if adoption not in earlier[:place]]
    content["evidence"] |= of_run_yaml(study, runs)
    return content, study


def of_run_yaml(study: Study, runs: list[Run]) -> dict[str, Any]:
    """What the words must know of run.yaml beside its dimensions, for the `evidence`.

    The tolerances and the sensor's scale that it gives, and by how much a run errs with the effects and dimensions that
    it has adopted: rms in the channel's unit, with the zero of the reading at its best.
    """
    problem, channel = study.problem, runs[0].system.channel
    known: dict[str, Any] = {"tolerances_given": sorted(runs[0].tolerance)}
    scale = runs[0].channels[channel].scale if channel in runs[0].channels else 1.0
    if scale != 1.0:
        known["scale_given"] = scale
    adopted = of_run(runs[0])
    if len(runs) == 1 and adopted["parameters"]:
        predicted = at_its_best_zero(problem, adopted, Path("run.yaml"), runs[0].run)
        known[f"adopted_{channel.rpartition('_')[2]}"] = rms(problem.measured - predicted)
    return known


def of_one_rig(runs: list[Run], tables: list[pd.DataFrame], folders: list[Path]) -> None:
    """Raise BadInput unless all runs are of one string on one rig, with the same channels."""
    for run, folder in zip(runs, folders, strict=True):
        if run.actuator != runs[0].actuator:
            raise BadInput(folder, "actuator", f"is {run.actuator}, not {runs[0].actuator}", "diagnose them apart")
        for field in ("rig", "string", "tolerance", "simulation"):
            if described(run, field) != described(runs[0], field):
                mend = "diagnose the runs of each string on each rig apart"
                raise BadInput(folder, field, f"is not that of {runs[0].run}", mend)
    load = runs[0].system.load
    for folder, table in zip(folders, tables, strict=True):
        if load and (load in table) != (load in tables[0]):
            mend = "diagnose runs with and without it apart"
            raise BadInput(folder, load, f"is in {'it' if load in table else folders[0]} only", mend)


def described(run: Run, field: str) -> Any:
    """What `run.yaml` says of a thing that runs of one rig must share: not load, strokes before and id."""
    value = getattr(run, field)
    if field == "rig":
        return {key: entry for key, entry in value.items() if key != "load_n"}
    return value.model_copy(update={"strokes_before": 0, "id": None}) if field == "string" and value else value


def optional(step: str, name: str, work: Callable[[], Result]) -> Result | None:
    """What a step gives without which the verdict still stands; its failure is shown in full, and gives None."""
    try:
        return work()
    except Exception:
        print(f"warning: {name}: {step} failed; the verdict stands without it:", file=sys.stderr)
        traceback.print_exc()
        return None
