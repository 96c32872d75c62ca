"""What lies in `raw/` and not in a dataset of `processed/` beside it: one line, with what makes it anew."""

import json
import os
import shlex
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from ...ground.command import command, make_command
from ...ground.errors import BadInput
from ...ground.words.counts import are, listing
from ...run.description import STRING_ACTUATORS
from ...run.folder import RECORDINGS, find_runs, is_recorded, read_run
from ...run.made_from import NAME, changed_files, read_runs
from .saved_files import PROCESSED, RAW, WORKFLOW, material_of

KNOWN = Path(".snakemake/known_files.json")  # where the main job notes at each start which recordings it cannot use
NAMED = 3  # runs that are named


class Newer(NamedTuple):
    """Runs whose `run.yaml`, and whose recording, changed since a dataset was made, that are gone, and that are new."""

    described: list[str]
    recorded: list[str]
    gone: list[str]
    new: list[str]


def beware_of_newer(dataset: Path) -> str:
    """A line on what changed or was added in `raw/` since a dataset was made, with the mend; empty where nothing was.

    Empty as well where the dataset lies in no folder of `processed/`, or was made by an earlier version. Outside of a
    checkout a person names the runs: those that were not named, or lie elsewhere, are not missed.
    """
    try:
        material, place = material_of(dataset), dataset.resolve()
        if not material or place.name != "dataset.parquet":
            return ""
        root, note = place.parents[2], place.with_name(NAME)
        is_checkout = (root / WORKFLOW).exists()
        if not all(path.exists() for path in (root / RAW, note)):
            return ""
        newer = _newer(root, material, note)
        make = make_command(PROCESSED / material / place.name) if is_checkout else _made_of(read_runs(note))
        if not is_checkout:
            newer = newer._replace(new=[])
        if not make or (newer.gone and not is_checkout):
            return ""
    except (BadInput, OSError, ValueError, LookupError, TypeError, AttributeError):
        return ""  # whoever reads the dataset says what is wrong with its path, the main job what is with the note
    parts = [f"run.yaml of {_names(newer.described)} changed"] if newer.described else []
    parts += [f"the recording of {_names(newer.recorded)} changed"] if newer.recorded else []
    parts += [f"{_names(newer.gone)} {are(len(newer.gone))} gone from {RAW}/"] if newer.gone else []
    parts += [f"{_names(newer.new)} in {RAW}/ {are(len(newer.new))} not in it"] if newer.new else []
    if not parts:
        return ""
    to_root = "" if Path.cwd() == root else f"cd {shlex.quote(str(root))} && "
    return f"beware: {dataset} was made before this: {listing(parts)}. To make it anew: {to_root}{make}"


def _made_of(runs: Iterable[str]) -> str:
    """The command that makes a dataset of runs in `raw/`."""
    return f"{command('dataset')} {' '.join(shlex.quote(str(RAW / run)) for run in sorted(runs))}"


def _newer(root: Path, material: str, note: Path) -> Newer:
    """What changed since a note was written; raises BadInput, OSError, and other errors for a note of other content."""
    seen, noted_s = read_runs(note), os.stat(note).st_mtime
    changed = {run: changed_files(root / RAW / run, files, noted_s) for run, files in seen.items()}
    gone = [run for run in seen if not (root / RAW / run).is_dir()]
    described = [run for run, names in changed.items() if run not in gone and "run.yaml" in names]
    recorded = [run for run, names in changed.items() if run not in gone and set(RECORDINGS).intersection(names)]
    new = [
        folder.name
        for folder in find_runs(root / RAW)
        if folder.name not in seen and _is_of(folder, material) and not _is_refused(root, folder)
    ]
    return Newer(described, recorded, gone, new)


def _is_of(folder: Path, material: str) -> bool:
    """Whether a folder holds a finished recording of a material."""
    try:
        run = read_run(folder)
        string = run.string if run.actuator in STRING_ACTUATORS else None
        return string is not None and string.material == material and is_recorded(folder)
    except (BadInput, OSError):
        return False  # the main job leaves it out


def _is_refused(root: Path, folder: Path) -> bool:
    """Whether the main job could not use a recording when it last started, and it is still the same."""
    try:
        noted_s = os.stat(root / KNOWN).st_mtime
        refusals = json.loads((root / KNOWN).read_text(encoding="utf-8"))["notes"]["usable"][folder.name][2]
        times = [time for file in folder.iterdir() for time in (file.stat().st_mtime, file.stat().st_ctime)]
        return bool(json.loads(refusals)) and max(times) < noted_s
    except (OSError, ValueError, LookupError, TypeError):
        return False


def _names(runs: list[str]) -> str:
    """Some runs by name, and how many more."""
    ordered = sorted(runs)
    last = ordered[NAMED:] and f"{len(ordered) - NAMED} more"
    return listing([*ordered[:NAMED], last] if last else ordered)
