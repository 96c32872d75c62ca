"""What is said before a recording begins into a folder whose string nobody has described: a slip of the hand, often."""

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
        kept = f"It is recorded into {folder} all the same; until then nothing can use it."
        print(f"warning: {error} {kept}{meant}", flush=True)


def _waiting(folder: Path) -> list[str]:
    """The runs in a folder and beside it that are described and not recorded yet, the newest first."""
    places = [place for place in (folder, folder.parent) if place.is_dir()]
    described = {path.parent: path.stat().st_mtime for place in places for path in place.glob("*/run.yaml")}
    empty = [run for run in described if not any((run / name).exists() for name in (*CAPTURED, *RECORDINGS))]
    return [str(run) for run in sorted(empty, key=lambda run: -described[run])[:NAMED]]
