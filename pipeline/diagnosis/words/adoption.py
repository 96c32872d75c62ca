"""What run.yaml has adopted, and how what was found is adopted, in words."""

import shlex
from pathlib import Path
from typing import Any

from ...ground.command import command, program_name
from . import sight, unseen, worth
from .dimensions import far_moved
from .quantity import listing
from .rivals import called
from .vocabulary import Vocabulary

NAMED = 2  # explanations that tied, by name; the others are counted
COMMAND = command("adopt")
SIMULATE = command("simulate")


def cautions(content: dict[str, Any]) -> list[str]:
    """What a verdict is worth where run.yaml has adopted effects."""
    ids = sight.included(content)
    if not ids:
        return doubtful(content)
    it = "it" if len(ids) == 1 else "them"
    own = (
        f" {program_name('simulate')} takes the dimensions that were adopted with {it}, and errs as the adopted "
        "verdict says; below they are fitted anew, from the measured ones."
    )
    own = own if dimensions_came(content) else ""
    lines = [
        f"run.yaml has adopted {listing(ids)}: this verdict is on the simulator with {it}.{own}{_sight(content, ids)}"
    ]
    doubt = doubtful(content)
    if content["verdict"] in ("consistent", "parameters"):
        lines[0] += " An adopted effect can also cover another one that is really there."
        doubt = doubt or [
            "Whether another explanation fits as well stands in the verdict that was adopted, not here: if it was "
            "ambiguous, it is so still, and its run decides."
        ]
    return lines + doubt


def dimensions_came(content: dict[str, Any]) -> bool:
    """Whether the adopted effects brought the dimensions with them that they were fitted with."""
    return any(one.get("dimensions") for one in content.get("adopted", []))


def adopted_again(content: dict[str, Any]) -> bool:
    """Whether calibration found for each dimension that moved far what was adopted with the effects already."""
    came = [one["dimensions"] for one in content.get("adopted", []) if one.get("dimensions")][-1:]
    known, sigma = content["parameters"], content["evidence"].get("tolerance", {})
    far = [name for name in far_moved(content) if name in known]
    return bool(came and far) and all(
        name in came[0] and abs(known[name]["value"] - came[0][name]["fitted"]) <= sigma.get(name, 0.0) for name in far
    )


def _sight(content: dict[str, Any], ids: list[str]) -> str:
    """What the adopted effects have seen of this recording; nothing where it was another."""
    they, were = ("It", "was") if len(ids) == 1 else ("They", "were")
    fitted = f"{they} {were} fitted to this very recording"
    return {
        sight.UNSEEN: "",
        sight.SEEN: f" {fitted}, all its strokes included: the error on its last strokes below is no test.",
        sight.PERHAPS: f" Nobody wrote down which recording {they.lower()} {were} fitted to: if it is this one, the "
        "error on its last strokes below is no test.",
    }[sight.sight(content)]


def doubtful(content: dict[str, Any]) -> list[str]:
    """Which explanations tied with what was adopted, a sentence for each verdict that was; nothing where none says."""
    lines = []
    for one in content.get("adopted", []):
        effects, tied = listing(one["effects"]), one["tied"]
        if not tied:
            lines.append(f"No other explanation was as likely as what was adopted ({effects}).")
            continue
        named = listing([called(ids) for ids in tied[:NAMED]], "or")
        rest = f", or one of {len(tied) - NAMED} more (`adopted` in run.yaml)" if len(tied) > NAMED else ""
        lines.append(
            f"Instead of what was adopted ({effects}) this may be right, for it was likely as well: {named}{rest}."
        )
    return lines


def predictions(source: Path, folders: list[Path]) -> list[str]:
    """The commands that predict with a diagnosis, its dimensions included."""
    said = shlex.quote(str(source))
    return [f"{SIMULATE} {shlex.quote(str(folder))} --simulation {said} --out FILE" for folder in folders]


def how(content: dict[str, Any], words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The command that puts what is named into run.yaml; `out` is the folder of the diagnosis."""
    if out is None or content["verdict"] not in ("explained", "ambiguous") or not content.get("simulation", [True]):
        return []
    if unseen.harmful(content, words):
        return [f"Do not: on the {sight.strokes(content)} it makes the simulator worse."]
    source = out / "diagnosis.json"
    lines = ["To predict with it, dimensions included:"]
    lines += [f"  {line}" for line in predictions(source, folders)]
    lines.append("To put its effects into run.yaml, with the dimensions that fit with them; yours stay as measured:")
    lines += [f"  {COMMAND} {shlex.quote(str(source))} {shlex.quote(str(folder))}" for folder in folders]
    if far_moved(content):
        lines.append("Measure again first: adopting takes effects that stand on dimensions which may be wrong.")
    if content["verdict"] == "ambiguous":
        run = content["next_run"]
        can = bool(run) and "parts" in run and worth.decides(run)
        mend = "make the run above first" if can else "no run that was tried is sure to decide between them"
        lines.append(f"Another explanation may be the right one: {mend}.")
    lines.append("Diagnose again into another folder (--out): in the same one this verdict is replaced.")
    return lines
