"""A rig that prints text and goes away: the first end tells of the fault, and after the mend nothing is wrong."""

import os
import pty
import re
import shlex
import time
import tty
from pathlib import Path

import ready
import yaml
from capture.test_text_mends import NAMED, ROWS
from made_recording import content

HEADER = "t_ms,turns,disp\n"


def gone(folder: Path, header: str, sign: str = "") -> tuple[int, str]:
    """Exit status and words of a recording of a described rig, whose port goes away after its last line."""
    folder.mkdir()
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=NAMED), sort_keys=False))
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    process = ready.start("pipeline.capture", "--text", os.ttyname(theirs), str(folder))
    rows = [f"{t},{turns},{sign}{disp}\n" for t, turns, disp in (row.split(",") for row in ROWS.split())]
    until_s = time.monotonic() + 60.0
    while not (folder / "recording.lines").exists() and time.monotonic() < until_s and process.poll() is None:
        os.write(ours, header.encode() or rows.pop(0).encode())
        time.sleep(0.05)
    for row in rows:
        os.write(ours, row.encode())
        time.sleep(0.004)  # 3 s in all: the screen has time to say what it sees
    os.close(theirs)
    os.close(ours)
    output, _ = process.communicate(timeout=60)
    return process.returncode, output


def recover(*options: object) -> tuple[int, str]:
    done = ready.run("pipeline.capture", "--recover", *options)
    return done.returncode, done.stdout + done.stderr


def test_a_recording_that_was_mended_is_exit_0_though_its_device_went_away(tmp_path):
    """It was 1 whatever the person had done, and the second time 0 with words of an exit status 1."""
    folder = tmp_path / "run-1"
    status, words = gone(folder, HEADER, "-")
    assert status == 1 and "the port went away" in words and "Until then nothing can use this run." in words, words
    assert recover(folder)[0] == 1, "nobody has mended it yet"
    command = re.search(r"Next: mend it, .*pipeline\.mend (.*)", words)[1]
    assert ready.run("pipeline.mend", *command.split()).returncode == 0
    status, words = recover(folder)
    assert status == 0 and "2 strokes\n" in words and "exit status" not in words and "Next:" in words, words


def test_the_end_of_a_recording_that_nothing_names_repeats_the_command_and_not_the_paragraph(tmp_path):
    folder = tmp_path / "run-1"
    status, words = gone(folder, "")
    command = f"  python -m pipeline.capture --recover {folder} --columns t_ms,turns,disp"
    live, end = words.split("recorded, ")
    assert status == 2 and command in live.splitlines() and end.splitlines()[-1] == command, words
    assert "check it by the last line" in live and "lines of 3 numbers like" in live, live
    sentence = end.splitlines()[-2]
    assert sentence.startswith("error: ") and len(sentence) - len(str(folder)) < 150, sentence
    status, words = recover(*shlex.split(command.partition("--recover ")[2]))
    assert status == 0 and "the port went away" in words and "can be used: " in words, words
    assert recover(folder)[0] == 0


def test_a_good_recording_whose_device_went_away_tells_of_the_fault(tmp_path):
    status, words = gone(tmp_path / "run-1", HEADER)
    assert status == 1 and "in 2 strokes; the exit status 1 tells of the fault" in words, words
