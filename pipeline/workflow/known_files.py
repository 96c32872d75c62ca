"""Facts on files by their content, kept between starts: a file is read again only when its key is new.

The key is size, both times and the inode: replacing a file by an older one, or setting its time back, changes it.
"""

import hashlib
import json
import os
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from ..ground.stored import seal
from ..ground.stored.checked_json import sum_file
from ..ground.stored.files import sha256, write_text

Check = Callable[[Path], str]
SETTLED_S = 2.0  # a file that changed this lately may change again under the same times


class KnownFiles:
    """Digests of recordings, and which stored files are intact."""

    def __init__(self, cache: Path, checks: Mapping[str, Check] | None = None) -> None:
        """`checks` says by a file's name what is wrong with it, where that is no seal of its own."""
        self.cache, self.checks = cache, checks or {}
        try:
            kept = json.loads(cache.read_text(encoding="utf-8"))
        except (OSError, ValueError, RecursionError):
            kept = {}
        kept = kept if isinstance(kept, dict) else {}
        facts, notes = kept.get("facts"), kept.get("notes")
        self.facts: dict[str, Any] = facts if isinstance(facts, dict) else {}
        self.notes: dict[str, Any] = notes if isinstance(notes, dict) else {}

    def _fact(self, path: Path, find: Any) -> Any:
        """The result of `find` for a file, now or from when the file was last the same; raises OSError."""
        stats = [os.stat(path)]
        if path.name in self.checks and sum_file(path).exists():
            stats.append(os.stat(sum_file(path)))
        key = [part for stat in stats for part in (stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns, stat.st_ino)]
        noted = self.facts.get(str(path))
        if isinstance(noted, list) and len(noted) == 2 and noted[0] == key:
            return noted[1]
        fact = find(path)
        if time.time() - max(max(stat.st_mtime, stat.st_ctime) for stat in stats) > SETTLED_S:
            self.facts[str(path)] = [key, fact]
        return fact

    def digest(self, paths: Iterable[str]) -> str:
        """Digest of the names and contents of files; a file that cannot be read counts as absent."""
        whole = hashlib.sha256()
        for path in map(Path, paths):
            try:
                whole.update(f"{path.name} {self._fact(path, sha256)}\n".encode())
            except OSError:
                continue
        return whole.hexdigest()[:32]

    def damaged(self, paths: Iterable[str]) -> dict[str, str]:
        """The damage of each stored file that has changed since it was written."""
        damages = {}
        for path in map(Path, paths):
            try:
                wrong = self._fact(path, self.checks.get(path.name, _wrong))
            except OSError:
                continue
            if wrong:
                damages[str(path)] = str(wrong)
        return damages

    def forget_intact(self) -> None:
        """Look at every stored file again at the next start: a job failed, perhaps because of one."""
        self.facts = {path: fact for path, fact in self.facts.items() if fact[1] != ""}

    def save(self) -> None:
        """Keep the known facts; if they cannot be stored, the next start reads the files again."""
        with suppress(OSError):
            write_text(self.cache, json.dumps({"facts": self.facts, "notes": self.notes}))


def _wrong(path: Path) -> str:
    try:
        seal.check(path)
    except seal.Damaged as error:
        return str(error)
    return ""
