"""Bad input, told so that a person can mend it."""

import errno
import functools
import os
import re
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterable
from pathlib import Path

LOOK_EVERY_S = 1.0
LOOP = "Symlink loop from "  # how Path.resolve complains of one, up to Python 3.12
LONGEST_WORD = 400  # characters of a word that a message repeats whole: paths that people use have fewer
UNREAD = 128 + getattr(signal, "SIGPIPE", 13)  # what a program ends with whose reader left; Windows lacks the signal
EXTRAS = {"torch": "models", "onnx": "export", "h5py": "formats", "openpyxl": "formats"}  # of the installed package


def bounded(text: str, words: Iterable[str] = ()) -> str:
    """A message in which what is longer than 400 characters is cut: stretches without a space, and any of `words`."""
    for word in sorted(words, key=len, reverse=True):
        if len(word) > LONGEST_WORD:
            text = text.replace(word, _cut(word))
    return re.sub(rf"\S{{{LONGEST_WORD + 1},}}", lambda stretch: _cut(stretch[0]), text)


def _cut(word: str) -> str:
    return f"{word[:60]}…{word[-20:]}"


class BadInput(Exception):
    """Input that cannot be used: its text says all four of what follows in one line.

    `file`: the file, or the option, that holds it. `field`: the key, column or row in it. `problem`: what is wrong.
    `mend`: what to do; a command below it is a line of its own, without a full stop.
    """

    def __init__(self, file: Path | str, field: str, problem: str, mend: str) -> None:
        stop = "" if mend[-1:] in ".?" or "\n" in mend else "."
        super().__init__(bounded(f"{file}: {field}: {problem}. Mend: {mend}{stop}", sys.argv[1:]))
        self.file, self.field, self.problem, self.mend = str(file), field, problem, mend


def die_with(parent: int) -> None:
    """End this process when its parent dies: a killed Snakemake must leave no job that writes on.

    Linux does that at once; elsewhere a thread looks every second. Windows says nothing of a parent's death.
    """
    if os.name == "nt":
        return
    if not _kernel_ends_orphans():
        threading.Thread(target=_end_as_orphan, args=(parent,), daemon=True).start()
    elif os.getppid() != parent:  # it died while this process was starting
        os.kill(os.getpid(), signal.SIGKILL)


def _kernel_ends_orphans() -> bool:
    """Whether the kernel took the order to end this process with its parent."""
    try:
        import ctypes

        prctl = ctypes.CDLL(None).prctl
    except (ImportError, OSError, AttributeError):  # not Linux
        return False
    set_parent_death_signal = 1  # PR_SET_PDEATHSIG
    return bool(prctl(set_parent_death_signal, signal.SIGKILL) == 0)


def _end_as_orphan(parent: int) -> None:
    """Wait until another process is the parent, then end this one at once."""
    while os.getppid() == parent:
        time.sleep(LOOK_EVERY_S)
    os.kill(os.getpid(), signal.SIGKILL)


def not_installed(error: ModuleNotFoundError) -> BadInput | None:
    """The message on an optional package that is not installed; None for any other package."""
    if error.name not in EXTRAS:
        return None
    return BadInput("python", error.name, "is not installed", f"pip install 'twistbench[{EXTRAS[error.name]}]'")


def _unusable(error: OSError) -> BadInput:
    """The refusal of the operating system, in words."""
    name = os.fsdecode(error.filename) if isinstance(error.filename, str | bytes) else "a file"
    mend = "check the path, its rights and the space on its disk"
    return BadInput(name if len(name) <= 200 else f"{name[:80]}…", "file", os.strerror(error.errno or 0), mend)


def _status(main: Callable[[], int | None]) -> int | None:
    """The status of `main`; 2, with a message, on bad input or if it lacks an optional package."""
    try:
        return main()
    except BadInput as error:
        print(f"error: {error}", file=sys.stderr)
    except OSError as error:
        if error.errno is None or error.errno == errno.EPIPE:
            raise
        print(f"error: {_unusable(error)}", file=sys.stderr)
    except RuntimeError as error:
        if not str(error).startswith(LOOP):
            raise
        mend = "remove one of these links, or give another path"
        name = str(error).removeprefix(LOOP).strip("'")
        print(f"error: {BadInput(name, 'file', 'is a link that leads back to itself', mend)}", file=sys.stderr)
    except ModuleNotFoundError as error:
        if (lacking := not_installed(error)) is None:
            raise
        print(f"error: {lacking}", file=sys.stderr)
    return 2


def _say_no_more() -> None:
    """Drop everything that is still printed: nobody reads it, and Python would complain about that at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for number in (1, 2):
        os.dup2(nowhere, number)
    os.close(nowhere)


def program(main: Callable[[], int | None]) -> Callable[[], None]:
    """Turn a `main` into a command: exit 0 when done, 2 on bad input with one line that names the mend.

    A path that cannot be used, a disk that is full and the like are said in one line as well. Where the reader of its
    output has left, it ends quietly, with the status of a program that the signal PIPE ended.
    """

    @functools.wraps(main)
    def command() -> None:
        parent = os.environ.get("TWISTBENCH_PARENT")  # set by whoever starts programs that must not outlive it
        if parent:
            die_with(int(parent))
            os.environ["TWISTBENCH_PARENT"] = str(os.getpid())  # of the programs that it starts itself
        try:
            try:
                status = _status(main)
            finally:
                for stream in (sys.stdout, sys.stderr):
                    if stream is not None:
                        stream.flush()  # what is still to be said: a reader that left is noticed here
        except BrokenPipeError:
            _say_no_more()
            status = UNREAD
        sys.exit(status or 0)

    return command
