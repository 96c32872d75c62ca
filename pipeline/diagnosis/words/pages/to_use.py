"""The uses of a diagnosis, as steps of the page: predict the rig, and put the effects into run.yaml."""

import shlex
from pathlib import Path

from ....ground.command import command
from ...document.content import Verdict
from ..language.vocabulary import Vocabulary
from . import advice
from .adoption import columns_of_plan, hung, of_staying, predictions

LIKEWISE = "For the other runs likewise (details.txt)."


def predict(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[list[str]]:
    """The command that predicts a planned motion with the diagnosis; the details have the other commands."""
    if out is None or not content.get("simulation", [True]):
        return []
    loads = "loads, speeds" if hung(content, words) else "speeds"
    head = f"To predict the rig, at {loads} and {words.motion}s like those recorded"
    ids = [entry["id"] for entry in content["mechanisms"]]
    # of the last run, for it left the string as the next plan finds it
    planned = predictions(out / "diagnosis.json", folders, ids)[1::2]
    return [[f"{head}. {columns_of_plan(words, hung(content, words))}:", f"  {planned[-1]}", *of_staying(ids)]]


def adopt(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[list[str]]:
    """Whether to put the effects into run.yaml, and the command that does, where that is advised."""
    if out is None or not content.get("simulation", [True]):
        return []
    whether = advice.of_adopting(content, words)
    if not advice.lets(content, words):
        return [[whether]]
    source = shlex.quote(str(out / "diagnosis.json"))
    commands = [f"{command('adopt')} {source} {shlex.quote(str(folder))}" for folder in folders]
    return [[f"{whether} To put it into run.yaml, dimensions included:", *_of_each(commands, short=True)]]


def remove(folders: list[Path], short: bool) -> list[str]:
    """The command that takes adopted effects out of each run."""
    return _of_each([f"{command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders], short)


def _of_each(commands: list[str], short: bool) -> list[str]:
    """A command for each run, indented; `short`: that of the first run alone."""
    if short and len(commands) > 1:
        return [f"  {commands[0]}", LIKEWISE]
    return [f"  {line}" for line in commands]
