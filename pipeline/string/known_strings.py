"""Which recorded string a new run may be of: runs of one string must share its name."""

import shlex
import sys
from collections.abc import Callable, Collection
from pathlib import Path

from ..ground.errors import BadInput
from ..run.description import Run, String
from ..run.folder import find_runs, read_run

SIZE = ("material", "radius_mm", "length_mm")
NAMED = 4  # strings, where there are more: so many and the number of the others


def alike(string: String, raw: Path, name: str) -> list[Run]:
    """Runs in `raw`, other than `name`, of a string of the same material and size; unreadable ones left out."""
    same_strings = []
    for folder in find_runs(raw):
        try:
            run = read_run(folder)
        except BadInput:
            continue  # ingest says what is wrong with it
        string_there = run.string
        if run.run != name and string_there and all(getattr(string_there, key) == getattr(string, key) for key in SIZE):
            same_strings.append(run)
    return same_strings


def asked(ids: list[str], ask: Callable[[str], str]) -> str | None:
    """The string that a person names for the new run, or None; `ask` asks a question and returns the answer."""
    for id_ in ids:
        if ask(f"Is it the string {id_!r}, which is of the same material and size? [y/n] ").strip().lower() == "y":
            return id_
    return None


def string_id(string: String, raw: Path, name: str, ask: Callable[[str], str] | None) -> str | None:
    """The string's name for a new run without one: asked for on a terminal, else the message how to give it."""
    ids = list(dict.fromkeys(run.string_id for run in alike(string, raw, name)))
    if not ids:
        return None
    if ask is not None:
        return asked(ids, ask)
    same = _options(ids)
    print(
        f"note: {raw} has {len(ids)} string{'s' if len(ids) > 1 else ''} of the same material and size. This run counts"
        f" as another string. If it is the same one, remove this run and make it again with {same}.",
        file=sys.stderr,
    )
    return None


def imported_as_another(run: Run, raw: Path, apart: Collection[str] = ()) -> str:
    """The remark on an imported run without a string's name, where runs of the same material and size lie beside it.

    The runs `apart` are known to be of other strings.
    """
    others_there = [other for other in alike(run.string, raw, run.run) if other.run not in apart] if run.string else []
    ids = list(dict.fromkeys(other.string_id for other in others_there))
    if not ids or (run.string and run.string.id is not None):
        return ""
    others = f"{', '.join(ids[:NAMED])}{f' and {len(ids) - NAMED} more' if len(ids) > NAMED else ''}"
    yaml = shlex.quote(str(raw / run.run / "run.yaml"))
    return (
        f"note: this counts as another string than {others}, of the same material and size. If it is the same one, "
        f"write `id: {ids[0] if len(ids) == 1 else 'NAME'}` under `string` in {yaml}; the next import of it: "
        f"{_options(ids[:NAMED])}"
    )


def _options(ids: list[str]) -> str:
    return " or ".join(f"--string-id {shlex.quote(id_)}" for id_ in ids)
