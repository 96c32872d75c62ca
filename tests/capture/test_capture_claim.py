"""One folder, one recording: of two captures that begin at once the later one is refused, and replaces nothing."""

import array
import fcntl
import hashlib
import json
import os
import pty
import signal
import termios
import threading
import time
import tty

import pytest
import ready

from pipeline.capture import uncommitted_note
from pipeline.capture.log import LINES, NAME, Log, check_folder
from pipeline.ground.errors import BadInput

LONG_S = 120
HEADER = b"alpha,beta\r\n"  # names that no rig is known by: the program waits some seconds for better ones


@pytest.fixture
def start(tmp_path):
    """Start programs; they are ended with the test."""
    started = []

    def start_program(*words) -> ready.Program:
        started.append(ready.start(*words))
        return started[-1]

    yield start_program
    for process in started:
        process.kill()
        process.wait()
        process.stdout.close()


@pytest.fixture
def line():
    """A serial port in our hands: our end, and the host's."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    yield ours, theirs
    os.close(theirs)
    os.close(ours)


def until(true, process) -> None:
    end_s = time.monotonic() + LONG_S
    while not true():
        assert time.monotonic() < end_s and process.poll() is None, process.stdout.read()
        time.sleep(0.01)


def all_read(theirs: int) -> bool:
    waiting = array.array("i", [0])
    fcntl.ioctl(theirs, termios.FIONREAD, waiting)
    return waiting[0] == 0


def test_a_text_capture_into_the_folder_that_a_capture_of_frames_has_begun_is_refused(start, line, tmp_path):
    (ours, theirs), folder = line, tmp_path / "run-1"
    text = start("pipeline.capture", os.ttyname(theirs), folder, "--text")
    for _ in range(5):  # opening the port throws away what came before
        os.write(ours, HEADER)
        until(lambda: all_read(theirs), text)
        time.sleep(0.1)
    text.send_signal(signal.SIGSTOP)  # it has seen an empty folder and waits for a header
    port = tmp_path / "port"
    rig = start("pipeline.rig", "small", "--link", port, "--pace", 8)
    until(port.is_symlink, rig)
    frames = start("pipeline.capture", port, folder)
    until((folder / NAME).exists, frames)
    text.send_signal(signal.SIGCONT)
    printed, _ = text.communicate(timeout=LONG_S)
    assert text.returncode == 2 and "recording.frames: is being recorded now by another capture" in printed, printed
    assert "Mend: wait until that one has ended, or choose a new run name" in printed, printed
    printed, _ = frames.communicate(timeout=LONG_S)
    assert frames.returncode == 0 and ": complete, " in printed, printed
    with pytest.raises(BadInput, match="is there already and is never overwritten"):
        check_folder(folder)  # it has ended
    assert sorted(path.name for path in folder.iterdir()) == ["capture.json", NAME]
    info = json.loads((folder / "capture.json").read_text())
    assert info["sha256"] == hashlib.sha256((folder / NAME).read_bytes()).hexdigest()


def test_of_two_that_begin_at_the_same_moment_exactly_one_has_the_folder(tmp_path):
    def begin(folder, name, barrier, begun) -> None:
        barrier.wait()
        try:
            Log(folder, name).close()
        except BadInput:
            return
        begun.append(name)

    for number in range(100):
        folder, barrier, begun = tmp_path / f"run-{number}", threading.Barrier(2), []
        folder.mkdir()
        both = [threading.Thread(target=begin, args=(folder, name, barrier, begun)) for name in (NAME, LINES)]
        for thread in both:
            thread.start()
        for thread in both:
            thread.join()
        assert len(begun) == 1 and [path.name for path in folder.iterdir()] == begun


@pytest.mark.parametrize("other", ["capture.json", "recording.csv"])
def test_what_another_put_there_while_it_recorded_is_never_replaced(start, line, tmp_path, other):
    (ours, theirs), folder = line, tmp_path / "run-1"
    text = start("pipeline.capture", os.ttyname(theirs), folder, "--text", "--columns", "time_ms,turns")
    until((folder / LINES).exists, text)
    body = b"".join(b"%d,%d\r\n" % (20 * number, number) for number in range(50))
    os.write(ours, body)
    until(lambda: (folder / LINES).read_bytes() == body, text)
    (folder / other).write_text('{"sha256": "of another"}')
    text.send_signal(signal.SIGINT)
    printed, _ = text.communicate(timeout=LONG_S)
    assert text.returncode == 2 and f"{other}: is there already" in printed and "Mend: move" in printed, printed
    assert (folder / other).read_text() == '{"sha256": "of another"}' and (folder / LINES).read_bytes() == body
    assert sorted(path.name for path in folder.iterdir()) == sorted([other, LINES, uncommitted_note.NAME])
    assert (f"move {LINES} and {uncommitted_note.NAME} into" in printed) == (other == "capture.json")
    moved = tmp_path / "run-2"
    moved.mkdir()
    for name in (LINES, uncommitted_note.NAME):
        (folder / name).rename(moved / name)
    recovered = start("pipeline.capture", "--recover", moved, "--columns", "time_ms,turns")
    assert recovered.wait(LONG_S) == 0
    info = json.loads((moved / "capture.json").read_text())
    assert info["samples"]["received"] == 49 and (info["exit_status"], info["ended_by"]) == ("ended", "person")
    assert not (moved / uncommitted_note.NAME).exists()
