"""What reports/ has to say of a run: verdicts, pages, and the strokes that are left by the lifespan forecast."""

import json
import os
from pathlib import Path
from typing import Any

LARGEST = 1_000_000  # bytes of a file that is looked into
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
            pages = ("diagnosis.html", "diagnosis.pdf", "verdict.txt")
            page = next(page for page in pages if (folder / page).is_file())
            verdict_list.append({"run": name, "verdict": lines[0][:300], "page": f"diagnosis/{name}/{page}"})
    return verdict_list


def strokes_left(reports: Path, string: str) -> dict[str, Any] | None:
    """Low, median and high of the earliest question of a string's lifespan.json, or None where there is none."""
    places = [reports, *(reports / name for name in _names(reports))]
    for path in (place / string / "lifespan.json" for place in places):
        if not path.is_file():
            continue
        try:
            content = json.loads(_text(path))
            left = content["questions"][content["first"]]["strokes_left"]
            return {name: None if left[name] is None else float(left[name]) for name in ("low", "median", "high")}
        except (ValueError, KeyError, TypeError, RecursionError):
            continue
    return None
