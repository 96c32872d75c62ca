"""Which new recordings can be used: each is read as ingest reads it, before anything is planned of it.

A recording that ingest would refuse then costs itself alone: no dataset waits for it, and no model is trained again.
What was read is kept for ingest, which takes it over: a recording is decoded once.
"""

import argparse
import contextlib
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..ground.errors import BadInput, program
from ..ground.words.left_out import LeftOut, from_json, to_json

SHOWN = 5  # names of new recordings
AT_ONCE = 1000  # runs that one program reads: a command line has a longest


def answers(bound: Mapping[Path, str], place: Path | None = None) -> dict[str, list[LeftOut]]:
    """By run, why it is refused, or an empty list; a run at which the reading program died has no answer.

    `bound` has the word of each run's folder under which its reading is kept in `place`; without a place none is kept.
    The program is one of its own: what a recording does to it, such as filling the memory, it does not do to the plan.
    """
    refused: dict[str, list[LeftOut]] = {}
    waiting = list(bound)
    project = str(Path(__file__).resolve().parents[2])
    environment = {**os.environ, "PYTHONPATH": project, "TWISTBENCH_PARENT": str(os.getpid())}
    while batch := waiting[:AT_ONCE]:
        command = [sys.executable, "-m", f"{__package__}.usable_recordings", *map(str, batch)]
        command += ["--keep", str(place), *(f"--of={bound[folder]}" for folder in batch)] if place else []
        lines = subprocess.run(command, capture_output=True, text=True, env=environment).stdout.splitlines()
        for folder, line in zip(batch, lines, strict=False):
            with contextlib.suppress(BadInput):
                refused[folder.name] = from_json(line)
        waiting = waiting[min(len(lines) + 1, len(batch)) :]  # without the one that it died at
    return refused


def refusals(
    raw: Path, contents: Mapping[str, str], code: str, kept: Any, place: Path | None = None
) -> tuple[dict[str, LeftOut], dict[str, list[str]]]:
    """By run, why it is refused; and what is to be kept for the next start, as it was in `kept`.

    `contents` has a digest of each run's files; a run is read again when that, or the `code` that reads, is new.
    Readings are kept in `place`, if one is given, for ingest; those of runs that are gone are removed.
    """
    reasons_by_run: dict[str, list[LeftOut]] = {}
    for run, content in contents.items():
        entry = kept.get(run) if isinstance(kept, dict) else None
        if isinstance(entry, list) and len(entry) == 3 and entry[:2] == [content, code]:
            with contextlib.suppress(BadInput, AttributeError):
                reasons_by_run[run] = from_json(entry[2])
    for folder in place.glob("*") if place else ():
        if folder.name not in contents:
            shutil.rmtree(folder, ignore_errors=True)
    new = [raw / run for run in contents if run not in reasons_by_run]
    if new:
        names = ", ".join(folder.name for folder in new[:SHOWN]) + (", …" if len(new) > SHOWN else "")
        print(f"read once before the plan, new or changed: {len(new)} ({names})", file=sys.stderr, flush=True)
    reasons_by_run |= answers({folder: f"{contents[folder.name]} {code}" for folder in new}, place)
    refused = {run: why[0] for run, why in reasons_by_run.items() if why}
    return refused, {run: [contents[run], code, to_json(why)] for run, why in reasons_by_run.items()}


def _writable(place: Path) -> bool:
    """Whether a folder is there, or can be made, to write in: no recording is refused for that."""
    with contextlib.suppress(OSError):
        place.mkdir(parents=True, exist_ok=True)
        return os.access(place, os.W_OK | os.X_OK)
    return False


@program
def main() -> None:
    """Print, a line of JSON a run, why ingest would refuse it: an empty list for one that it takes."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("run_dir", type=Path, nargs="+")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="keep what is read here; default: nothing is kept")
    parser.add_argument(
        "--of", action="append", default=[], help="the word of each run under which its reading is kept"
    )
    arguments = parser.parse_args()
    from ..run.read_ahead import keep

    place = arguments.keep if arguments.keep and _writable(arguments.keep) else None
    words = [*arguments.of, *[""] * len(arguments.run_dir)]
    for folder, bound_to in zip(arguments.run_dir, words, strict=False):
        refused: list[LeftOut] = []
        try:
            with TemporaryDirectory() as temporary:
                keep(folder, place or Path(temporary), bound_to)
        except BadInput as error:
            refused = [LeftOut.of(folder.name, error)]
        print(to_json(refused), flush=True)


if __name__ == "__main__":
    main()
