"""Run folders on a command line: each with its own name, and none twice."""

import os
from pathlib import Path

from ..ground.errors import BadInput


def run_dir(text: str) -> Path:
    """A folder by a path that ends in its name: `.` becomes the current folder; `..`, which nobody means, stays."""
    return Path(text) if Path(text).name else Path(os.path.abspath(text))


def real_name(folder: Path) -> str:
    """The real name of a folder, for the names of its results: of a link, the name of its target."""
    return Path(os.path.realpath(folder)).name


def refuse_twice(folders: list[Path], why: str) -> None:
    """Raise BadInput where a folder is given twice, also by two paths; `why` tells the consequence."""
    real_folders = [Path(os.path.realpath(folder)) for folder in folders]
    for folder in real_folders:
        if real_folders.count(folder) > 1:
            raise BadInput(folder, "run_dir", "is named twice", f"name each run once: {why}")
