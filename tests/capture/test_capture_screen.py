"""On a terminal one line renews itself, in a log file a line a minute and the first soon; the time left never rises."""

import os
import pty
import re
import select
import subprocess
import sys
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pipeline.capture import screen
from pipeline.capture.remaining_time import Left
from pipeline.capture.screen import CLEAR, Screen, clock


class Terminal:
    """Standard output that is, or is not, a terminal."""

    def __init__(self, live: bool) -> None:
        self.live, self.said = live, ""

    def isatty(self) -> bool:
        return self.live

    def write(self, text: str) -> None:
        self.said += text

    def flush(self) -> None:
        pass


@pytest.fixture
def at(monkeypatch):
    """Set the clock."""
    now_s = [0.0]
    monkeypatch.setattr(screen.time, "monotonic", lambda: now_s[0])
    return lambda moment_s: now_s.__setitem__(0, moment_s)


def shown(live: bool, at, monkeypatch, seconds: float) -> tuple[str, int]:
    """What is written in a recording of so many seconds, and how often the line was due."""
    out = Terminal(live)
    monkeypatch.setattr(screen.sys, "stdout", out)
    monkeypatch.setenv("COLUMNS", "40")
    at(0.0)
    shown_screen, times = Screen(), 0
    for step in range(int(seconds * 20)):
        at(step / 20)
        if shown_screen.due:
            times += 1
            shown_screen.show([f"{step / 20:.1f} s recorded", "stroke 1 of 9", "0 frames lost", "27.20 turns"])
    shown_screen.say("warning: something")
    shown_screen.close(["the end"])
    return out.said, times


def test_on_a_terminal_one_line_renews_itself(at, monkeypatch):
    written, times = shown(True, at, monkeypatch, 10)
    assert times > 30 and written.count("\n") == 2  # the warning and the last line
    lines = written.split(CLEAR)
    assert all(len(line) < 40 for line in lines[1:-1])
    assert lines[5].endswith("s recorded, stroke 1 of 9") and written.endswith("\nthe end\n")


def test_in_a_log_file_it_is_a_line_a_minute(at, monkeypatch):
    written, times = shown(False, at, monkeypatch, 7200)
    assert times == 120 and written.count("\n") == 122 and CLEAR not in written and "\x1b" not in written
    assert written.startswith("5.0 s recorded, ") and written.splitlines()[1].startswith("65.0 s")


@given(st.lists(st.floats(0.1, 100), min_size=1, max_size=20), st.floats(0, 30))
def test_the_time_left_never_rises_and_comes_to_nothing(strokes_s, rest_s):
    time_left, now_s, estimates_s = Left(len(strokes_s)), 0.0, []
    for stroke_s in strokes_s:
        now_s += rest_s
        time_left.starts(now_s)
        for part in range(10):
            estimates_s.append(time_left.at(now_s + stroke_s * part / 10))
        now_s += stroke_s
        time_left.ends(now_s)
        estimates_s.append(time_left.at(now_s))
    estimates_s.append(time_left.at(now_s + rest_s + 1.0))
    foretold_s = [estimate_s for estimate_s in estimates_s if estimate_s is not None]
    assert all(after <= before for before, after in pairwise(foretold_s)) and foretold_s[-1] <= max(
        *strokes_s, rest_s, 1.0
    )
    assert all(estimate_s is None for estimate_s in estimates_s[:10])


def test_equal_strokes_are_foretold():
    time_left = Left(9)
    for stroke in range(3):
        time_left.starts(5.0 + 30.0 * stroke)
        time_left.ends(30.0 + 30.0 * stroke)
    assert time_left.at(90.0) == pytest.approx(6 * 30.0 + 5.0) and time_left.at(100.0) == pytest.approx(6 * 30.0 - 5.0)


def test_without_a_plan_nobody_knows_how_long_it_takes():
    time_left = Left(0)
    time_left.ends(3.0)
    assert time_left.at(4.0) is None


def test_a_clock_is_read_as_a_person_reads_it():
    assert [clock(seconds) for seconds in (0, 65, 3599.9, 7200)] == ["0:00", "1:05", "59:59", "2:00:00"]


@pytest.mark.long
def test_the_example_rig_takes_its_time_and_a_second_recording(tmp_path):
    """The README's two commands on a terminal: the rig at a pace of its own, then another capture of the same rig."""
    link = tmp_path / "rig"
    command = [sys.executable, "-m", "pipeline.rig", "small", "--link", str(link)]
    rig = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        assert "at 5 times real time" in rig.stdout.readline()
        for number in (1, 2):
            printed = _on_a_terminal(["-m", "pipeline.capture", str(link), str(tmp_path / f"run-{number}")])
            assert "complete, 1271 samples" in printed
            rises = re.findall(r"stroke (\d) of 5", printed)
            assert rises == sorted(rises) and len(rises) > 5
            assert printed.count(CLEAR) > 10  # at no pace at all it would be over before the line is renewed so often
            line = next(line for line in iter(rig.stdout.readline, "") if "is recorded" in line)
            assert f"recording {number} is recorded" in line
        first, second = ((tmp_path / f"run-{number}" / "recording.frames").read_bytes() for number in (1, 2))
        assert first != second
        assert rig.poll() is None
    finally:
        rig.terminate()
        rig.wait()
        rig.stdout.close()


def _on_a_terminal(arguments: list[str]) -> str:
    """What a program writes to a terminal until it ends."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen([sys.executable, *arguments], stdout=theirs, stderr=theirs)
    os.close(theirs)
    printed = b""
    while process.poll() is None or select.select([ours], [], [], 0)[0]:
        if select.select([ours], [], [], 0.1)[0]:
            try:
                printed += os.read(ours, 4096)
            except OSError:  # it has closed its end
                break
    process.wait()
    os.close(ours)
    return printed.decode()
