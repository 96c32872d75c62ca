"""The other runs of a joint diagnosis: beside the one that adopts it, and still without its effects."""

import shlex
from pathlib import Path

from ...ground.command import command
from ...run.folder import read_run
from ..document.content import Simulated
from ..prediction.later_run import places_beside
from ..words.language.quantity import listing


def for_others(content: Simulated, run: str, folder: Path, source: Path) -> list[str]:
    """The commands that put a diagnosis of several runs into the others of them too, below a sentence; or nothing.

    `folder` holds the run that has adopted the diagnosis at `source`. Raises BadInput for a run.yaml that is none.
    """
    together = content.get("run")
    names = [name for name in together if name != run] if isinstance(together, list) and run in together else []
    places = [folder.parent / place.name for place in places_beside(folder, names)]
    without = [place for place in places if read_run(place).simulation != content["simulation"]]
    if not without:
        return []
    lack = f"{listing([place.name for place in without])} {'lacks' if len(without) == 1 else 'lack'} these effects"
    why = f"The verdict is of {len(names) + 1} runs together, and {lack}. A joint diagnosis needs the same in all runs:"
    return [why, *(f"  {command('adopt')} {shlex.quote(str(source))} {shlex.quote(str(place))}" for place in without)]
