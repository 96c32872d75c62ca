"""Run folders → the health of every string in them."""

from pathlib import Path
from tempfile import TemporaryDirectory

from ..ground.words.progress import steps
from ..run.folder import has_recording
from ..run.run_arguments import refuse_twice
from ..string.from_raw import read_long
from ..string.history import Recorded
from ..string.jumps_beside import runs_naming
from .stroke_health.health import Health, health


def strings(folders: list[Path], scratch: Path | None = None) -> list[Health]:
    """Health of every string in run folders; raises BadInput.

    While they are read, the samples of long recordings lie in a temporary folder, under `scratch` where it is given.
    """
    runs: dict[str, list[Recorded]] = {}
    refuse_twice(folders, "its strokes would count twice")
    with TemporaryDirectory(prefix=".samples-", dir=scratch) as temporary:
        for number, folder in enumerate(steps(folders, "run read")):
            recorded = read_long(folder, Path(temporary) / f"{number}.parquet")
            runs.setdefault(recorded.run.string_id, []).append(recorded)
        return [health(of_one) for of_one in runs.values()]


def others_beside(string: str, folders: list[Path]) -> list[Path]:
    """Runs of a string beside the given ones that were left out: their strokes are missing in the answer."""
    own_folders = {folder.resolve() for folder in folders}
    places = {folder.resolve().parent: folder.parent for folder in folders}
    return [
        run
        for place in sorted(places.values())
        for run in runs_naming(place, {string}, own_folders)
        if has_recording(run)
    ]
