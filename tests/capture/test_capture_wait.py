"""A rig that prints text and begins late: a board that boots, homes its motor and tares is waited for, to an end."""

import json
import os
import signal
import time

import pytest
from capture.test_capture_text import HEADER, LINES, rig, until

__all__ = ["rig"]
BOOT_S = 6.0  # longer than what a rig that prints at once needs
BANNER = b"twistbench rig 3\r\nhoming the motor ...\r\n"
COLUMNS = ["--columns", "time_ms,motor_turns,displacement_mm"]


@pytest.mark.parametrize(
    ("first", "then", "options"),
    [(b"", HEADER, []), (BANNER, HEADER, []), (HEADER, b"", []), (b"", b"", COLUMNS)],
    ids=["silent", "a banner, then silent", "the header, then silent", "silent, its columns given"],
)
def test_a_rig_that_boots_homes_and_tares_is_waited_for_and_the_screen_says_so(first, then, options, rig, tmp_path):
    """It was refused after 5 s: said nothing; or its run was ended after 3 s of silence, without a sample."""
    ours, start = rig
    process, printed = start(*options), tmp_path / "run-1" / "recording.lines"
    until(lambda: printed.exists() if options else process.poll() is None, process)
    time.sleep(0.0 if options else 1.0)
    os.write(ours, first)
    time.sleep(BOOT_S)
    os.write(ours, then + b"".join(LINES))
    until(lambda: printed.exists() and printed.read_bytes().endswith(LINES[-1]), process)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 0, output
    assert "waiting for the rig's first line of numbers, for 2" in output and "s more (--wait): it may boot" in output
    received = json.loads((tmp_path / "run-1" / "capture.json").read_text())["samples"]["received"]
    assert received >= len(LINES) - 1, "all but a first line that may be half a one"


def test_the_wait_ends_when_its_flag_says(rig, tmp_path):
    _, start = rig
    process = start("--wait", "2.5")
    began_s = time.monotonic()
    output, _ = process.communicate(timeout=60)
    assert time.monotonic() - began_s < 15.0 and process.returncode == 2
    assert "device: said nothing for 2.5 s" in output and "raise --wait" in output and not (tmp_path / "run-1").exists()
    named = start("--wait", "4", *COLUMNS)
    output, _ = named.communicate(timeout=60)
    assert (
        named.returncode != 0 and "ended by the wait for a first line of numbers, which --wait makes longer" in output
    )


@pytest.mark.parametrize("words", [["--wait", "0", "--text"], ["--wait", "nan", "--text"], ["--wait", "5"]])
def test_a_wait_that_is_none_is_refused(words, rig):
    _, start = rig
    process = start("--recover", "nowhere", *words)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 2 and "--wait goes with --text, and must be above 0 seconds" in output
