"""What adopting a diagnosis does to the simulator of a run, in words: its errors before and after, its dimensions."""

import math
from pathlib import Path

from ...ground.command import program_name
from ...ground.errors import BadInput
from ...ground.input.complaint import key_name
from ...ground.units import unit_of
from ...run.description import Run
from ..document.content import Simulated, Verdict
from ..document.explanations import share_of
from ..fit.adopt import fitted, is_number
from ..fit.problem import Problem
from ..prediction.later_run import names_before, places_beside, predicted_after, simulated_before
from ..prediction.simulation import off
from ..recording.recorded_run import RecordedRun
from ..study import heldout
from ..words.explanations.rivals import called
from ..words.held_out import holdout
from ..words.language.quantity import listing, number, percent, said_unit, size
from ..words.language.text_table import aligned
from ..words.language.vocabulary import Vocabulary
from ..words.measured.dimensions import LEAVES, name_of
from ..words.measured.exactness import assumed
from ..words.measured.to_measure import BESIDE
from ..words.pages.advice import contrary

NEXT = (
    f"The next {program_name('diagnose')} starts from here: with these effects, and with the dimensions as you "
    "measured them, which it calibrates anew. Give it another --out: in the same folder it replaces the verdict that "
    "was adopted."
)
KEPT = "run.yaml keeps that advice, and later verdicts repeat it."
WORSE = 1.1  # times the error before: less may be chance
HARDLY, MOST = 0.05, 8  # sigma: a dimension that stayed; dimensions that are named


def refuse_unadvised(content: Verdict, words: Vocabulary, source: Path, sure: bool) -> None:
    """Raise BadInput where the verdict advises against adopting it, unless a person is `sure`."""
    whether = contrary(content, words)
    if whether and not sure:
        mend = "do what the verdict asks for first; if you know better, add --sure"
        raise BadInput(source, "verdict", f"advises against adopting it: {whether.rstrip('.')}", mend)


def against_advice(content: Verdict, words: Vocabulary, out: str) -> list[str]:
    """The warning that adopting goes against the verdict's advice, with the line `out` that undoes it; or nothing."""
    whether = contrary(content, words)
    if not whether:
        return []
    return [f"Adopted against the verdict's advice. The verdict says: {whether} To take it out of run.yaml again:", out]


def dimensions(content: Verdict) -> list[str]:
    """The dimensions that come with the effects: measured and fitted values, and which ones to measure again."""
    evidence = content.get("evidence")
    sigmas = evidence.get("moved_sigma") if isinstance(evidence, dict) else None
    moved = {name: abs(sigma) for name, sigma in sigmas.items() if is_number(sigma)} if isinstance(sigmas, dict) else {}
    dimension_by_name = fitted(content, "")
    changes = []
    for name in sorted(dimension_by_name, key=lambda name: -moved.get(name, 0.0))[:MOST]:
        parameter, unit = dimension_by_name[name], said_unit(unit_of(name))
        if moved.get(name, 0.0) >= HARDLY:
            first = f"{number(parameter['nominal'], 6)}{' (assumed)' if assumed(name) else ''}"
            changes.append(f"{name_of(name)} {first} → {number(parameter['fitted'], 4)} {unit}".rstrip())
    if not changes:
        return []
    lines = [f"Adopted with the effects, as they were fitted together: {'; '.join(changes)}."]
    lines.append(
        f"{program_name('simulate')} takes these dimensions. The values that you gave in run.yaml stay. Change one of "
        "them, and the fitted ones count no more."
    )
    far = [f"the {name_of(name)}" for name in dimension_by_name if moved.get(name, 0.0) >= BESIDE]
    if far and any(sigma > LEAVES for sigma in moved.values()):
        lines.append(
            f"Measure {listing(far)} again: calibration moved {'it' if len(far) == 1 else 'them'} by more than "
            f"{BESIDE:g} tolerances. Where you find another value, take the effects out, write the value into "
            "run.yaml, diagnose again and adopt anew."
        )
    return lines


def outdated(content: Verdict, run: Run) -> str:
    """Dimensions of run.yaml that changed since the diagnosis was made, in words; nothing where none changed.

    A scale of the displacement sensor is a part of its channel, and counts too.
    """
    evidence = content.get("evidence")
    then = evidence.get("scale_given") if isinstance(evidence, dict) else None
    channel = run.channels.get(run.system.channel)
    scale_now = channel.scale if channel else 1.0
    scale_then = float(then) if then is not None and is_number(then) else 1.0
    dimension_by_name, differences = fitted(content, ""), []
    for parameter in run.system.parameters(run):
        if parameter.name in dimension_by_name and not math.isclose(
            parameter.nominal, dimension_by_name[parameter.name]["nominal"], rel_tol=1e-4, abs_tol=1e-9
        ):
            was, now = number(dimension_by_name[parameter.name]["nominal"], 6), number(parameter.nominal, 6)
            differences.append(
                f"a {name_of(parameter.name)} of {was} {said_unit(unit_of(parameter.name))}, and run.yaml says {now}"
            )
    if isinstance(evidence, dict) and not math.isclose(scale_now, scale_then, rel_tol=1e-4):
        differences.append(f"a scale of {number(scale_then, 6)}, and run.yaml says {number(scale_now, 6)}")
    return listing(differences)


def probable(ids: list[str], content: Verdict) -> str:
    """An explanation by its name, with its probability where the diagnosis holds one."""
    evidence = content.get("evidence")
    shown = evidence.get("explanations") if isinstance(evidence, dict) else None
    for explanation in shown if isinstance(shown, list) else []:
        if (
            isinstance(explanation, dict)
            and explanation.get("ids") == ids
            and is_number(explanation.get("probability"))
        ):
            return f"{called(ids)} ({percent(share_of(explanation))})"
    return called(ids)


def is_of(content: Verdict, run: str) -> bool:
    """Whether a diagnosis is of a run; a diagnosis that names no run counts as being of it."""
    of = content.get("run", run)
    return run in (of if isinstance(of, list) else [of])


def on_unseen(content: Verdict, words: Vocabulary, run: str) -> list[str]:
    """What the verdict says of a run's unseen strokes, and whether it says not to adopt; else nothing."""
    fit, verdict = content.get("fit"), content.get("verdict")
    unseen_errors = fit.get("heldout") if isinstance(fit, dict) else None
    values = (
        [unseen_errors.get(f"{name}_{words.ending}") for name in ("calibrated", "explained")]
        if isinstance(unseen_errors, dict)
        else []
    )
    if not is_of(content, run) or verdict not in ("explained", "ambiguous"):
        return []
    if len(values) != 2 or not all(map(is_number, values)):
        return []
    calibrated, explained = (float(value) for value in values if isinstance(value, int | float))
    sentences = [
        "Those errors are of strokes that the fit has seen. On unseen ones the verdict says "
        f"{size(explained, words.unit)}"
        f"{holdout.whose_if_known(content)}, and {size(calibrated, words.unit)} without the effects."
    ]
    if explained > heldout.WORSE * calibrated:
        sentences.append("So the verdict says: adopt nothing. Take it out again unless you know better.")
    return sentences


def begun_anew(content: Verdict, run: str, folder: Path) -> list[str]:
    """How a run's errors are simulated that went after others in its verdict: after these, or why they are larger.

    It goes after them where they lie beside its folder. Nothing is said of a run that went after none.
    """
    names = names_before(content, run)
    after = f"In the verdict {run} goes after {' and '.join(map(key_name, names))}"
    anew = f"{after}; here it is alone, what goes on over time or strokes begins anew in it, and the error is larger."
    beside = len(places_beside(folder, names)) == len(names)
    return [f"{after}, and so does what is simulated now." if beside else anew] if names else []


def told(
    recorded: RecordedRun, problem: Problem, before: Simulated, now: Simulated, path: Path, own: bool = True
) -> list[str]:
    """The error of `pipeline.simulate` on a run's own recording, before adopting and from now on.

    `problem` is the run's without any effect, averaged where it has fewer rows than the recording has samples; `before`
    and `now` are what its run.yaml simulates, each after the runs of its diagnosis that lie beside the run; `own`: the
    diagnosis at `path` is of this run. Raises BadInput, also where one of another run would make the simulator worse.
    """
    unit = problem.drivers.units.reading
    columns = {"before": before, "now": now}
    errors = [_errors(recorded, problem, simulated, path) for simulated in columns.values()]
    if not own and errors[1][1] > WORSE * errors[0][1]:
        sizes = f"{size(errors[1][0], unit)} where it errs by {size(errors[0][0], unit)} now"
        wrong = f"is of another run, and would make the simulator of this one worse: {sizes}"
        raise BadInput(path, "run", wrong, "diagnose this run, and adopt that")
    of_means = f"averages of {number(problem.drivers.step_s)} s" * (len(problem.record) < len(recorded.samples))
    rows = [[f"on this recording, rms of {of_means or 'single samples'}", *columns]]
    rows.append([f"error of {program_name('simulate')}"])
    if problem.system.free_zero:
        rows.append(["the same, if the whole recording sets the zero"])
    for row, before_and_now in zip(rows[1:], zip(*errors, strict=True), strict=False):
        row += [size(error, unit) for error in before_and_now]
    return aligned(rows)


def _errors(recorded: RecordedRun, problem: Problem, content: Simulated, path: Path) -> tuple[float, float]:
    earlier = simulated_before(content, recorded.run.run, recorded.place)
    thin = problem.system.differentiates
    return off(problem.measured, predicted_after(earlier, recorded, problem, content, path, thin))
