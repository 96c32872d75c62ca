"""Rigs that print lines of numbers: what is a line becomes a sample, and every other line is counted."""

import hashlib
import json
import os
import pty
import signal
import subprocess
import sys
import time
import tty

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pipeline.capture.lines import names, read_lines
from pipeline.capture.printed import recover_lines
from pipeline.errors import BadInput
from pipeline.recording import check_lines, read_recording
from pipeline.run_yaml import parse_run

HEADER = b"time_ms,motor_turns,displacement_mm\r\n"


def line(number: int) -> bytes:
    return b"%d,%.2f,%.2f\r\n" % (number * 20, number * 0.25, number * 0.1)


LINES = [line(number) for number in range(50)]


def test_lines_become_rows_as_they_were_printed():
    table = read_lines(HEADER + b"".join(LINES))
    assert table.columns == ("time_ms", "motor_turns", "displacement_mm")
    assert table.rows == [one.decode().strip().split(",") for one in LINES]
    assert (table.bad, table.backward, table.holes(), table.tail_bytes) == (0, 0, [], 0)


@pytest.mark.parametrize(
    "broken",
    [b"1,2\n", b"1,2,3,4\n", b"1,x,3\n", b"1,nan,3\n", b"1,1_0,3\n", b"1,\xff,3\n", b"1,2,3" + b"0" * 2000 + b"\n"],
)
def test_what_is_no_line_of_numbers_is_counted_by_its_place(broken):
    table = read_lines(b"".join([HEADER, *LINES[:10], broken, *LINES[10:]]))
    assert len(table.rows) == 50 and table.bad_lines == [12]


def test_the_half_line_at_the_beginning_is_no_sample_though_it_looks_like_one():
    table = read_lines(LINES[30][1:] + b"".join(LINES[31:]), ("time_ms", "motor_turns", "displacement_mm"))
    assert len(table.rows) == 19 and table.rows[0][0] == "620"


def test_the_half_line_at_the_end_is_none_either():
    table = read_lines(HEADER + b"".join(LINES)[:-4])
    assert len(table.rows) == 49 and table.tail_bytes == len(LINES[-1]) - 4


def test_missing_lines_show_in_the_devices_time():
    table = read_lines(b"".join([HEADER, *LINES[:10], *LINES[13:]]))
    assert table.holes() == [{"after_samples": 10, "after_time": 180.0, "samples_about": 3}]


def test_a_reset_shows_in_the_devices_time():
    table = read_lines(b"".join([HEADER, *LINES[:30], b"\n# ready\n", HEADER, *LINES[:10]]))
    assert table.backward == 1 and table.bad == 0 and len(table.rows) == 40


@pytest.mark.parametrize("text", [b"1;2;3\n", b"1 2 3\n", b"1\t2\t3\n", b" 1, 2 ,3\n"])
def test_separators_are_understood(text):
    assert read_lines(HEADER + text).rows == [["1", "2", "3"]]


def test_a_decimal_comma_is_no_separator():
    assert read_lines(b"a;b\n" + b"1,5;2,5\n").bad == 1


@given(st.binary(max_size=600), st.binary(max_size=300))
def test_no_bytes_make_it_raise(garbage, more):
    for data in (garbage, HEADER + garbage, garbage + b"\n" + HEADER + more):
        table = read_lines(data)
        assert all(len(row) == len(table.columns) for row in table.rows)
        table.holes()
        assert table.csv


@pytest.mark.parametrize("text", [b"", b"1,2", b"time", b"a,a", b"a,=cmd()", b"\xff,b"])
def test_what_is_no_header_names_nothing(text):
    assert names(text) == ()


@pytest.fixture
def rig(tmp_path):
    """A port that prints, and a capture program on it: (our end, start)."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    started = []

    def start(*options: str) -> subprocess.Popen:
        port = [] if "--recover" in options else [os.ttyname(theirs), str(tmp_path / "run-1"), "--text"]
        command = [sys.executable, "-m", "pipeline.capture", *port, *options]
        started.append(subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True))
        return started[-1]

    yield ours, start
    for one in started:
        if one.poll() is None:
            one.kill()
        one.wait()
        one.stdout.close()
    os.close(theirs)
    os.close(ours)


def until(condition, process) -> None:
    until_s = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < until_s and process.poll() is None, process.stdout.read()
        time.sleep(0.02)


def print_header(ours, folder, process) -> None:
    """Print the header until the program has begun, as a board that is reset again and again would."""
    printed = folder / "recording.lines"

    def begun() -> bool:
        if not printed.exists():
            os.write(ours, HEADER)
        time.sleep(0.1)
        return printed.exists()

    until(begun, process)


def test_a_rig_that_prints_is_recorded_byte_for_byte(rig, tmp_path):
    ours, start = rig
    process, folder = start(), tmp_path / "run-1"
    print_header(ours, folder, process)
    body = b"".join([*LINES[:20], b"12,#?!,3\r\n", *LINES[25:]])
    os.write(ours, body)
    until(lambda: (folder / "recording.lines").read_bytes().endswith(body), process)
    assert not (folder / "recording.csv").exists()
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=20)
    assert process.returncode == 0 and "45 samples, 1 bad lines" in said and "about 5 samples missing" in said
    info = json.loads((folder / "capture.json").read_text())
    csv = (folder / "recording.csv").read_bytes()
    assert csv == HEADER.replace(b"\r", b"") + b"".join([*LINES[:20], *LINES[25:]]).replace(b"\r", b"")
    assert info["csv_sha256"] == hashlib.sha256(csv).hexdigest()
    assert info["sha256"] == hashlib.sha256((folder / "recording.lines").read_bytes()).hexdigest()
    assert info["exit_status"] == "ended" and info["samples"] == {"sent": None, "received": 45}


def test_a_killed_text_capture_is_recovered(rig, tmp_path):
    ours, start = rig
    process, folder = start("--columns", "time_ms,motor_turns,displacement_mm"), tmp_path / "run-1"
    until((folder / "recording.lines").exists, process)
    body = b"".join(LINES)
    os.write(ours, body)
    until(lambda: (folder / "recording.lines").read_bytes() == body, process)
    process.kill()
    process.wait()
    refusal = start("--recover", str(folder))
    assert refusal.wait(20) == 2 and "no line names the columns" in refusal.stdout.read()
    assert start("--recover", str(folder), "--columns", "time_ms,motor_turns,displacement_mm").wait(20) == 0
    assert json.loads((folder / "capture.json").read_text())["exit_status"] == "recovered"
    assert (folder / "recording.csv").read_text().count("\n") == 50
    assert (folder / "recording.lines").read_bytes() == body


def test_a_table_that_was_changed_is_refused_and_made_again_from_what_was_printed(tmp_path):
    folder = tmp_path / "raw" / "run-1"
    folder.mkdir(parents=True)
    (folder / "recording.lines").write_bytes(HEADER + b"".join(LINES))
    string = {"material": "UHMWPE", "radius_mm": 0.4, "length_mm": 400, "stiffness_n_per_mm": 15}
    channels = {"time_s": {"column": "time_ms", "unit": "ms"}}
    run = parse_run(
        {"run": "run-1", "actuator": "twisted_pair", "string": string, "channels": channels}, folder / "run.yaml"
    )
    recover_lines(folder, ())
    good = read_recording(run, folder)
    assert good["displacement_mm"].iloc[-1] == pytest.approx(4.9)
    table = folder / "recording.csv"
    table.write_bytes(table.read_bytes().replace(b"4.90", b"9.90"))
    with pytest.raises(BadInput, match=r"recording\.csv: csv_sha256: its bytes are not .* --recover .*run-1;"):
        read_recording(run, folder)
    for name in ("recording.csv", "capture.json"):  # what it says to do
        (folder / name).unlink()
    recover_lines(folder, ())
    assert read_recording(run, folder).equals(good)


def test_a_table_beside_printed_lines_needs_its_hash(tmp_path):
    folder = tmp_path / "run-1"
    folder.mkdir()
    (folder / "recording.lines").write_bytes(HEADER + b"".join(LINES))
    info = recover_lines(folder, ())
    check_lines(folder / "recording.csv")
    (folder / "capture.json").write_text(json.dumps({key: info[key] for key in info if key != "csv_sha256"}))
    with pytest.raises(BadInput, match="csv_sha256"):
        check_lines(folder / "recording.csv")


def test_a_rig_that_prints_no_names_is_refused_with_the_mend(rig, tmp_path):
    ours, start = rig
    process = start()
    until_s = time.monotonic() + 20
    while process.poll() is None and time.monotonic() < until_s:
        os.write(ours, LINES[1])
        time.sleep(0.1)
    assert process.returncode == 2 and "--columns" in process.stdout.read()
    assert not (tmp_path / "run-1").exists()
