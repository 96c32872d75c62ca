"""The run that still decides between what was adopted and what tied with it: its steps and its commands again."""

import re
import shlex
from pathlib import Path
from typing import Any

from ...ground.command import command
from ..adopt import NO_USE
from . import commands
from .headline import UNNAMED
from .vocabulary import Vocabulary

STILL = "Others were likely beside what was adopted. The run that decides is still that of the adopted verdict:"
HARDLY = (
    "None is proposed: other explanations were likely beside what was adopted, and the adopted verdict found no run "
    "that decides between them."
)
LOST = (
    "Others were likely beside what was adopted. The run that decides stands in the adopted verdict, under the "
    "same heading."
)
FIRST = "Take out what was adopted first, for it is not weighed again. Later adopt what the new verdict names."
STEP = re.compile(r" (?=\d+\. [A-Z])")  # where a step begins
END = re.compile(r"(?<=[.:]) (?=[A-Z])")  # where a sentence ends
LOAD = re.compile(r"change the load from \S+ to ([0-9.,]+) N\b")
AFTER = re.compile(
    r" (?=(?:Only if|If your|Worth making|Worth a try|Hardly worth|This run is|It shows|Record (?:it|each)) )"
)
TOGETHER = "Record "  # how the sentence begins that the commands replace


def lines(content: dict[str, Any], words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The runs of the verdicts that were adopted and tied; nothing where none did, or where this one names more."""
    tied = [one for one in content.get("adopted", []) if one["tied"]]
    if not tied or content["verdict"] not in ("explained", *UNNAMED):
        return []
    if not worth_making(tied):
        return [HARDLY]
    said: list[str] = []
    for told in dict.fromkeys(one.get("next_experiment") for one in tied):
        said += [LOST] if told is None else [STILL, *protocol(told)]
    told = next((one["next_experiment"] for one in reversed(tied) if one.get("next_experiment")), "")
    found = commands.lines(folders, out, loads(told) if words.twisted else [""] * len(loads(told)))
    remove = [f"  {command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders]
    return [*said, FIRST, *remove, *commands.block(found, folders[-1].name, words.twisted)]


def worth_making(tied: list[dict[str, Any]]) -> bool:
    """Whether one of the adopted verdicts that tied proposed a run that can decide, or does not say which run."""
    return not all(NO_USE in (one.get("next_experiment") or "") for one in tied)


def protocol(told: str) -> list[str]:
    """A run as `next_experiment` holds it, on one line, step by step again."""
    protocol_, *after = AFTER.split(told)
    head, *steps = STEP.split(protocol_)
    title, *before = END.split(head)
    found = [title, *(f"  {one}" for one in before)]
    for step in steps:
        number, _, sentences = step.partition(" ")
        first, *changed = END.split(sentences)  # before the next run
        found += [f"  {number} {first}", *(f"  {one}" for one in changed)]
    rest = " ".join(one for one in after if not one.startswith(TOGETHER))
    return [*found, rest] if rest else found


def loads(told: str) -> list[str]:
    """The load to give `new_run` for each run that a told one asks for, empty where it stays."""
    runs = re.split(r"(?=\bRun \d+\b)", told)
    runs = runs[1:] if len(runs) > 1 else runs
    found = [LOAD.search(one) for one in runs]
    return [each[1].replace(",", "") if each else "" for each in found]
