"""Which new recordings can be used: each is read once as ingest reads it, before anything is planned of it.

A recording that ingest would refuse then costs itself alone: no dataset waits for it, and no model is trained again.
"""

import argparse
import contextlib
import io
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..ground.errors import BadInput, program
from ..run.left_out import LeftOut, from_json, to_json

SHOWN = 5  # names of new recordings


def answers(folders: list[Path]) -> dict[str, list[LeftOut]]:
    """By run, why it is refused, or an empty list; a run at which the reading program died has no answer.

    The program is one of its own: what a recording does to it, such as filling the memory, it does not do to the plan.
    """
    refused: dict[str, list[LeftOut]] = {}
    waiting = list(folders)
    project = str(Path(__file__).resolve().parents[2])
    environment = {**os.environ, "PYTHONPATH": project, "TWISTBENCH_PARENT": str(os.getpid())}
    while waiting:
        command = [sys.executable, "-m", f"{__package__}.usable", *map(str, waiting)]
        lines = subprocess.run(command, capture_output=True, text=True, env=environment).stdout.splitlines()
        for folder, line in zip(waiting, lines, strict=False):
            with contextlib.suppress(BadInput):
                refused[folder.name] = from_json(line)
        waiting = waiting[len(lines) + 1 :]  # without the one that it died at
    return refused


def refusals(
    raw: Path, contents: Mapping[str, str], code: str, kept: Any
) -> tuple[dict[str, LeftOut], dict[str, list[str]]]:
    """By run, why it is refused; and what is to be kept for the next start, as it was in `kept`.

    `contents` has a digest of each run's files; a run is read again when that, or the `code` that reads, is new.
    """
    reasons_by_run: dict[str, list[LeftOut]] = {}
    for run, content in contents.items():
        entry = kept.get(run) if isinstance(kept, dict) else None
        if isinstance(entry, list) and len(entry) == 3 and entry[:2] == [content, code]:
            with contextlib.suppress(BadInput, AttributeError):
                reasons_by_run[run] = from_json(entry[2])
    new = [raw / run for run in contents if run not in reasons_by_run]
    if new:
        names = ", ".join(folder.name for folder in new[:SHOWN]) + (", …" if len(new) > SHOWN else "")
        print(f"read once before the plan, new or changed: {len(new)} ({names})", file=sys.stderr, flush=True)
    reasons_by_run |= answers(new)
    refused = {run: why[0] for run, why in reasons_by_run.items() if why}
    return refused, {run: [contents[run], code, to_json(why)] for run, why in reasons_by_run.items()}


@program
def main() -> None:
    """Print, a line of JSON a run, why ingest would refuse it: an empty list for one that it takes."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("run_dir", type=Path, nargs="+")
    from ..run.samples import stored_strokes

    for folder in parser.parse_args().run_dir:
        refused: list[LeftOut] = []
        with contextlib.redirect_stderr(io.StringIO()):  # its warnings stand in the log of ingest
            try:
                with TemporaryDirectory() as temporary:
                    stored_strokes(folder, Path(temporary) / "samples.parquet")
            except BadInput as error:
                refused = [LeftOut.of(folder.name, error)]
        print(to_json(refused), flush=True)


if __name__ == "__main__":
    main()
