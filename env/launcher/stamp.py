"""The stamp of an environment, written last: what it was made from, where, and an outline of what it holds."""

import hashlib
import json
import os
import platform
import sys
from pathlib import Path
from typing import Any

from launcher import records

STAMP = "stamp"
FIELDS = {"lock": str, "python": str, "place": str, "base": str, "outline": dict}


def python_tag() -> str:
    """The kind of Python that runs this: its packages fit no other."""
    return f"{sys.implementation.cache_tag}{getattr(sys, 'abiflags', '')}-{sys.platform}-{platform.machine()}"


def lock_sum(lock: Path) -> str:
    """What stands for the lock's content."""
    return hashlib.sha256(lock.read_bytes()).hexdigest()


def write(place: Path, lock: Path) -> None:
    """Stamp an environment as whole; on disk before this returns."""
    content = {
        "lock": lock_sum(lock),
        "python": python_tag(),
        "place": str(place),
        "base": os.path.realpath(place / "bin" / "python"),
        "outline": records.outline(place, lock),
    }
    temporary = place / f"{STAMP}.{os.getpid()}"
    os.sync()  # the packages first: a stamp must never outlive them in a power cut
    with open(temporary, "w", encoding="utf-8") as file:
        json.dump(content, file)
        file.flush()
        os.fsync(file.fileno())
    os.replace(temporary, place / STAMP)


def read(place: Path) -> dict[str, Any] | None:
    """The stamp of an environment, or None where it has none that can be used."""
    try:
        content = json.loads((place / STAMP).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    fits = isinstance(content, dict) and all(isinstance(content.get(name), kind) for name, kind in FIELDS.items())
    return content if fits and all(isinstance(size, int) for size in content["outline"].values()) else None


def stands(place: Path, content: dict[str, Any]) -> bool:
    """Whether the Python that an environment was made with is still the one behind it."""
    python = place / "bin" / "python"
    return os.access(python, os.X_OK) and os.path.realpath(python) == content["base"]


def is_of(content: dict[str, Any] | None, lock: Path) -> bool:
    """Whether a stamp is of this lock and this kind of Python."""
    return content is not None and content["lock"] == lock_sum(lock) and content["python"] == python_tag()
