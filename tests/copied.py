"""The package in another folder, for tests that add to it: with what was compiled of it, which takes 13 s anew."""

import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def package(folder: Path) -> None:
    """Copy the package into a folder; what another process is writing beside it stays away."""
    ignored = shutil.ignore_patterns("*.pyc*", "*.tmp.*")
    shutil.copytree(ROOT / "pipeline", folder / "pipeline", ignore=ignored)


def checkout(folder: Path) -> None:
    """Copy what a checkout holds beside recordings: the package, its tests without their data, its pages."""
    package(folder)
    for name in ("docs", "tests"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "data", "pictures"))
    for name in ("CONTRIBUTING.md", "README.md", "CHANGELOG.md", "Snakefile", "pyproject.toml"):
        shutil.copy(ROOT / name, folder / name)
