"""The warning before a recording begins in a folder without a described string, often a slip of the hand."""

from pathlib import Path

from ..ground.errors import BadInput
from ..run.folder import CAPTURED, RECORDINGS, read_run

NAMED = 3


def warn_undescribed(folder: Path) -> None:
    """Say where a run's run.yaml is missing or cannot be read, and which folder may have been meant."""
    try:
        read_run(folder)
    except BadInput as error:
        meant = f" Did you mean {' or '.join(waiting)}?" if (waiting := _waiting(folder)) else ""
        print(  # the mend is said at the end, where nobody needs to hurry
            f"warning: {error.file}: {error.field}: {error.problem}. It can be recorded all the same.{meant}",
            flush=True,
        )


def _waiting(folder: Path) -> list[str]:
    """The runs in a folder and beside it that are described and not recorded yet, the newest first."""
    places = [place for place in (folder, folder.parent) if place.is_dir()]
    described = {path.parent: path.stat().st_mtime for place in places for path in place.glob("*/run.yaml")}
    empty = [run for run in described if not any((run / name).exists() for name in (*CAPTURED, *RECORDINGS))]
    return [str(run) for run in sorted(empty, key=lambda run: -described[run])[:NAMED]]
