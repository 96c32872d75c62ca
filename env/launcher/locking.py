"""Advisory locks on files, which end with the last process that holds them; none where the system has no flock."""

import os
from pathlib import Path
from types import ModuleType

fcntl: ModuleType | None
try:
    import fcntl
except ImportError:  # not a POSIX system
    fcntl = None


def exclusive(path: Path, wait: bool, create: bool = True) -> int | None:
    """Hold a file alone: its descriptor. Raises BlockingIOError when another holds it; None without flock."""
    if fcntl is None:
        return None
    return locked(os.open(path, os.O_RDWR | (os.O_CREAT if create else 0), 0o666), fcntl.LOCK_EX, wait)


def shared(path: Path) -> int | None:
    """Hold a file with others: its descriptor. Raises BlockingIOError when one holds it alone; None without flock."""
    if fcntl is None:
        return None
    return locked(os.open(path, os.O_RDONLY), fcntl.LOCK_SH, wait=False)


def locked(descriptor: int, kind: int, wait: bool) -> int | None:
    """An open file, locked; closed where that fails, and None where its file system knows no locks."""
    assert fcntl is not None
    try:
        fcntl.flock(descriptor, kind | (0 if wait else fcntl.LOCK_NB))
    except (BlockingIOError, KeyboardInterrupt):
        os.close(descriptor)
        raise
    except OSError:
        os.close(descriptor)
        return None
    return descriptor
