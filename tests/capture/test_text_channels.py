"""A rig that prints text into a described run: what is read as which channel, and what is said where that cannot be."""

import json
import os
import re
import time

import pytest
import ready
import yaml
from capture.test_capture_text import rig
from made_recording import content

from pipeline.capture.printed.lines import Lines
from pipeline.capture.printed.read_channels import ReadChannels
from pipeline.capture.printed.telling import Telling

__all__ = ["rig"]
ROW = b"%d,%.4f,20.0,%.3f\r\n"
OWN = {"time_s": {"column": "t_ms", "unit": "ms"}, "motor_turns": "turns", "load_n": "load", "displacement_mm": "disp"}


def printing(rig, folder, *options, header=b"", greets_s=0.0, channels=None, sign=1.0):
    """Exit status and words of a recording of a rig that greets, homes, and prints four numbers in its own order."""
    ours, start = rig
    folder.mkdir(exist_ok=True)
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=channels), sort_keys=False))
    process, began_s = start("--longest", f"{3.5 + greets_s}", *options), time.monotonic()
    if greets_s:
        while not (folder / "recording.lines").exists():
            time.sleep(0.02)
        os.write(ours, b"TSA rig 3 axes\r\n3 axes, homing ...\r\n")
        time.sleep(greets_s)
    number = 0
    while process.poll() is None and time.monotonic() - began_s < 60.0:
        turns = 0.05 * number
        os.write(ours, header * (number % 10 == 0) + ROW % (50 * number, turns, sign * turns**2 / 34.0))
        number += 1
        time.sleep(0.05)
    return process.returncode, process.stdout.read()


def test_lines_without_a_header_get_the_names_of_the_runs_own_description_in_its_order(rig, tmp_path):
    """Load and displacement were the wrong way round, and the names were not those of run.yaml."""
    folder = tmp_path / "run-1"
    status, words = printing(rig, folder, channels=OWN)
    command = f"--recover {folder} --columns t_ms,turns,load,disp"
    warning = next(line for line in words.splitlines() if line.startswith("warning: no line is read yet"))
    check = "the order is that of run.yaml, and the rig's may be another; check each name by the last line"
    values = r"t_ms = \d+, turns = [\d.]+, load = 20\.0, disp = [\d.]+; where a value is another column's"
    exchange = f"{re.escape(f'by the command below; {check}')}: {values}, exchange the names"
    assert status == 2 and re.search(f"{exchange}$", warning) and command not in warning, words
    below = rf"{exchange}\n  python -m pipeline\.capture {re.escape(command)}"
    assert re.search(rf"{below}\n", words), "it stood in the middle of 450 characters"
    end = rf"Mend: name the columns, by the command below\n  python -m pipeline\.capture {re.escape(command)}"
    assert re.search(rf"error: .*{end}$", words.rstrip()), "no full stop stands behind a name"
    assert len(re.findall(exchange, words)) == 1, "the paragraph stood twice"
    done = ready.run("pipeline.capture", *command.split())
    assert done.returncode == 0 and "nothing can use" not in done.stdout, done.stdout


def test_lines_that_a_run_without_channels_does_not_tell_get_gaps_and_no_guessed_order(rig, tmp_path):
    status, words = printing(rig, tmp_path / "run-1")
    assert status == 2 and words.rstrip().endswith("--columns time_ms,...,...,..."), words
    assert "with a name for each ... (motor_turns, displacement_mm, load_n" in words


def test_a_header_that_the_run_does_not_know_is_warned_of_beside_what_is_read_and_is_no_success(rig, tmp_path):
    """For 50 s it looked fine; at the end nothing could use the run, and the exit status was 0."""
    folder = tmp_path / "run-1"
    status, words = printing(rig, folder, header=b"t_ms,turns,load,disp\r\n")
    lines = words.splitlines()
    reads = next(at for at, line in enumerate(lines) if line.startswith("reads "))
    assert lines[reads + 1].startswith(
        "warning: nothing can use this run as it stands: there are no columns 'motor_turns' and 'displacement_mm'"
    ), words
    right = f"--recover {folder} --columns t_ms,motor_turns,load_n,displacement_mm;"
    assert right in lines[reads + 1] and right in lines[-1] and "did you mean" not in words, words
    assert status == 2 and (folder / "recording.csv").exists() and "Until then nothing can use this run." in words
    assert ready.run("pipeline.capture", *right[:-1].split()).returncode == 0


def test_what_is_read_as_which_channel_is_said_of_each_column_with_its_unit(rig, tmp_path):
    """Three of four columns were shown, by their own names: a swap could not be seen."""
    channels = {**OWN, "displacement_mm": {"column": "disp", "scale": -1}}
    status, words = printing(rig, tmp_path / "run-1", header=b"t_ms,turns,load,disp\r\n", channels=channels, sign=-1.0)
    line = next(line for line in words.splitlines() if line.startswith("reads "))
    assert status == 0 and "time_s = " in line and " ms (from t_ms), motor_turns = " in line, words
    assert "load_n = 20.0 N (from load), displacement_mm = " in line and " mm (from disp, times -1);" in line


def test_six_columns_are_shown_and_one_that_is_no_channel_is_said_to_be_none(tmp_path):
    folder = tmp_path / "run-1"
    folder.mkdir()
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    columns = ["time_ms", "motor_turns", "displacement_mm", "button", "a", "b", "c"]
    read = ReadChannels(folder, columns)
    assert read.values("1234567") == [
        *("time_s = 1 ms (from time_ms)", "motor_turns = 2", "displacement_mm = 3", "button = 4 (no channel)"),
        *("a = 5 (no channel)", "b = 6 (no channel)", "1 more"),
    ]
    assert read.warning() == ""


@pytest.mark.parametrize("noise", [False, True], ids=["text", "noise"])
def test_a_rig_that_greets_and_homes_is_not_warned_of_before_it_had_time_to(rig, tmp_path, noise):
    """After 1 s of homing: "2 lines came, and none of numbers. Mend: check --baud"."""
    ours, start = rig
    columns = ["--columns", "t_ms,turns,load,disp"]
    if not noise:
        status, words = printing(rig, tmp_path / "run-1", *columns, greets_s=2.5, channels=OWN)
        assert status == 0 and "warning: no line" not in words and "--baud" not in words, words
        return
    process = start(*columns, "--longest", "3")
    while process.poll() is None:
        os.write(ours, b"\xfe\x80\x13\n\x91\xa5\n")
        time.sleep(0.1)
    words = process.stdout.read()
    assert "warning: no line is read yet" in words and "Mend: check --baud" in words, words


def test_a_narrow_line_shows_the_count_and_the_last_values(tmp_path):
    """On 80 columns it was `0:08 recorded` and nothing else."""
    lines = Lines()
    for line in (b"t_ms,turns,disp,load", b"26000,20.0000,11.765,20.000"):
        lines.take(line + b"\r\n")
    *narrow, counts = Telling(lines, tmp_path, time.monotonic())._parts()
    assert narrow == ["0:00 recorded", "1 line", "turns = 20.0000", "disp = 11.765", "load = 20.000"]
    assert len(", ".join(narrow)) < 80 and counts == lines.counts()


def test_a_remark_with_fewer_words_than_the_lines_have_numbers_names_no_columns():
    """A rig whose header was lost printed `WARN temperature high`: its lines were all bad since, and no order told."""
    lines, row = Lines(), b"26000,20.0000,11.765,20.000\r\n"
    for line in (row, row, b"WARN temperature high\r\n", row, row):
        lines.take(line)
    assert (lines.bad, lines.text, lines.unnamed.count) == (0, 1, 3) and not lines.columns
    lines.take(b"t_ms,turns,disp,load\r\n")
    assert lines.take(row) and lines.columns == ("t_ms", "turns", "disp", "load")


@pytest.mark.parametrize("clock", ["ms", "Uhr"])
def test_the_column_that_run_yaml_reads_as_the_time_is_the_clock_while_it_records_and_at_the_end(rig, tmp_path, clock):
    """Live `reads time_s = 2000 ms (from ms)`, at the end "the rig prints no time"."""
    channels = {**OWN, "time_s": {"column": clock, "unit": "ms"}}
    status, words = printing(rig, tmp_path / "run-1", header=f"{clock},turns,load,disp\r\n".encode(), channels=channels)
    assert status == 0 and f" ms (from {clock}), motor_turns" in words and "prints no time" not in words, words
    live = next(line for line in words.splitlines() if " recorded, " in line)
    assert f"{clock} = " not in live and "turns = " in live, words
    assert json.loads((tmp_path / "run-1/capture.json").read_text())["lines"]["device_time"]
