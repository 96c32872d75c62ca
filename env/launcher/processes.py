"""What runs on this machine, as far as it can be known: by /proc on Linux, by `ps` elsewhere."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

PROC = Path("/proc")


@dataclass(frozen=True)
class Process:
    """A process: user id, words of its command, its environment (bytes) and folder where they can be read."""

    id: int
    user: int
    words: list[bytes]
    environment: bytes
    folder: Path | None


@dataclass(frozen=True)
class Running:
    """The processes that can be seen, but this one; those that it comes from; whether others' may be hidden."""

    processes: list[Process]
    complete: bool
    line: tuple[int, ...] = ()


def running() -> Running | None:
    """What runs; None where the system does not tell."""
    return by_proc() if (PROC / "self").exists() else by_ps()


def by_proc() -> Running:
    """The processes that /proc shows."""
    complete = (PROC / "1").exists()  # a /proc mounted with hidepid shows only one's own
    found, parents = {}, {}
    for path in PROC.glob("[0-9]*"):
        try:
            words = (path / "cmdline").read_bytes().split(b"\0")[:-1]
            user = path.stat().st_uid
            parents[int(path.name)] = int((path / "stat").read_text(errors="replace").rsplit(")", 1)[1].split()[1])
        except (FileNotFoundError, ProcessLookupError):
            continue  # it ended meanwhile
        except (OSError, ValueError, IndexError):
            complete = False
            continue
        words[:1] = [absolute(word, path) for word in words[:1]]
        found[int(path.name)] = Process(int(path.name), user, words, environment_of(path), folder_of(path))
    found.pop(os.getpid(), None)
    return Running(list(found.values()), complete, line_of(os.getpid(), parents))


def environment_of(path: Path) -> bytes:
    """What a process was started with, where this user may read it."""
    try:
        return (path / "environ").read_bytes()
    except OSError:
        return b""


def folder_of(path: Path) -> Path | None:
    """The working folder of a process, where this user may follow it."""
    try:
        os.readlink(path / "cwd")
        return path / "cwd"
    except OSError:
        return None


def absolute(program: bytes, path: Path) -> bytes:
    """A program's path from the root, where it was started by a relative one."""
    try:
        return os.path.normpath(os.path.join(os.fsencode(os.readlink(path / "cwd")), program))
    except OSError:
        return program


def line_of(process: int, parents: dict[int, int]) -> tuple[int, ...]:
    """A process and those that it comes from."""
    line: list[int] = []
    while process > 0 and process not in line:
        line.append(process)
        process = parents.get(process, 0)
    return tuple(line)


def by_ps() -> Running | None:
    """The processes that `ps` lists, without folders; None without `ps`."""
    command = ["ps", "-A", "-ww", "-o", "pid=", "-o", "ppid=", "-o", "uid=", "-o", "args="]
    try:
        done = subprocess.run(command, capture_output=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    found, parents = {}, {}
    for line in done.stdout.splitlines():
        fields = line.split(None, 3)
        if len(fields) == 4:
            process, parent, user = map(int, fields[:3])
            parents[process] = parent
            found[process] = Process(process, user, fields[3].split(), b"", None)
    found.pop(os.getpid(), None)
    return Running(list(found.values()), True, line_of(os.getpid(), parents))


def names(process: Process, folder: Path) -> bool:
    """Whether a process was started from a folder: its command or its environment names something in it."""
    text = b"\0".join(process.words) + b"\0" + process.environment + b"\0"
    path = os.fsencode(folder)
    return any(path + end in text for end in (b"/", b"\0", b" ", b":"))
