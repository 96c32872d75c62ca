"""What tests make once for all their processes: a recording, a diagnosis."""

import fcntl
import os
import pickle
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

SHARED = "shared"


def place(factory: pytest.TempPathFactory) -> Path:
    """A folder that the processes of one session of tests share."""
    base = factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / SHARED
    folder.mkdir(exist_ok=True)
    return folder


def forget(base: Path) -> None:
    """Remove what a session made in its base folder: studies of 100 MB, which pytest would keep for three sessions."""
    for path in (base / SHARED).glob("made-*"):
        path.unlink()


def made_once(shared: Path, key: object, make: Callable[[], Any]) -> Any:
    """What `make` gives, made by the first who asks for a key in a shared folder; each who asks gets a copy."""
    path = shared / f"made-{zlib.crc32(repr(key).encode()):08x}"
    with open(path.with_suffix(".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not path.exists():
            path.with_suffix(".part").write_bytes(pickle.dumps((repr(key), make())))
            path.with_suffix(".part").rename(path)
    saved_key, value = pickle.loads(path.read_bytes())
    assert saved_key == repr(key), "two keys have one name"
    return value
