"""Bad input, said so that a person can mend it."""

import ctypes
import errno
import functools
import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path


class BadInput(Exception):
    """Input that cannot be used: which file, which field, what is wrong and how to mend it."""

    def __init__(self, file: Path | str, field: str, problem: str, mend: str) -> None:
        super().__init__(f"{file}: {field}: {problem}. Mend: {mend}{'' if mend[-1:] in '.?' else '.'}")
        self.file, self.field, self.problem, self.mend = str(file), field, problem, mend


def die_with(parent: int) -> None:
    """Ask Linux to end this process when its parent dies: a killed Snakemake must leave no job that writes on."""
    if sys.platform == "linux":
        set_parent_death_signal = 1  # PR_SET_PDEATHSIG
        ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)
        if os.getppid() != parent:  # it died while this process was starting
            os.kill(os.getpid(), signal.SIGKILL)


def _unusable(error: OSError) -> BadInput:
    """What the operating system refused, in words."""
    name = os.fsdecode(error.filename) if isinstance(error.filename, str | bytes) else "a file"
    mend = "check the path, its rights and the space on its disk"
    return BadInput(name if len(name) <= 200 else f"{name[:80]}…", "file", os.strerror(error.errno or 0), mend)


def program(main: Callable[[], int | None]) -> Callable[[], None]:
    """Turn a `main` into a command: exit 0 when done, 2 on bad input with one line that names the mend.

    A path that cannot be used, a disk that is full and the like are said in one line as well.
    """

    @functools.wraps(main)
    def command() -> None:
        parent = os.environ.get("TWISTBENCH_PARENT")  # set by whoever starts programs that must not outlive it
        if parent:
            die_with(int(parent))
        try:
            status = main()
        except BadInput as error:
            print(f"error: {error}", file=sys.stderr)
            status = 2
        except OSError as error:
            if error.errno is None or error.errno == errno.EPIPE:
                raise
            print(f"error: {_unusable(error)}", file=sys.stderr)
            status = 2
        sys.exit(status or 0)

    return command
