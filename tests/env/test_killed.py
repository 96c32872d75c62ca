"""A killed launcher: at any of 50 moments, and with its installer at work."""

import contextlib
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from small_checkout import Checkout, is_whole

BOTH = {"alpha": 40, "beta": 40}
MOMENTS, AGAIN = 50, 5
TRIES = 5  # of a moment, until it comes before the build ends
LONG_S = 120  # until a test gives up waiting: no test asserts a time
# ends the launcher by SIGKILL before the n-th new line of its own code, or counts the lines
AT_LINE = """
import atexit, os, signal, sys
last, seen = int(os.environ.get("KILLED_AT_LINE", "0")), set()

def line(frame, event, _):
    seen.add((frame.f_code.co_filename, frame.f_lineno))
    if len(seen) == last:
        os.kill(os.getpid(), signal.SIGKILL)
    return line

def call(frame, event, _):
    return line if os.path.basename(os.path.dirname(frame.f_code.co_filename)) == "launcher" else None

if last and os.path.basename(sys.orig_argv[1]) == "run.py":
    sys.settrace(call)
    atexit.register(lambda: print(len(seen)))
"""


def nobody_installs(checkout: Checkout) -> bool:
    """Whether no process works in any environment of a checkout."""
    listed = subprocess.run(["ps", "-A", "-ww", "-o", "args="], capture_output=True, text=True, check=True).stdout
    return f"{checkout.env}/.venv-" not in listed


def wait_until(true, what: str) -> None:
    end_s = time.monotonic() + LONG_S
    while not true():
        assert time.monotonic() < end_s, what
        time.sleep(0.02)


def killed_after(checkout: Checkout, seconds: float) -> bool:
    """Start the launcher and kill it, and it alone, after some seconds; whether it was still at work."""
    launcher = checkout.start("true")
    try:
        launcher.wait(seconds)
        return False
    except subprocess.TimeoutExpired:
        launcher.kill()
        return True
    finally:
        launcher.communicate()


def killed_at_line(checkout: Checkout, line: int) -> bool:
    """Let the launcher kill itself at a line of its code; whether it came so far."""
    return checkout.run("true", KILLED_AT_LINE=str(line)).returncode == -signal.SIGKILL


@pytest.fixture
def traced(checkout, tmp_path):
    """A checkout whose launcher ends itself where it is told."""
    folder = tmp_path / "traced"
    folder.mkdir()
    site = Path(checkout.quick["PYTHONPATH"]) / "sitecustomize.py"
    (folder / "sitecustomize.py").write_text(site.read_text() + AT_LINE)
    return Checkout(checkout.folder, checkout.wheels, {"PYTHONPATH": str(folder)})


def ends_whole(checkout: Checkout, version: str) -> None:
    """The next start makes what the lock says, whole, and leaves nothing else behind."""
    done = checkout.run("alpha")
    place = checkout.link.resolve()
    assert done.stdout == f"alpha {version} {place}\n", done.stderr
    assert is_whole(place, BOTH) and checkout.places() == [place]


def nothing_is_broken(checkout: Checkout, moment: int) -> None:
    """The environment that is named, and all that are stamped, are whole."""
    assert is_whole(checkout.link.resolve(), BOTH), f"moment {moment}: env/.venv names a broken environment"
    for place in checkout.stamped():
        assert is_whole(place, BOTH), f"moment {moment}: {place.name} is stamped and broken"


def lines_of_a_build(checkout: Checkout) -> int:
    """How many lines of its own code the launcher runs when it makes an environment."""
    return int(checkout.run("no-such-command", KILLED_AT_LINE="-1").stdout)


@pytest.mark.long
def test_killed_at_50_moments_every_next_start_ends_whole(traced):
    """Half the moments are spread over the time that a build takes, half over the lines of the launcher's code.

    After each kill the next start ends whole; after one in five of them that start is killed as well, and the one after
    it ends whole. Where a build ended before its moment, the machine is quicker than at the first build: the time of a
    build is measured anew, and the moment tried again, so that all 50 are kills.
    """
    traced.lock("alpha==2.0", "beta==1.0")
    lines = lines_of_a_build(traced)
    traced.lock("alpha==1.0", "beta==1.0")
    begun_s = time.monotonic()
    ends_whole(traced, "1.0")
    build_s = time.monotonic() - begun_s
    killed, version, following = 0, "2.0", "1.0"
    for moment in range(MOMENTS):
        part = (moment * 7 % MOMENTS + 0.5) / MOMENTS
        for _ in range(TRIES):
            traced.lock(f"alpha=={version}", "beta==1.0")
            begun_s = time.monotonic()
            if moment % 2:
                at_work = killed_after(traced, build_s * part)
                build_s = build_s if at_work else time.monotonic() - begun_s
            else:
                at_work = killed_at_line(traced, max(1, round(lines * part)))
            nothing_is_broken(traced, moment)
            if at_work and moment % AGAIN == 0:
                killed_at_line(traced, max(1, round(lines * (1.0 - part))))
                nothing_is_broken(traced, moment)
            ends_whole(traced, version)
            version, following = following, version
            if at_work:
                break
        killed += at_work
    assert killed == MOMENTS


class SilentIndex:
    """A package index that takes questions and never answers, so that pip waits."""

    def __init__(self) -> None:
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.asked = threading.Event()
        self.connections: list[socket.socket] = []
        self.url = f"http://127.0.0.1:{self.socket.getsockname()[1]}/"
        threading.Thread(target=self.take, daemon=True).start()

    def take(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                self.connections.append(self.socket.accept()[0])
                self.asked.set()

    def close(self) -> None:
        for open_socket in [self.socket, *self.connections]:
            with contextlib.suppress(OSError):
                open_socket.shutdown(socket.SHUT_RDWR)
            open_socket.close()


@pytest.fixture
def silent_index():
    index = SilentIndex()
    yield index
    index.close()


def waiting_for(index: SilentIndex) -> dict[str, str]:
    return {"PIP_NO_INDEX": "0", "PIP_INDEX_URL": index.url, "PIP_DEFAULT_TIMEOUT": "600", "PIP_RETRIES": "0"}


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux ends a child with its parent")
def test_the_installer_ends_with_its_launcher(bare, silent_index):
    launcher = bare.start("alpha", **waiting_for(silent_index))
    assert silent_index.asked.wait(LONG_S)
    assert not nobody_installs(bare)
    launcher.kill()
    launcher.wait()
    launcher.stdout.close()
    wait_until(lambda: nobody_installs(bare), "the installer lives on")
    ends_whole(bare, "1.0")


def test_an_installer_that_outlives_its_launcher_keeps_the_next_one_waiting(bare, silent_index, tmp_path):
    """As on a system that cannot end a child with its parent: the installer holds the lock."""
    site = Path(bare.quick["PYTHONPATH"]) / "sitecustomize.py"
    without_ctypes = "import os, sys\nif os.path.basename(sys.orig_argv[1]) == 'run.py': sys.modules['ctypes'] = None\n"
    (tmp_path / "sitecustomize.py").write_text(site.read_text() + without_ctypes)
    launcher = bare.start("alpha", **waiting_for(silent_index), PYTHONPATH=str(tmp_path))
    assert silent_index.asked.wait(LONG_S)
    launcher.kill()
    launcher.wait()
    launcher.stdout.close()  # which its installer holds too
    assert not nobody_installs(bare)
    (orphans_place,) = bare.places()
    following = bare.start("alpha")
    line = following.stdout.readline()
    assert "another launcher is making the environment; waiting for it" in line
    assert bare.places() == [orphans_place] and following.poll() is None
    silent_index.close()
    rest, _ = following.communicate()
    assert rest.endswith(f"alpha 1.0 {bare.link.resolve()}\n")
    assert is_whole(bare.link.resolve(), BOTH) and bare.places() == [bare.link.resolve()]


def test_ctrl_c_is_a_sentence_and_leaves_nothing(bare, silent_index):
    launcher = bare.start("alpha", **waiting_for(silent_index))
    assert silent_index.asked.wait(LONG_S)
    os.killpg(launcher.pid, signal.SIGINT)
    printed, _ = launcher.communicate()
    assert launcher.returncode == 130 and "nothing half-made is used" in printed and "run.py" not in printed
    assert not bare.places() and nobody_installs(bare)


def test_two_launchers_at_once_make_one_environment(bare):
    both = [bare.start("alpha"), bare.start("alpha")]
    outputs = [launcher.communicate()[0] for launcher in both]
    place = bare.link.resolve()
    assert all(text.endswith(f"alpha 1.0 {place}\n") for text in outputs), outputs
    assert bare.places() == [place] and sum("making the environment in" in text for text in outputs) == 1


# another launcher ends its work, the link last, when this one asks for the second time where the link leads
ENDS_MEANWHILE = """
import os, sys
realpath, times_asked = os.path.realpath, []

def late(path, *args, **kwargs):
    found = realpath(path, *args, **kwargs)
    link = os.path.join(os.environ["CHECKOUT"], "env", ".venv")
    if os.fspath(path) == link:
        times_asked.append(1)
        if len(times_asked) == 2:
            os.rename(os.environ["HELD_BACK"], os.environ["PLACE"])
            os.symlink(os.environ["PLACE"], link)
    return found

if os.path.basename(sys.orig_argv[1]) == "run.py":
    os.path.realpath = late
"""


def test_an_environment_that_another_launcher_ends_meanwhile_is_taken_where_it_lies(bare, tmp_path):
    assert bare.run("true").returncode == 0
    (place,) = bare.places()
    held_back = place.rename(tmp_path / "held back")
    bare.link.unlink()
    site = Path(bare.quick["PYTHONPATH"]) / "sitecustomize.py"
    (tmp_path / "sitecustomize.py").write_text(site.read_text() + ENDS_MEANWHILE)
    names = {"CHECKOUT": str(bare.folder), "PLACE": str(place), "HELD_BACK": str(held_back)}
    done = bare.run("alpha", PYTHONPATH=str(tmp_path), **names)
    assert bare.link.is_symlink() and done.stdout == f"alpha 1.0 {place}\n" and not done.stderr
