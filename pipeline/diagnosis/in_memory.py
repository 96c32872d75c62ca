"""A diagnosis from beginning to end, in memory: runs and their samples → what `diagnosis.json` says, and the study."""

import math
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar, cast

from ..run.description import Run
from . import faint_recordings, verdict
from .adoption.adopted_effects import adopted_effects
from .choice.outcome import Study, rms
from .document.content import Adoption, Verdict
from .document.evidence import Evidence
from .document.made_keys import amount, amount_or_none, put
from .document.rounded import tidy
from .facts.beyond_seen import beyond_seen
from .facts.not_kept import not_kept
from .facts.told_floor import told_floor
from .numerics.judge import Judge
from .numerics.noise import resolution
from .one_rig import of_one_rig
from .prediction import without_last
from .prediction.simulation import at_its_best_zero, of_run
from .proposal import apart, expected
from .recording.covered import paces, pauses, reversals
from .recording.recorded_run import RecordedRun
from .recording.spikes_found import spikes_found
from .study import engine, heldout, own_rate, polish
from .study.single_floor import single_floor

Result = TypeVar("Result")
Say = Callable[[str], None]


def diagnosed(
    recorded: list[RecordedRun],
    without: frozenset[str] = frozenset(),
    by: Judge | None = None,
    say: Say = lambda _: None,
) -> tuple[Verdict, Study]:
    """Diagnose one run, or several runs of one rig together: the content of `diagnosis.json`, and its study.

    The library lacks the mechanisms in `without`; `by` judges in place of the library's own judge; `say` is told each
    step. Raises BadInput for runs that are not of one rig, and for recordings too poor to decide anything.
    """
    of_one_rig(recorded)
    runs, name = [each.run for each in recorded], "+".join(each.place.name for each in recorded)
    problem = engine.make_problem(recorded, without=without, by=by)
    fine = own_rate.to_score(recorded)
    to_polish = own_rate.to_polish(recorded, fine)
    say("held out")  # first: a study is large, and this one is let go before the other begins
    unseen_errors = optional("the strokes held out", name, lambda: heldout.held_out(problem, fine, to_polish)[0])
    study = engine.study(problem, say)
    faint_recordings.refuse_faint(study, recorded[0].place)
    study = polish.polished(study, to_polish)
    if unseen_errors and beyond_seen(problem.record, unseen_errors["until_s"]):
        of_all = [act.id for act in study.state.acts if act not in study.problem.included]
        unseen_errors = heldout.decided(unseen_errors, of_all)
    say("writing")
    experiment = optional("the next experiment", name, lambda: verdict.next_experiment(study, runs[0]))
    content = verdict.diagnosis(study, fine, unseen_errors, runs, experiment, without)
    if unseen_errors:
        content["without_last_strokes"] = without_last.written(problem, unseen_errors)
    if experiment and content["next_run"]:
        readings = optional("how far its readings part", name, lambda: apart.apart(study, runs[0], experiment))
        content["next_run"] |= {"apart": tidy(readings)} if readings else {}
    earlier = [cast(Adoption, adoption.model_dump(exclude_none=True)) for run in runs for adoption in run.adopted]
    if earlier:
        content["adopted"] = [adoption for place, adoption in enumerate(earlier) if adoption not in earlier[:place]]
    content["evidence"] |= of_run_yaml(study, runs)
    content["evidence"]["covered"] |= tidy(pauses(recorded) | reversals(recorded)) | paces(recorded)
    if lonely := spikes_found(recorded):
        content["evidence"]["spikes"] = lonely
    ending = study.problem.system.channel.rpartition("_")[2]
    single = optional(
        "the noise of single samples",
        name,
        lambda: single_floor(study, fine, recorded, amount(content["fit"], f"noise_floor_{ending}")),
    )
    content["evidence"] |= tidy(single or {})
    if step := steps_of(recorded):
        put(content["evidence"], f"resolution_{ending}", tidy(step))
    if adopted := optional("what was adopted", name, lambda: adopted_effects(study.problem, runs[0], ending)):
        content["evidence"]["adopted_effects"] = tidy(adopted)
    if others := optional("why others are not kept", name, lambda: not_kept(study, ending)):
        content["evidence"]["not_kept"] = tidy(others)
    named = (study, runs[0], content["mechanisms"], ending, missed(study, content, ending))
    if foretold := optional("what to expect of other strokes", name, lambda: expected.of_explanations(*named)):
        content["evidence"]["expected"] = tidy(foretold)
    return content, study


def missed(study: Study, content: Verdict, ending: str) -> float:
    """The rms error of the simulator on an unseen stroke, noise of single samples averaged; in the reading's unit."""
    noise = amount(content["fit"], f"noise_floor_{ending}")
    unseen_error = amount_or_none(content["fit"]["heldout"] or {}, f"explained_{ending}")
    unseen = noise if unseen_error is None else float(unseen_error)
    return math.hypot(told_floor(study), math.sqrt(max(unseen**2 - noise**2, 0.0)))


def of_run_yaml(study: Study, runs: list[Run]) -> Evidence:
    """What the words need from run.yaml beside its dimensions, for the `evidence`.

    The tolerances and the sensor's scale that it gives, and by how much a run errs with the effects and dimensions that
    it has adopted: rms in the channel's unit, with the zero of the reading at its best.
    """
    problem, channel = study.problem, runs[0].system.channel
    evidence: Evidence = {"tolerances_given": sorted(runs[0].tolerance)}
    scale = runs[0].channels[channel].scale if channel in runs[0].channels else 1.0
    if scale != 1.0:
        evidence["scale_given"] = scale
    adopted = of_run(runs[0])
    if len(runs) == 1 and adopted["parameters"]:
        predicted = at_its_best_zero(problem, adopted, Path("run.yaml"), runs[0].run)
        put(evidence, f"adopted_{channel.rpartition('_')[2]}", rms(problem.measured - predicted))
    return evidence


def steps_of(recorded: list[RecordedRun]) -> float:
    """The resolution of the sensor, the coarsest of the runs, in the channel's unit; 0 where none is seen."""
    return max(resolution(each.samples[each.run.system.channel].to_numpy()) for each in recorded)


def optional(step: str, name: str, work: Callable[[], Result]) -> Result | None:
    """The result of a step that a verdict does not need; None if it fails, and the failure is shown in full."""
    try:
        return work()
    except Exception:
        print(f"warning: {name}: {step} failed; the verdict stands without it:", file=sys.stderr)
        traceback.print_exc()
        return None
