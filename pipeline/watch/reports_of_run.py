"""The files in reports/: the diagnosed runs with their pages, and the newest file of a name."""

import contextlib
import os
from pathlib import Path

from ..ground.words.verdict_text import headline

LARGEST = 1_000_000  # bytes of a file that is looked into
PAGES = ("diagnosis.html", "diagnosis.pdf", "verdict.txt")  # of a diagnosis, the first that is there
MOST = 500  # runs that are listed


def text_of(path: Path) -> str:
    """A file's text, bounded; empty where it cannot be read."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read(LARGEST)
    except OSError:
        return ""


def names_in(folder: Path) -> list[str]:
    """The names in a folder without hidden ones, bounded; nothing where it cannot be read."""
    try:
        return sorted(name for name in os.listdir(folder) if not name.startswith("."))[:MOST]
    except OSError:
        return []


def verdicts(reports: Path) -> list[dict[str, str]]:
    """Each diagnosed run with the first words of its verdict, and the path of its page below reports/."""
    verdict_list = []
    for name in names_in(reports / "diagnosis"):
        folder = reports / "diagnosis" / name
        if verdict := headline(text_of(folder / "verdict.txt")):
            page = page_of(folder).relative_to(reports).as_posix()
            verdict_list.append({"run": name, "verdict": verdict, "page": page})
    return verdict_list


def newest_first(reports: Path, *names: str) -> list[Path]:
    """Where reports/ has a file `names[-1]` in a folder `names[0]`, or in one of that name a level lower."""
    places = [reports, *(reports / name for name in names_in(reports))]
    changed = []
    for path in (place.joinpath(*names) for place in places):
        with contextlib.suppress(OSError):
            changed.append((path.stat().st_mtime, path))
    return [path for _, path in sorted(changed, reverse=True)]


def page_of(folder: Path) -> Path:
    """The page of a diagnosis for a person."""
    return next(folder / page for page in PAGES if (folder / page).is_file())
