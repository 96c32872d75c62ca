"""What an archive says of itself: its materials, the code that made them, and of every file its name, digest and time.

Nothing of an archive is trusted: a name that leads out of its place, or that is no file of ours, is refused.
"""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.names import run_name

NAME = "manifest.json"
FORMAT = 1
PROVENANCE = "provenance"  # the folder of what Snakemake noted of each file that a rule made
PLACES = ("raw", "processed", "reports", PROVENANCE)
PART = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]*|\.snakemake_timestamp")
LONGEST = 1000  # characters of a name
LATEST_NS = 1 << 62
MEND = "ask whoever packed it to pack it again"


@dataclass(frozen=True)
class File:
    """A file: how long it is, its SHA-256, when it was written, and whether the archive brings it."""

    bytes: int
    sha256: str
    time_ns: int
    brought: bool = True


@dataclass(frozen=True)
class Manifest:
    """An archive's account of itself; `configuration` lists the files that were laid over the default one."""

    version: str
    code: str
    materials: Mapping[str, list[str]]
    configuration: list[str]
    files: Mapping[str, File] = field(default_factory=dict)

    def to_json(self) -> str:
        """All of it, in an order that does not change."""
        content = {**vars(self), "format": FORMAT, "files": {name: vars(file) for name, file in self.files.items()}}
        return json.dumps(content, indent=1, sort_keys=True)


def allowed(name: Any) -> bool:
    """Whether a name is one of a file that an archive may hold: inside its place, of plain words."""
    if not isinstance(name, str) or len(name) > LONGEST:
        return False
    place, *parts = name.split("/")
    if place not in PLACES or not parts or not all(PART.fullmatch(part) for part in parts):
        return False
    if place != "raw":
        return True
    try:
        return len(parts) == 2 and bool(run_name(parts[0]))
    except ValueError:
        return False


def _file(entry: Any) -> File | None:
    """What is said of a file, or None where that cannot be."""
    if not isinstance(entry, dict) or set(entry) != {"bytes", "sha256", "time_ns", "brought"}:
        return None
    numbers = [entry["bytes"], entry["time_ns"]]
    if not all(type(number) is int and 0 <= number < LATEST_NS for number in numbers):
        return None
    digest = entry["sha256"]
    if not isinstance(digest, str) or not re.fullmatch("[0-9a-f]{64}", digest) or type(entry["brought"]) is not bool:
        return None
    return File(**entry)


def _texts(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(text, str) and text.isprintable() for text in value)


def read(text: bytes, archive: Path) -> Manifest:
    """The manifest of an archive; raises BadInput for one that cannot be, or that names a file out of place."""
    try:
        content = json.loads(text)
        assert content.pop("format") == FORMAT and isinstance(content["files"], dict)
        assert isinstance(content["materials"], dict) and _texts([content["version"], content["code"]])
        assert _texts(list(content["materials"])) and all(map(_texts, content["materials"].values()))
        assert _texts(content["configuration"])
        named = content.pop("files")
        manifest = Manifest(**content)
    except (ValueError, KeyError, TypeError, AttributeError, AssertionError, RecursionError):
        raise BadInput(archive, NAME, f"is none of format {FORMAT}", MEND) from None
    files = {}
    for name, entry in named.items():
        file = _file(entry)
        if not allowed(name):
            raise BadInput(archive, ascii(name)[:200], "is no name of a file that an archive may hold", MEND)
        if file is None:
            raise BadInput(archive, name, "is described in a way that cannot be", MEND)
        files[name] = file
    for name in files:
        if any(str(above) in files for above in Path(name).parents):
            raise BadInput(archive, name, "lies below a file", MEND)
    return Manifest(manifest.version, manifest.code, manifest.materials, manifest.configuration, files)
