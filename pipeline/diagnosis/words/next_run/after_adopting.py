"""What to record once more after effects were adopted, so that their names are weighed again."""

import shlex
from pathlib import Path

from ....ground.command import command
from ...document.content import Verdict
from ...mechanisms.library import mechanisms
from ..language.explained_words import tells
from ..language.quantity import listing
from ..language.vocabulary import Vocabulary
from ..named.missing_signs import missing
from . import commands, recipe
from .make_sure import again

ANEW = (
    "What is adopted is not weighed again, and --like copies it. So record the run, then take it out of each run, and "
    "diagnose all together{}"
)


def of_adopted(
    content: Verdict, words: Vocabulary, ids: list[str], folders: list[Path], short: bool
) -> list[list[str]]:
    """The recording that would confirm adopted effects: the loads and speeds that no recording of them had."""
    of_several = {
        id_ for each in content.get("adopted", []) if len(each.get("runs") or []) > 1 for id_ in each["effects"]
    }  # what a diagnosis of several runs named, this recording alone does not doubt
    lacking = {id_: missing(content, words, id_) for id_ in ids if id_ in mechanisms() and id_ not in of_several}
    lines = [f"- {id_}: {tells(id_, words)}." for id_, lacks in lacking.items() if lacks]
    if not lines:
        return []
    head = "Still open since adopting, if you need to be surer of a name: this recording has no second"
    lacked = listing(list(dict.fromkeys(what for lacks in lacking.values() for what in lacks)), "and no second")
    load = recipe.to_type(content, words, list(lacking))
    run = recipe.sentence(content, words, list(lacking))
    return [[f"{head} {lacked}.", *lines, *([run] if run else []), *anew(folders, load, words, short)]]


def anew(folders: list[Path], load: str, words: Vocabulary, short: bool) -> list[str]:
    """How to record the rig again so that adopted effects are weighed anew; `load` is another load to hang.

    `short`: without the commands, which the details have.
    """
    if short:
        return [ANEW.format(" (commands: details.txt).")]
    *recorded_anew, diagnose = commands.lines(folders, None, [load])
    runs = [*folders, folders[-1].with_name(f"{folders[-1].name}-next")]
    removed = [f"{command('adopt')} --remove {shlex.quote(str(folder))}" for folder in runs]
    return [
        ANEW.format(":"),
        *(f"  {line}" for line in (*recorded_anew, *removed, diagnose)),
        again(folders[-1], load, words),
    ]
