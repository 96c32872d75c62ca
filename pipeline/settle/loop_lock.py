"""A lock for one loop at a time in a folder, where the system can lock a file; and a check for a running loop."""

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..capture.log import in_use
from ..ground.errors import BadInput

try:
    import fcntl
except ImportError:  # no POSIX system: nothing tells that another loop is at work
    fcntl = None  # type: ignore[assignment]

LOCK = "loop.lock"
PATIENCE_S, LOOK_S = 1.0, 0.05  # who looks whether a loop is at work holds the lock for a moment


@contextmanager
def alone(out: Path) -> Iterator[None]:
    """Hold the folder of a loop; raises BadInput where another program has it."""
    out.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(out / LOCK, os.O_RDWR | os.O_CREAT, 0o644)
    try:
        until_s = time.monotonic() + PATIENCE_S
        while fcntl is not None:
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > until_s:
                    mend = "wait for that program, end it, or name another --out"
                    raise BadInput(out, "--out", "is the folder of a loop that is at work", mend) from None
            time.sleep(LOOK_S)
        yield
    finally:
        os.close(descriptor)


def at_work(out: Path) -> bool:
    """Whether a loop is at work in a folder."""
    return (out / LOCK).is_file() and in_use(out / LOCK)
