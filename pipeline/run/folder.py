"""A run folder, `raw/<run>/` with `run.yaml` and one recording: find it, read it, check it."""

import json
import os
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import read_yaml
from ..ground.names import SYNTHETIC, SYNTHETIC_DEVICE, checked, own_material
from ..ground.stored.regular_file import read_regular
from ..ground.words.unfinished import mend_of_unfinished
from .capture_json import CaptureJson
from .description import Run, parse_run

CAPTURED = ("recording.frames", "recording.lines")  # what the capture program writes while it runs
MOST_SAMPLES = 2**53  # in a recording: more than any that there is
LARGEST_INFO = 10_000_000  # bytes of a capture.json
RECORDINGS = ("recording.frames", "recording.parquet", "recording.csv", "recording.csv.gz")


def read_run(folder: Path | str) -> Run:
    """Read and check `run.yaml` of a run folder; raises BadInput."""
    path = Path(folder) / "run.yaml"
    if not os.path.lexists(path):
        raise BadInput(path.parent, "run.yaml", "is missing", _mend_of_undescribed(path.parent))
    run = parse_run(read_yaml(path), path)
    if run.string and run.string.material == SYNTHETIC and _of_another_rig(path.parent):
        checked(own_material, run.string.material, path, "string.material")
    return run


def described(folder: Path) -> Run | None:
    """The description of the run in a folder; None where there is none that can be read."""
    try:
        return read_run(folder)
    except BadInput:
        return None


def _mend_of_undescribed(folder: Path) -> str:
    """The mend of a folder without a `run.yaml`; of a recording that nobody described with its name."""
    if not any((folder / name).is_file() for name in (*CAPTURED, *RECORDINGS)):
        return f"write it with {command('new_run')}"
    name, out = shlex.quote(folder.name), shlex.quote(str(folder.parent))
    place = "" if out == "raw" else f" --out {out}"
    return (
        f"write it with {command('new_run')} {name}{place} and the string's sizes, or move the folder to another place "
        "if it is no run"
    )


def _of_another_rig(folder: Path) -> bool:
    """Whether a run folder holds a recording of another rig than the synthetic one."""
    info = capture_info(folder)
    if not info:
        return any((folder / name).is_file() for name in RECORDINGS[1:])
    hello = info.get("hello")
    return not isinstance(hello, dict) or hello.get("device") != SYNTHETIC_DEVICE


def has_recording(folder: Path) -> bool:
    """Whether a run folder holds a file named like a recording, complete or not."""
    return any((folder / name).exists() for name in RECORDINGS)


def is_recorded(folder: Path) -> bool:
    """Whether a run folder holds a recording that was finished."""
    return has_recording(folder) and not unfinished(folder)


def recording_path(folder: Path | str) -> Path:
    """The one recording of a run folder; raises BadInput when there is none, more than one, or it is unfinished."""
    folder = Path(folder)
    if unfinished(folder):
        problem = "is missing, so the recording is unfinished"
        raise BadInput(folder, "capture.json", problem, mend_of_unfinished(folder))
    paths = [folder / name for name in RECORDINGS if (folder / name).is_file()]
    if not paths:
        raise BadInput(folder, "recording", "is missing", f"put one of {', '.join(RECORDINGS)} there")
    if len(paths) > 1:
        names = " and ".join(path.name for path in paths)
        raise BadInput(folder, "recording", f"is there more than once ({names})", "keep one")
    return paths[0]


def unfinished(folder: Path) -> bool:
    """Whether a capture into a run folder is under way, or was cut off."""
    return any((folder / name).is_file() for name in CAPTURED) and not (folder / "capture.json").is_file()


def capture_info(folder: Path | str) -> CaptureJson:
    """Content of `capture.json`; empty for a run that the capture program did not record; raises BadInput."""
    path = Path(folder) / "capture.json"
    if not os.path.lexists(path):
        return {}
    try:
        info = json.loads(read_regular(path, LARGEST_INFO, "capture.json"))
    except (ValueError, RecursionError):
        info = None
    if not isinstance(info, dict):
        raise BadInput(path, "capture.json", "is not what the capture program writes", "restore it, or use --recover")
    return cast(CaptureJson, info)


def started_utc(folder: Path | str) -> str:
    """The start of a run, from the capture program; None for a run that it did not record; raises BadInput."""
    return str(capture_info(folder).get("started_utc", ""))


def checked_info(folder: Path | str) -> CaptureJson:
    """Content of `capture.json` whose losses are as the capture program lists them; raises BadInput."""
    path, info = Path(folder) / "capture.json", capture_info(folder)
    for field in ("gaps", "holes"):
        losses = info.get(field, [])
        if not isinstance(losses, list) or not all(map(_is_loss, losses)):
            problem = "is no list of losses, each with its after_samples"
            raise BadInput(path, field, problem, "restore it from a copy; it is never edited")
    return info


def _is_loss(entry: Any) -> bool:
    """Whether an entry of `gaps` or `holes` says after how many samples something was lost."""
    after = entry.get("after_samples") if isinstance(entry, dict) else None
    return isinstance(after, int) and not isinstance(after, bool) and 0 <= after <= MOST_SAMPLES


def find_runs(raw: Path | str) -> Iterator[Path]:
    """Run folders under `raw/`, sorted by name, hidden ones left out: those that hold a `run.yaml` or a recording.

    A folder that may not be looked into counts as one: reading its `run.yaml` says what is wrong.
    """
    try:
        names = sorted(name for name in os.listdir(raw) if not name.startswith("."))
    except FileNotFoundError:
        return
    for folder in (Path(raw, name) for name in names):
        if os.path.isdir(folder) and _holds_a_run(folder):
            yield folder


def _holds_a_run(folder: Path) -> bool:
    try:
        return not {"run.yaml", *CAPTURED, *RECORDINGS}.isdisjoint(os.listdir(folder))
    except OSError:
        return True
