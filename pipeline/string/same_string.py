"""The other runs of a run's string beside it: their names, and their statements on the zero."""

import re
from pathlib import Path

from ..ground.errors import BadInput
from ..run.description import Run
from ..run.folder import is_recorded, read_run
from ..run.mend_command import tare_command
from .history import natural
from .jumps_beside import runs_naming

NAMED = 4  # runs, where there are more: so many and the number of the others


def others_recorded(folder: Path, run: Run, like: Path | None = None) -> list[Path]:
    """The recorded runs of the same string in the same folder of runs, 2 before 10, without the run itself.

    The run that it was made `like` may lie elsewhere.
    """
    beside = list(runs_naming(folder.parent, {run.string_id}, {folder.resolve()})) if run.string else []
    if like is not None and like.resolve().parent != folder.resolve().parent:
        beside.append(like)
    return sorted(filter(is_recorded, beside), key=lambda other: natural(other.name))


def next_name(folder: Path) -> str:
    """A free name for the next run beside one: example-2 after example-1, lot-08 after lot-07, lot-2 after lot."""
    numbered = re.fullmatch(r"(.*-)?(\d+)", folder.name)
    head, digits = (numbered[1] or "", numbered[2]) if numbered else (f"{folder.name}-", "1")
    number = int(digits) + 1
    while (folder.parent / f"{head}{number:0{len(digits)}}").exists():
        number += 1
    return f"{head}{number:0{len(digits)}}"


def tares(folder: Path, run: Run, others: list[Path]) -> str:
    """The statements of a new run and the others of its string on their zero, and what to do if they are wrong."""
    by_tare: dict[str, list[str]] = {}
    anew: list[str] = []
    for other in others:
        try:
            beside = read_run(other)
        except BadInput:
            continue  # ingest says what is wrong with it
        by_tare.setdefault(_tare(beside), []).append(other.name)
        anew += [other.name] if beside.tare == "run" else []
    each = "; ".join(f"{tare} in {_listed(names)}" for tare, names in sorted(by_tare.items(), reverse=True))
    if run.tare == "run":
        own = f"{run.run} has `tare: run`: its sensor was set to zero since the run before"
        return f"The zero, by run.yaml: {each}; {own}."
    if run.tare == "checked":
        own = f"{run.run} has `tare: checked`: its sensor was checked and has the zero of the run before"
        return f"The zero, by run.yaml: {each}; {own}."
    likely = f", as that of {anew[-1]} was" if anew else ""
    own = f"{run.run} has {_tare(run)}: its sensor still has the zero of the run before"
    return (
        f"The zero, by run.yaml: {each}; {own}. If it was set to zero since{likely}, add `tare: run` to its run.yaml: "
        f"{tare_command(folder, 'run')}"
    )


def _tare(run: Run) -> str:
    """The statement of a run on its zero, and whether its run.yaml leaves it out."""
    return f"`tare: {run.tare}`" + ("" if "tare" in run.model_fields_set else " (the default)")


def _listed(names: list[str]) -> str:
    more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return ", ".join(names[-NAMED:]) + more
