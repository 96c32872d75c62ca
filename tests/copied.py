"""The package in another folder, for tests that add to it: with what was compiled of it, which takes 13 s anew."""

import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def package(folder: Path) -> None:
    """Copy the package into a folder; what another process is writing beside it stays away."""
    ignored = shutil.ignore_patterns("*.pyc*", "*.tmp.*")
    shutil.copytree(ROOT / "pipeline", folder / "pipeline", ignore=ignored)
