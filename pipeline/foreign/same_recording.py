"""A run that holds the recording of another one: read the same way, its strokes would count twice."""

import filecmp
import shlex
import sys
from pathlib import Path

from ..ground.errors import BadInput
from ..run.folder import find_runs, read_run, recording_path


def warn_of_copies(folder: Path) -> None:
    """Say on standard error which runs beside a run hold its recording; raises BadInput as `same_recording` does."""
    if sentence := same_recording(folder):
        print(f"warning: {sentence}", file=sys.stderr)


def same_recording(folder: Path) -> str:
    """A sentence on the runs beside one with the same recording, byte by byte, and the same reading; else empty.

    Runs that read other rows or columns of one log are no copies. Raises BadInput where the run itself cannot be read.
    """
    run, recording = read_run(folder), recording_path(folder)
    copies = []
    for other in find_runs(folder.parent):
        try:
            described, file = read_run(other), recording_path(other)
        except BadInput:
            continue  # ingest says what is wrong with it
        if other.name == folder.name or (described.file, described.channels) != (run.file, run.channels):
            continue
        if filecmp.cmp(file, recording, shallow=False):
            copies.append(described)
    if not copies:
        return ""
    names = " and ".join(copy.run for copy in copies)
    of_string = any(copy.string_id == run.string_id for copy in copies if copy.string and run.string)
    counts = ", of the same string: its strokes count twice there" if of_string else ""
    mend = f"if it is no second recording, remove {shlex.quote(str(folder))}"
    return f"{folder}: the recording is byte by byte that of {names}{counts}; {mend}"
