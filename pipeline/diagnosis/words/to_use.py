"""What a diagnosis is used for, as steps of the page: to predict the rig, and to put the effects into run.yaml."""

import shlex
from pathlib import Path

from ...ground.command import command
from ..content import Verdict
from . import advice, answered
from .adoption import of_staying, predictions
from .dimensions import far_moved
from .vocabulary import Vocabulary

BEFORE_STEP_1 = "Do not adopt before step 1 is done."
LIKEWISE = "For the other runs likewise (details.txt)."


def predict(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, brief: int) -> list[list[str]]:
    """The command that predicts with what was found; `brief`: without the band's place, then of one run alone."""
    if out is None or not content.get("simulation", [True]):
        return []
    where = "" if brief else answered.within(content, words)
    head = f"To predict the rig, at loads, speeds and {words.motion}s like those recorded"
    head += f". A plan has an error band within {where}:" if where else ":"
    ids = [entry["id"] for entry in content["mechanisms"]]
    planned = predictions(out / "diagnosis.json", folders, ids)[1::2]  # those of the recorded motion: in the details
    return [[head, *_of_each(planned, brief), *of_staying(ids)]]


def adopt(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, brief: int) -> list[list[str]]:
    """Whether to put the effects into run.yaml, and the command that does; `brief`: of one run alone."""
    if out is None or not content.get("simulation", [True]):
        return []
    whether = advice.of_adopting(content, words)
    what = "To put it into run.yaml, dimensions included:"
    source = shlex.quote(str(out / "diagnosis.json"))
    commands = [f"{command('adopt')} {source} {shlex.quote(str(folder))}" for folder in folders]
    return [[f"{BEFORE_STEP_1 if brief and far_moved(content) else whether} {what}", *_of_each(commands, brief)]]


def remove(folders: list[Path], brief: int) -> list[str]:
    """The command that takes adopted effects out of each run."""
    return _of_each([f"{command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders], brief)


def _of_each(commands: list[str], brief: int) -> list[str]:
    """A command for each run, indented; where the page is short, that of the first run alone."""
    if brief and len(commands) > 1:
        return [f"  {commands[0]}", LIKEWISE]
    return [f"  {line}" for line in commands]
