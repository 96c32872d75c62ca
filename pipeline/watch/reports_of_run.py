"""What reports/ has to say of a run: verdicts, pages, and the strokes that are left by the lifespan forecast."""

import contextlib
import json
import os
from pathlib import Path
from typing import Any

LARGEST = 1_000_000  # bytes of a file that is looked into
PAGES = ("diagnosis.html", "diagnosis.pdf", "verdict.txt")  # of a diagnosis, the first that is there
MOST = 500  # runs that are listed


def _text(path: Path) -> str:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read(LARGEST)
    except OSError:
        return ""


def _names(folder: Path) -> list[str]:
    try:
        return sorted(name for name in os.listdir(folder) if not name.startswith("."))[:MOST]
    except OSError:
        return []


def verdicts(reports: Path) -> list[dict[str, str]]:
    """Each diagnosed run with the first line of its verdict, and where its page lies below reports/."""
    verdict_list = []
    for name in _names(reports / "diagnosis"):
        folder = reports / "diagnosis" / name
        lines = _text(folder / "verdict.txt").splitlines()
        if lines:
            page = _page(folder).relative_to(reports).as_posix()
            verdict_list.append({"run": name, "verdict": lines[0][:300], "page": page})
    return verdict_list


def _newest_first(reports: Path, *names: str) -> list[Path]:
    """Where reports/ has a file `names[-1]` in a folder `names[0]`, or in one of that name a level lower."""
    places = [reports, *(reports / name for name in _names(reports))]
    changed = []
    for path in (place.joinpath(*names) for place in places):
        with contextlib.suppress(OSError):
            changed.append((path.stat().st_mtime, path))
    return [path for _, path in sorted(changed, reverse=True)]


def newest_verdict(reports: Path, run: str) -> dict[str, str] | None:
    """The first line of a run's newest verdict, with the page of its diagnosis by its path below reports/."""
    for path in _newest_first(reports, run, "diagnosis.json"):
        lines = _text(path.parent / "verdict.txt").splitlines()
        if lines:
            return {"verdict": lines[0][:300], "page": _page(path.parent).relative_to(reports).as_posix()}
    return None


def _page(folder: Path) -> Path:
    """What of a diagnosis a person reads."""
    return next(folder / page for page in PAGES if (folder / page).is_file())


def strokes_left(reports: Path, string: str) -> dict[str, Any] | None:
    """Low, median and high of the earliest question of a string's newest lifespan.json, and its path below reports/.

    None where there is none.
    """
    for path in _newest_first(reports, string, "lifespan.json"):
        try:
            content = json.loads(_text(path))
            left = content["questions"][content["first"]]["strokes_left"]
            numbers = {name: None if left[name] is None else float(left[name]) for name in ("low", "median", "high")}
            return {**numbers, "file": path.relative_to(reports).as_posix()}
        except (ValueError, KeyError, TypeError, RecursionError):
            continue
    return None
