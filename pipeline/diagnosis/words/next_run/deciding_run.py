"""The run that decides between adopted effects and the explanations that tied with them: its steps and commands."""

import re
import shlex
from pathlib import Path

from ....ground.command import command
from ...document.adopted_run import AFTER, DROPPED, END, STEP, in_one_line
from ...document.content import Adoption, Verdict
from ...fit.adopt import NO_USE
from ..held_out.without_name import UNNAMED
from ..language.vocabulary import Vocabulary
from . import commands

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
LOAD = re.compile(r"change the load from \S+ to ([0-9.,]+) N\b")


def lines(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The deciding runs of adopted verdicts that tied; nothing where none tied, or where this verdict names more."""
    tied = [adoption for adoption in content.get("adopted", []) if adoption["tied"]]
    if not tied or content["verdict"] not in ("explained", *UNNAMED):
        return []
    if not worth_making(tied):
        return [HARDLY]
    runs: list[str] = []
    experiments = [in_one_line(adoption.get("next_experiment")) for adoption in tied]
    for experiment in dict.fromkeys(experiments):
        runs += [LOST] if experiment is None else [STILL, *protocol(experiment)]
    last = next(filter(None, reversed(experiments)), "")
    to_type = commands.lines(folders, out, loads(last) if words.twisted else [""] * len(loads(last)))
    remove = [f"  {command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders]
    return [*runs, FIRST, *remove, *commands.block(to_type, folders[-1], words)]


def worth_making(tied: list[Adoption]) -> bool:
    """Whether a tied, adopted verdict proposed a run that can decide, or does not say which run it proposed."""
    return not all(NO_USE in (in_one_line(adoption.get("next_experiment")) or "") for adoption in tied)


def protocol(experiment: str) -> list[str]:
    """A run from `next_experiment`, where it is one line, as separate steps."""
    protocol_, *after = AFTER.split(experiment)
    head, *steps = STEP.split(protocol_)
    title, *before = END.split(head)
    written = [title, *(f"  {sentence}" for sentence in before)]
    for step in steps:
        number, _, sentences = step.partition(" ")
        first, *changed = END.split(sentences)  # before the next run
        written += [f"  {number} {first}", *(f"  {sentence}" for sentence in changed)]
    rest = " ".join(sentence for sentence in after if not sentence.startswith(DROPPED))
    return [*written, rest] if rest else written


def loads(experiment: str) -> list[str]:
    """The load for `new_run` in each run that a protocol asks for, empty where it stays."""
    runs = re.split(r"(?=\bRun \d+\b)", experiment)
    runs = runs[1:] if len(runs) > 1 else runs
    changes = [LOAD.search(run) for run in runs]
    return [each[1].replace(",", "") if each else "" for each in changes]
