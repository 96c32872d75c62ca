"""The imports of source files, kept beside Python's compiled code: to parse all files takes a second at every start.

An entry stands for one content of one file, and all of them for one way to find imports, which is this folder's code.
"""

import hashlib
import json
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

from ..errors import BadInput
from ..stored.files import write_text

FINDS = ("fingerprint.py", "kept_imports.py", "modules.py")  # the code that decides what a file imports


class KeptImports:
    """Imports of a package's source files, by the file's path in it and its content."""

    def __init__(self, house: Path) -> None:
        self.path = house / "__pycache__" / f"imports.{sys.implementation.cache_tag}.json"
        self.finder = _digest(*(Path(__file__).with_name(name).read_bytes() for name in FINDS))
        self.entries: dict[str, Any] = {}
        self.new = False
        with suppress(OSError, ValueError, RecursionError, TypeError, KeyError):
            kept = json.loads(self.path.read_text(encoding="utf-8"))
            if kept["finder"] == self.finder:
                self.entries = dict(kept["entries"])

    def of(self, name: str, content: bytes, find: Callable[[], Iterable[str]]) -> frozenset[str]:
        """Names of the modules that a file of this path and content imports; `find` looks if nothing is kept."""
        digest = _digest(content)
        entry = self.entries.get(name)
        if not (isinstance(entry, list) and entry[:1] == [digest] and all(isinstance(word, str) for word in entry)):
            self.entries[name] = entry = [digest, *sorted(find())]
            self.new = True
        return frozenset(entry[1:])

    def keep(self) -> None:
        """Save new entries where Python keeps compiled code; if that fails, the next process looks again."""
        if self.new and not sys.dont_write_bytecode:
            with suppress(OSError, BadInput):
                write_text(self.path, json.dumps({"finder": self.finder, "entries": self.entries}))
        self.new = False


def _digest(*contents: bytes) -> str:
    """Check sum of contents, in hexadecimal digits."""
    return hashlib.sha256(b"\0".join(contents)).hexdigest()
