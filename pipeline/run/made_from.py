"""Which files of a run something was made from, by size and content: whether they changed since is told from them.

Ingest notes the files of its run, and the stage of the dataset gathers these notes for the runs of a material.
"""

import hashlib
import json
import os
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import TypedDict

from ..ground.errors import BadInput
from ..ground.input.strict_yaml import parse_yaml
from ..ground.stored.files import sha256
from ..ground.stored.notes import read_note, write_note
from .folder import RECORDINGS

NAME = "made_from.json"  # of the note beside the dataset of a material
OF_RUN = "read_from.json"  # of the note beside the tables of a run: of one name, no rule would know which it is
LARGEST = 100_000_000  # bytes of a note
DESCRIPTION = "run.yaml"
FILES = (DESCRIPTION, *RECORDINGS)  # of a run folder; capture.json, which says when it was, would part equal tables
NOT_OF_POINTS = {"simulation", "adopted"}  # sections of run.yaml that change no point: what a diagnosis found


class FileSeen(TypedDict):
    """What a note says of one file."""

    bytes: int
    sha256: str


RunSeen = dict[str, FileSeen]  # by the file's name


def note_run(folder: Path, path: Path) -> None:
    """Write the note on the files of a run folder."""
    seen: RunSeen = {}
    for file in (folder / name for name in FILES):
        with suppress(OSError):  # it is not there, or ingest says that it cannot be read
            seen[file.name] = {"bytes": file.stat().st_size, "sha256": _digest(file)}
    write_note(path, seen)


def note_runs(runs: Sequence[str], processed: Path, path: Path) -> None:
    """Write the note on the runs of a material from the notes of ingest; a run without one is absent."""
    notes = {run: processed / run / OF_RUN for run in runs}
    write_note(path, {run: read_note(note, LARGEST) for run, note in notes.items() if note.is_file()})


def read_runs(path: Path) -> dict[str, RunSeen]:
    """The note on the runs of a material; raises BadInput."""
    runs: dict[str, RunSeen] = read_note(path, LARGEST)
    return runs


def changed_files(folder: Path, seen: RunSeen, noted_s: float) -> list[str]:
    """Names of the files of a run folder that are not what a note has seen, also those that came or went.

    `noted_s` is when it was noted: a recording of the same size that is no younger is not read.
    """
    now = [name for name in FILES if (folder / name).is_file()]
    both = [name for name in now if name in seen]
    changed = {name for name in both if _is_changed(folder / name, seen[name], noted_s)}
    return [name for name in FILES if name in changed or (name in now) != (name in seen)]


def _is_changed(file: Path, seen: FileSeen, noted_s: float) -> bool:
    """Whether a file's content is another than what was seen."""
    if file.name == DESCRIPTION:
        return _digest(file) != seen["sha256"]
    stat = os.stat(file)
    if stat.st_size != seen["bytes"]:
        return True
    older = max(stat.st_mtime, stat.st_ctime) < noted_s
    return not older and sha256(file) != seen["sha256"]


def _digest(file: Path) -> str:
    """The check sum of a file; of run.yaml that of the sections which points are made of, if it can be read."""
    if file.name != DESCRIPTION:
        return sha256(file)
    text = file.read_bytes()
    try:
        content = parse_yaml(text.decode("utf-8"), file)
    except (BadInput, UnicodeDecodeError):
        content = None
    if not isinstance(content, dict):
        return hashlib.sha256(text).hexdigest()
    kept = {str(key): value for key, value in content.items() if key not in NOT_OF_POINTS}
    return hashlib.sha256(json.dumps(kept, default=str, sort_keys=True).encode()).hexdigest()
