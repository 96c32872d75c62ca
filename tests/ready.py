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
import threading
import time
import warnings
from functools import cache
from pathlib import Path
from typing import IO, Any

ROOT = Path(__file__).resolve().parent.parent
SERVER = "import sys; sys.path[:0] = [{!r}, {!r}]; import ready; ready.serve({!r})"
LONGEST = 60_000  # bytes of a request
# What most tests start, so that one server serves all of them; each of them is started by `sys.executable` somewhere.
PROGRAMS = (
    *(f"pipeline.{program}.__main__" for program in ("capture", "rig", "watch")),
    *("pipeline.new_run", "pipeline.import_run", "pipeline.stages.ingest"),
)


class Program:
    """A program at work: of `subprocess.Popen` what tests need."""

    def __init__(self, server: socket.socket, request: dict[str, Any], output: IO[str] | None, apart: bool) -> None:
        self.args, self.returncode = request["args"], None
        self._ended, tells = os.pipe()
        pipes = [os.pipe() for _ in range(0 if output else 1 + apart)]
        self.stdout, self.stderr = (*(os.fdopen(read_end) for read_end, _ in pipes), None, None)[:2]
        written = [output.fileno()] if output else [writes for _, writes in pipes]
        message = json.dumps(request).encode()
        assert len(message) < LONGEST
        socket.send_fds(server, [message], [written[0], written[-1], tells])
        for handle in (*(writes for _, writes in pipes), tells):
            os.close(handle)
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

    def communicate(self, timeout: float | None = None) -> tuple[str, str | None]:
        """What it said until its end, and what it complained of where that has a pipe of its own."""
        until = None if timeout is None else time.monotonic() + timeout
        pipes = {pipe.fileno(): pipe for pipe in (self.stdout, self.stderr) if pipe and not pipe.closed}
        pieces: dict[int, list[bytes]] = {handle: [] for handle in pipes}
        open_handles = list(pipes)
        while open_handles:
            heard = select.select(open_handles, [], [], None if until is None else max(until - time.monotonic(), 0.0))[
                0
            ]
            if not heard:
                raise subprocess.TimeoutExpired(self.args, timeout or 0.0)
            for handle in heard:
                pieces[handle].append(os.read(handle, 65536))
                open_handles = (
                    open_handles if pieces[handle][-1] else [other for other in open_handles if other != handle]
                )
        self.wait(None if until is None else max(until - time.monotonic(), 1.0))
        texts = [b"".join(piece).decode() for piece in pieces.values()]
        for pipe in pipes.values():
            pipe.close()
        return (*texts, None, None)[:2] if texts else ("", None)

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


def start(
    module: str, *words: object, cwd: object = ROOT, imports: tuple[str, ...] = PROGRAMS,
    output: IO[str] | None = None, apart: bool = False,
) -> Program:  # fmt: skip
    """Start `python -m <module> <words>` in a folder, without a terminal.

    `imports` are the modules that it finds imported. Output and complaints are one pipe, two where they are `apart`, or
    go to the file `output`.
    """
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}  # for what it starts itself: the folder is not the checkout
    request = {"args": [module, *map(str, words)], "cwd": str(cwd), "environment": environment}
    return Program(_server(imports), request, output, apart)


def run(module: str, *words: object, cwd: object = ROOT, timeout: float = 300.0) -> subprocess.CompletedProcess[str]:
    """The same program at its end, with what it said and what it complained of."""
    program = start(module, *words, cwd=cwd, apart=True)
    try:
        output, complained = program.communicate(timeout)
    except subprocess.TimeoutExpired:
        program.kill()
        raise
    return subprocess.CompletedProcess(program.args, program.wait(), output, complained)


def serve(modules: tuple[str, ...]) -> None:
    """Import the modules, then start what is asked for at the socket that is standard input, until it closes."""
    for module in modules:
        importlib.import_module(module)
    control_socket, ends = socket.socket(fileno=os.dup(0)), {}
    woken, wakes = os.pipe()
    os.set_blocking(wakes, False)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    interrupted = signal.signal(signal.SIGINT, signal.SIG_IGN)  # by Ctrl-C of who runs the tests
    signal.set_wakeup_fd(wakes)
    while True:
        ready = select.select([control_socket, woken], [], [])[0]
        if woken in ready:
            os.read(woken, 4096)
            _tell(ends)
        if control_socket not in ready:
            continue
        message, handles, _, _ = socket.recv_fds(control_socket, LONGEST, 3)
        if not message:
            return
        *written, tells = handles
        child = os.fork()
        if child == 0:
            signal.set_wakeup_fd(-1)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL), signal.signal(signal.SIGINT, interrupted)
            _be(json.loads(message), *written)
        for handle in written:
            os.close(handle)
        ends[child] = tells
        control_socket.send(str(child).encode())


def _tell(ends: dict[int, int]) -> None:
    """Tell of each program that has ended how."""
    with contextlib.suppress(ChildProcessError):
        while (end := os.waitpid(-1, os.WNOHANG))[0]:
            tells = ends.pop(end[0])
            os.write(tells, str(os.waitstatus_to_exitcode(end[1])).encode())
            os.close(tells)


def _be(request: dict[str, Any], says: int, complains: int) -> None:
    """Be the program that is asked for, to its end: as the interpreter does, but that nothing it imported is undone."""
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0), os.dup2(says, 1), os.dup2(complains, 2)
    os.closerange(3, os.sysconf("SC_OPEN_MAX"))
    os.chdir(request["cwd"])
    os.environ.clear()
    os.environ.update(request["environment"])
    sys.argv = request["args"]
    sys.stdout = open(1, "w", closefd=False)  # noqa: SIM115
    sys.stderr = open(2, "w", closefd=False, buffering=1, errors="backslashreplace")  # noqa: SIM115
    warnings.filterwarnings("ignore", ".*found in sys.modules after import of package", RuntimeWarning)
    status: object = 0
    try:
        runpy.run_module(request["args"][0], run_name="__main__", alter_sys=True)
    except SystemExit as end:
        status = end.code or 0
    for thread in threading.enumerate():
        if thread is not threading.main_thread() and not thread.daemon:
            thread.join()
    if not isinstance(status, int):
        print(status, file=sys.stderr)
    atexit._run_exitfuncs()
    sys.stdout.flush(), sys.stderr.flush()
    os._exit(status & 255 if isinstance(status, int) else 1)  # to undo the imports takes half a second
