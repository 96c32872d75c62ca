"""Run folders as a command line names them: each by its own name, and none twice."""

import os
from pathlib import Path

from ..ground.errors import BadInput


def run_dir(text: str) -> Path:
    """A folder by a path that ends in its name: `.` is the folder that it is. Nobody means `..`, which stays."""
    return Path(text) if Path(text).name else Path(os.path.abspath(text))


def real_name(folder: Path) -> str:
    """The name of a folder, as that of what is made of it: that of where a link leads."""
    return Path(os.path.realpath(folder)).name


def refuse_twice(folders: list[Path], why: str) -> None:
    """Raise BadInput where a folder is named twice, also by two paths; `why` says what would come of it."""
    real_folders = [Path(os.path.realpath(folder)) for folder in folders]
    for folder in real_folders:
        if real_folders.count(folder) > 1:
            raise BadInput(folder, "run_dir", "is named twice", f"name each run once: {why}")
