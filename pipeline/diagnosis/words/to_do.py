"""What to do next, in numbered steps, the first one first; they follow from the verdict and decide nothing."""

import shlex
from pathlib import Path

from ...ground.command import command
from ..content import NextRun, Verdict
from . import (
    advice,
    answered,
    deciding_run,
    experiment,
    holdout,
    make_sure,
    parting,
    report,
    to_measure,
    unseen,
    worth,
)
from .adoption import dimensions_came, of_staying, predictions
from .dimensions import far_moved, name_of
from .headline import moved_in_vain
from .make_sure import DETAILS, RUN
from .quantity import listing, quantity
from .technician import lasting
from .vocabulary import Vocabulary

HEADING = "What to do, in this order"
NAMED = ("explained", "ambiguous")


def lines(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The steps, numbered where there are several; what belongs to a step stands below it, indented."""
    steps = _named(content, words, folders, out) if content["verdict"] in NAMED else _unnamed(content, words, folders)
    if len(steps) == 1:
        return steps[0]
    numbered = []
    for place, (first, *rest) in enumerate(steps, start=1):
        numbered += [f"{place}. {first}", *(f"   {line}" for line in rest)]
    return numbered


def _named(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[list[str]]:
    """The steps where something is named."""
    if unseen.harmful(content, words):
        return [
            [f"{advice.worse(content)} Record the rig once more, with more strokes, and diagnose both runs together."],
            *_run(content, words),
            *_report(content, words),
        ]
    return [
        *_measure(content, words),
        *_run(content, words),
        *make_sure.of_names(content, words, folders, out),
        *make_sure.of_what_is_missing(content, words, folders, out),
        *_use(content, words, folders, out),
        *_adopt(content, words, folders, out),
        *_report(content, words),
    ]


def _measure(content: Verdict, words: Vocabulary, then: str = "go on with step 2") -> list[list[str]]:
    """What to measure again, and what then; nothing where no dimension moved far."""
    if not far_moved(content):
        return []
    return [
        [
            "Measure again what calibration moved far:",
            *to_measure.table(content, words),
            *to_measure.consequences(content, then),
        ]
    ]


def _run(content: Verdict, words: Vocabulary) -> list[list[str]]:
    """The run to make between explanations that are likely; that none decides, where none does."""
    run = content["next_run"]
    if content["verdict"] != "ambiguous":
        return []
    if not run or "parts" not in run:
        return [[f"No run is proposed that decides between the {1 + len(content['alternatives'])} explanations."]]
    where = (
        f"Its steps and commands are in {DETAILS} under {RUN}; they take {lasting(run)}{_asks(content, run, words)}. "
        "Each open effect's own test stands there too."
    )
    differ, parts = worth.readings(run, words), parting.sentence(content)
    if worth.decides(run):
        need = f"Make the run that can decide {worth.question(content)}, if you need to know. {where}"
        return [[" ".join(part for part in (need, parts, differ, worth.care(content, words)) if part)]]
    if worth.raises(run):
        hard = ", the two that are hardest to tell apart" if len(content["alternatives"]) > 1 else ""
        need = f"Only if you need to know {worth.question(content)}{hard}: try the run that parts them most."
        tried = "About half of such runs decided in tests."
        return [[" ".join(part for part in (need, tried, parts, where) if part)]]
    if parting.some(content):
        best = f"Only for that make the best run, which is in {DETAILS} under {RUN}."
        return [[f"No run that was tried decides {worth.question(content)}. {parts} {best}"]]
    return [[f"Make no other run: none that was tried decides {worth.question(content)}."]]


def _asks(content: Verdict, run: NextRun, words: Vocabulary) -> str:
    """What a run asks of the rig: other loads, other speeds."""
    title = experiment.title(run, words)
    usual = quantity(run["load"], words.load_unit) if run.get("load") else ""
    hung = list(dict.fromkeys(part.load for part in experiment.parts(run, words, 1.0)))
    hung = [load for load in hung if load not in ("", usual)]
    loads = f"another load ({listing(hung)})" if hung else "another load"
    demands = ["another speed"] * worth.asks_speed(content, words) + [loads] * ("load" in title)
    return f", and ask for {listing(demands)}" if demands else ""


def _use(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[list[str]]:
    """The command that predicts with what was found."""
    if out is None or not content.get("simulation", [True]):
        return []
    where = answered.within(content, words)
    head = f"To predict the rig, at loads, speeds and {words.motion}s like those recorded"
    head += f". A plan has an error band within {where}:" if where else ":"
    ids = [entry["id"] for entry in content["mechanisms"]]
    planned = predictions(out / "diagnosis.json", folders, ids)[1::2]  # those of the recorded motion: in the details
    return [[head, *(f"  {line}" for line in planned), *of_staying(ids)]]


def _adopt(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[list[str]]:
    """Whether to put the effects into run.yaml, and the command that does."""
    if out is None or not content.get("simulation", [True]):
        return []
    what = "To put it into run.yaml, dimensions included:"
    source = shlex.quote(str(out / "diagnosis.json"))
    commands = [f"  {command('adopt')} {source} {shlex.quote(str(folder))}" for folder in folders]
    return [[f"{advice.of_adopting(content, words)} {what}", *commands]]


def _report(content: Verdict, words: Vocabulary) -> list[list[str]]:
    """What can be reported, and what cannot."""
    reportable = report.lines(content, words)
    return [reportable] if reportable else []


def _unnamed(content: Verdict, words: Vocabulary, folders: list[Path]) -> list[list[str]]:
    """The steps where nothing is named."""
    if content["verdict"] == "unknown":
        run = content["next_run"]
        shows = f"Make the run in {DETAILS} under {RUN}: it shows more of what is missing."
        again = _measure(content, words, "go on")
        return [*again, *([[shows]] if run else []), ["Adopt nothing: no effect of the library is named."]]
    tied = [adoption for adoption in content.get("adopted", []) if adoption["tied"]]
    if tied and not deciding_run.worth_making(tied):
        count = 1 + max(len(adoption["tied"]) for adoption in tied)
        advice = f"Report what was adopted as one of {count} explanations: no run that was tried decides between them."
        return [[advice], *_anew(content, words, folders), *make_sure.of_what_is_left(content, words)]
    if tied:
        return [
            *_anew(content, words, folders),
            [
                "Decide between what was adopted and what was likely as well, if you need to know: the run is in "
                f"{DETAILS} under {RUN}. Take out what was adopted first, for it is not weighed again:",
                *(f"  {command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders),
            ],
            *make_sure.of_what_is_left(content, words),
        ]
    if unseen.left_over(content, words):
        return [[f"Record the rig in other ways, as {DETAILS} says under {RUN}, and diagnose the runs together."]]
    if holdout.included(content) and far_moved(content):
        return _anew(content, words, folders)
    if far_moved(content) and not (content["verdict"] == "parameters" and moved_in_vain(content, words)):
        names = listing([f"the {name_of(name)}" for name in far_moved(content)])
        return [
            [f"Measure {names} again, and write what you measured into run.yaml.", *to_measure.table(content, words)]
        ]
    open_still = make_sure.of_adopted(content, words, holdout.included(content), folders)
    return [["Nothing needs to be done: this recording shows nothing further."], *open_still]


def _anew(content: Verdict, words: Vocabulary, folders: list[Path]) -> list[list[str]]:
    """What to measure again after adopting, and what follows for the adopted effects."""
    if not far_moved(content):
        return []
    remove = [f"  {command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders]
    again = ["Measure again what calibration moved far:", *to_measure.table(content, words)]
    change = (
        "Where you find another value, take the adopted effects out, write the value into run.yaml, diagnose again, "
        "and adopt what the new verdict names: effects and dimensions were fitted together."
    )
    if dimensions_came(content):
        keep = f"If nothing changed, keep what was adopted, and predict with {command('simulate')} as it is."
        return [again, [change, *remove], [keep]]
    adopted = [adoption for adoption in content.get("adopted", []) if adoption.get("diagnosis")][-1:]
    known = [(Path(str(adoption["diagnosis"])), adoption["effects"]) for adoption in adopted]
    predict = [f"  {line}" for source, ids in known for line in predictions(source, folders, ids)]
    keep = (
        f"If nothing changed, predict with {'the diagnosis that was adopted:' if adopted else 'that diagnosis.json.'}"
    )
    return [again, [change, *remove], [keep, *predict]]
