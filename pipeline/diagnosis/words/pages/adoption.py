"""The adopted effects of a run.yaml, and how to adopt the effects of a verdict, in words."""

import re
import shlex
from collections.abc import Sequence
from pathlib import Path

from ....ground.command import command, program_name
from ...document.content import Verdict
from ...mechanisms.library import mechanisms
from ..foretold import answered
from ..foretold.prediction import AFTER_RECORDING
from ..held_out import holdout, in_vain
from ..language.quantity import listing
from ..language.vocabulary import Vocabulary
from ..measured.dimensions import far_moved
from ..next_run import worth
from . import advice
from .adopted_doubts import against_advice, doubtful

COMMAND = command("adopt")
SIMULATE = command("simulate")
FALLS = " Where its load falls it has one only as far as a recorded load fell."
WEIGHED_ANEW = (
    "While it is in run.yaml its name is not weighed again, and new_run --like copies it. To try the name on another "
    "run of the {rig}, take it out of each run, and diagnose them together."
)


def weighed_anew(words: Vocabulary) -> str:
    """The remark that adopted effects are not weighed again, and how to test their names."""
    return WEIGHED_ANEW.format(rig=words.string if words.twisted else "rig")


def cautions(content: Verdict, rest: str = "") -> list[str]:
    """The limits of a verdict with adopted effects in run.yaml; only words that `rest`, the text beside it, uses."""
    ids = holdout.included(content)
    if not ids:
        return [*against_advice(content), *doubtful(content)]
    them = "it" if len(ids) == 1 else "them"
    own = (
        f" Below, dimensions are fitted anew from the measured ones; {program_name('simulate')} takes those that were "
        f"adopted with {them}."
    )
    own = own if dimensions_came(content) else ""
    lines = [
        f"run.yaml has adopted {listing(ids)}: this verdict is on the simulator with {them}.{own}{_sight(content, ids)}"
    ]
    doubt, against = doubtful(content), against_advice(content)
    if content["verdict"] in ("consistent", "parameters"):
        lines[0] += " An adopted effect can also cover another one that is really there."
        if not doubt and not against:
            doubt = [
                "Whether another explanation fits as well stands in the verdict that was adopted, not here: if it was "
                "ambiguous, it is so still, and its run decides."
            ]
    used = "\n".join([rest, *against, *lines, *doubt])
    return [*against, *lines, *now_means(content["verdict"], listing(ids), used), *doubt]


def now_means(verdict: str, effects: str, used: str) -> list[str]:
    """The new meaning of the verdict's word, `nominal` and `calibrated` with `effects` adopted, for words in `used`."""
    meaning = {
        "consistent": f"with {effects} in the simulator nothing further can be named",
        "parameters": f"with {effects} in the simulator, and dimensions moved, nothing further can be named",
    }.get(verdict, f"beside {effects} more is missing")
    means = {verdict: f": {meaning}", "nominal": f" the simulator with {effects} and the dimensions of run.yaml"}
    means["calibrated"] = f" the simulator with {effects} and moved dimensions"
    sentences = [f"`{word}` now means{means[word]}." for word in means if re.search(rf"\b{word}\b", used)]
    return [" ".join([*sentences, f"That is not the rig without {effects}."])] if sentences else []


def dimensions_came(content: Verdict) -> bool:
    """Whether effects were adopted together with the dimensions that were fitted with them."""
    return any(adoption.get("dimensions") for adoption in content.get("adopted", []))


def adopted_again(content: Verdict) -> bool:
    """Whether calibration only found again the adopted value of each dimension that moved far."""
    came = [adoption["dimensions"] for adoption in content.get("adopted", []) if adoption.get("dimensions")][-1:]
    parameters, sigma = content["parameters"], content["evidence"].get("tolerance", {})
    far = [name for name in far_moved(content) if name in parameters]
    return bool(came and far) and all(
        name in came[0] and abs(parameters[name]["value"] - came[0][name]["fitted"]) <= sigma.get(name, 0.0)
        for name in far
    )


def _sight(content: Verdict, ids: list[str]) -> str:
    """Which recordings of this verdict the adopted effects were fitted to; nothing where these were other ones."""
    they, were = ("It", "was") if len(ids) == 1 else ("They", "were")
    fitted = f"{they} {were} fitted to {holdout.fitted_to(content, 'very ')}"
    its, every = ("the", "their") if holdout.runs(content)[1:] else ("its", "its")
    others = listing(holdout.held_out_runs(content, seen=False))
    whose = f" {fitted}; the last strokes below are of {others}, which no fit had seen."
    return {
        holdout.UNSEEN: whose if holdout.fitted_runs(content) else "",
        holdout.SEEN: f" {fitted}, all {every} strokes included: the error on {its} last strokes below is no test.",
        holdout.PARTLY: f" {fitted}, all their strokes included. Of the last strokes below only those of {others} are "
        "a test.",
        holdout.PERHAPS: f" Nobody wrote down which recording {they.lower()} {were} fitted to: if it is this one, the "
        "error on its last strokes below is no test.",
    }[holdout.status(content)]


def predictions(source: Path, folders: list[Path], ids: Sequence[str]) -> list[str]:
    """The commands that predict with a diagnosis, its dimensions included: the recorded motion, and a planned one.

    `ids` are the effects that act: where one stays in the string, the planned motion goes on from the recorded one.
    """
    starts = [f"{SIMULATE} {shlex.quote(str(folder))} --simulation {shlex.quote(str(source))}" for folder in folders]
    planned = f"--motion PLAN.csv {f'{AFTER_RECORDING} ' * bool(staying(ids))}--out FILE.csv"
    return [line for start in starts for line in (f"{start} --out FILE.csv", f"{start} {planned}")]


def staying(ids: Sequence[str]) -> list[str]:
    """The effects among some that change the string for good."""
    return [id_ for id_ in ids if id_ in mechanisms() and mechanisms()[id_].stays]


def of_staying(ids: Sequence[str]) -> list[str]:
    """Where a planned motion begins, if an effect stays in the string or the sensor; else nothing."""
    stay = staying(ids)
    if not stay:
        return []
    what = f"{listing(stay)} {'go' if len(stay) > 1 else 'goes'} on from the recording's end"
    return [f"{what}; without {AFTER_RECORDING} a plan begins as the recording did."]


def adopted_predictions(folder: Path, words: Vocabulary, load: str | None, ids: list[str]) -> list[str]:
    """How to predict with the effects `ids`, which a run has adopted; `load` is its column, where something hangs."""
    start = f"  {SIMULATE} {shlex.quote(str(folder))}"
    plan = columns_of_plan(words, load)
    lines = [f"To predict with it ({plan}):", f"{start} --out FILE.csv"]
    if not staying(ids):
        return [*lines, f"{start} --motion PLAN.csv --out FILE.csv"]
    planned = f"{start} --motion PLAN.csv"
    used = f"{planned} {AFTER_RECORDING} --out FILE.csv"
    return [*lines, f"{used}   # the string as this recording left it", f"{planned} --out FILE.csv   # as before it"]


def hung(content: Verdict, words: Vocabulary) -> str | None:
    """The column of the load, if the recording has one that is not always 0; else None."""
    covered = content.get("evidence", {}).get("covered")  # adopt takes files without
    return None if covered is not None and not any(covered["load"]) else words.load


def columns_of_plan(words: Vocabulary, load: str | None) -> str:
    """The content of a planned motion's file, in the rig's words with its column `load`, and its number of rows."""
    columns = f"time_s, {words.driver} and, unless it stands still, {load}" if load else f"time_s and {words.driver}"
    plan = f"PLAN.csv is a motion that you plan: {columns}"
    if words.twisted:
        return f"{plan}; its corners will do"
    needs = f"; the {words.reading} needs the acceleration, so corners are not enough" * words.differentiates
    return f"{plan}, at your controller's rate{needs}"


def how(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The command that adopts the named effects into run.yaml; `out` is the folder of the diagnosis."""
    if out is None or content["verdict"] not in ("explained", "ambiguous") or not content.get("simulation", [True]):
        return []
    if in_vain.harmful(content, words):
        return [advice.worse(content)]
    source = out / "diagnosis.json"
    lines = [f"To predict with it, dimensions included ({columns_of_plan(words, hung(content, words))}):"]
    ids = [entry["id"] for entry in content["mechanisms"]]
    lines += [f"  {line}" for line in predictions(source, folders, ids)]
    lines += of_staying(ids)
    where = answered.within(content, words)
    falls = FALLS if content["evidence"].get("loaded") else ""
    lines += [f"A plan has an error band within {where}.{falls}"] if where else []
    lines.append(advice.of_adopting(content, words))
    if not advice.lets(content, words):
        return lines
    lines.append("To put its effects into run.yaml, with the dimensions that fit with them; yours stay as measured:")
    lines += [f"  {COMMAND} {shlex.quote(str(source))} {shlex.quote(str(folder))}" for folder in folders]
    if content["verdict"] == "ambiguous":
        run = content["next_run"]
        can = run is not None and "parts" in run and worth.decides(run)
        before = f"Make the run above first, if you need to know {worth.question(content)}." if can else ""
        lines.append(before or "No run that was tried is sure to decide between the explanations.")
    lines.append("Diagnose again into another folder (--out): in the same one this verdict is replaced.")
    return lines
