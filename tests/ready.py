"""Programs of the project in processes of their own that find their imports made, which take 1 to 3 s each time.

A server that only imports forks for each program, as `multiprocessing`'s fork server does. What a program does with its
signals, its files, its folder and its death is as ever. What a bare start shows is for `sys.executable`.
"""

import atexit
import contextlib
import importlib
import json
import os
import runpy
import select
import signal
import socket
import subprocess
import sys
import time
import warnings
from functools import cache
from pathlib import Path
from typing import IO, Any

ROOT = Path(__file__).resolve().parent.parent
SERVER = "import sys; sys.path[:0] = [{!r}, {!r}]; import ready; ready.serve({!r})"
LONGEST = 60_000  # bytes of a request


class Program:
    """A program at work: of `subprocess.Popen` what tests need."""

    def __init__(self, server: socket.socket, args: list[str], cwd: object, environment: dict[str, str]) -> None:
        said, writes = os.pipe()
        self._ended, tells = os.pipe()
        self.args, self.returncode = args, None
        self.stdout: IO[str] = os.fdopen(said)
        request = json.dumps({"args": args, "cwd": str(cwd), "environment": environment}).encode()
        assert len(request) < LONGEST
        socket.send_fds(server, [request], [writes, tells])
        os.close(writes), os.close(tells)
        self.pid = int(server.recv(20))

    def __del__(self) -> None:
        os.close(self._ended)

    def poll(self) -> int | None:
        """Its exit status, minus the signal that killed it, None while it works."""
        return self._status(0.0)

    def wait(self, timeout: float | None = None) -> int:
        """Its exit status when it has ended."""
        status = self._status(timeout)
        if status is None:
            raise subprocess.TimeoutExpired(self.args, timeout or 0.0)
        return status

    def _status(self, seconds: float | None) -> int | None:
        if self.returncode is None and select.select([self._ended], [], [], seconds)[0]:
            self.returncode = int(os.read(self._ended, 20))
        return self.returncode

    def communicate(self, timeout: float | None = None) -> tuple[str, None]:
        """What it said until its end."""
        until = None if timeout is None else time.monotonic() + timeout
        pieces = []
        while True:
            left = None if until is None else max(until - time.monotonic(), 0.0)
            if not select.select([self.stdout], [], [], left)[0]:
                raise subprocess.TimeoutExpired(self.args, timeout or 0.0)
            piece = os.read(self.stdout.fileno(), 65536)
            if not piece:
                break
            pieces.append(piece)
        self.wait(None if until is None else max(until - time.monotonic(), 1.0))
        self.stdout.close()
        return b"".join(pieces).decode(), None

    def send_signal(self, number: int) -> None:
        """Send it a signal, where it has not ended."""
        if self.poll() is None:
            os.kill(self.pid, number)

    def kill(self) -> None:
        """Kill it."""
        self.send_signal(signal.SIGKILL)

    def terminate(self) -> None:
        """Ask it to end."""
        self.send_signal(signal.SIGTERM)


@cache
def _server(modules: tuple[str, ...]) -> socket.socket:
    """Our end of a socket at which a new server listens; it ends with this process."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    code = SERVER.format(str(ROOT), str(ROOT / "tests"), modules)
    process = subprocess.Popen([sys.executable, "-c", code], stdin=theirs)
    theirs.close()
    atexit.register(lambda: (ours.close(), process.wait()))
    return ours


def start(module: str, *words: object, cwd: object, imports: tuple[str, ...]) -> Program:
    """Start `python -m <module> <words>` in a folder, without a terminal; its output and complaints are one pipe.

    `imports` are the modules that it finds imported.
    """
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}  # for what it starts itself: the folder is not the checkout
    return Program(_server(imports), [module, *map(str, words)], cwd, environment)


def serve(modules: tuple[str, ...]) -> None:
    """Import the modules, then start what is asked for at the socket that is standard input, until it closes."""
    for module in modules:
        importlib.import_module(module)
    asked, ends = socket.socket(fileno=os.dup(0)), {}
    woken, wakes = os.pipe()
    os.set_blocking(wakes, False)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    interrupted = signal.signal(signal.SIGINT, signal.SIG_IGN)  # by Ctrl-C of who runs the tests
    signal.set_wakeup_fd(wakes)
    while True:
        ready = select.select([asked, woken], [], [])[0]
        if woken in ready:
            os.read(woken, 4096)
            _tell(ends)
        if asked not in ready:
            continue
        message, handles, _, _ = socket.recv_fds(asked, LONGEST, 2)
        if not message:
            return
        writes, tells = handles
        child = os.fork()
        if child == 0:
            signal.set_wakeup_fd(-1)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL), signal.signal(signal.SIGINT, interrupted)
            _be(json.loads(message), writes)
        os.close(writes)
        ends[child] = tells
        asked.send(str(child).encode())


def _tell(ends: dict[int, int]) -> None:
    """Tell of each program that has ended how."""
    with contextlib.suppress(ChildProcessError):
        while (end := os.waitpid(-1, os.WNOHANG))[0]:
            tells = ends.pop(end[0])
            os.write(tells, str(os.waitstatus_to_exitcode(end[1])).encode())
            os.close(tells)


def _be(request: dict[str, Any], writes: int) -> None:
    """Be the program that is asked for, to its end, as the interpreter does: what is left to write is written."""
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0), os.dup2(writes, 1), os.dup2(writes, 2)
    os.closerange(3, os.sysconf("SC_OPEN_MAX"))
    os.chdir(request["cwd"])
    os.environ.clear()
    os.environ.update(request["environment"])
    sys.argv = request["args"]
    sys.stdout, sys.stderr = open(1, "w", closefd=False), open(2, "w", closefd=False, buffering=1)  # noqa: SIM115
    warnings.filterwarnings("ignore", ".*found in sys.modules after import of package", RuntimeWarning)
    runpy.run_module(request["args"][0], run_name="__main__", alter_sys=True)
    sys.exit()
