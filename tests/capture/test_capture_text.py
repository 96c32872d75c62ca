"""Rigs that print lines of numbers: what is a line becomes a sample, and every other line is counted."""

import hashlib
import json
import os
import pty
import re
import select
import signal
import subprocess
import sys
import time
import tracemalloc
import tty
from datetime import datetime

import pytest
import ready
from hypothesis import given
from hypothesis import strategies as st

from pipeline.capture.printed.fields import MAX_LINE, fields, names
from pipeline.capture.printed.holes import Steps, find
from pipeline.capture.printed.lines import Lines, Splitter
from pipeline.capture.printed.lines_to_csv import recover_lines
from pipeline.capture.printed.read_channels import ReadChannels
from pipeline.ground.errors import BadInput
from pipeline.run.description import parse_run
from pipeline.run.table.recorded_table import check_lines, read_recording

HEADER = b"time_ms,motor_turns,displacement_mm\r\n"


def line(number: int) -> bytes:
    return b"%d,%.2f,%.2f\r\n" % (number * 20, number * 0.25, number * 0.1)


LINES = [line(number) for number in range(50)]


class Read:
    """What is read of bytes that were printed."""

    def __init__(self, data: bytes, columns: tuple[str, ...] = (), piece: int = 1 << 20) -> None:
        self.lines, self.steps, splitter = Lines(columns), Steps(), Splitter()
        split = [line for at in range(0, len(data), piece) for line in splitter.feed(data[at : at + piece])]
        self.rows = [row for row in map(self.lines.take, split) if row is not None]
        self.tail_bytes = splitter.tail_bytes
        times = [float(row[self.lines.time_at]) for row in self.rows] if self.lines.time_at >= 0 else []
        for row_time in times:
            self.steps.take(row_time)
        self.holes = find(times, self.steps.usual)


def test_lines_become_rows_as_they_were_printed():
    read = Read(HEADER + b"".join(LINES))
    assert read.lines.columns == ("time_ms", "motor_turns", "displacement_mm")
    assert read.rows == [raw_line.decode().strip().split(",") for raw_line in LINES]
    assert (read.lines.bad, read.steps.backward, read.holes, read.tail_bytes) == (0, 0, (0, []), 0)


@pytest.mark.parametrize(
    "broken",
    [b"1,2\n", b"1,2,3,4\n", b"1,x,3\n", b"1,nan,3\n", b"1,1_0,3\n", b"1,\xff,3\n", b"1,2,3" + b"0" * 2000 + b"\n"],
)
def test_what_is_no_line_of_numbers_is_counted_by_its_place(broken):
    read = Read(b"".join([HEADER, *LINES[:10], broken, *LINES[10:]]))
    assert len(read.rows) == 50 and read.lines.bad_lines == [12] and read.lines.text == 0


def test_the_half_line_at_the_beginning_is_no_sample_though_it_looks_like_one():
    read = Read(LINES[30][1:] + b"".join(LINES[31:]), ("time_ms", "motor_turns", "displacement_mm"))
    assert len(read.rows) == 19 and read.rows[0][0] == "620"


def test_the_half_line_at_the_end_is_none_either():
    read = Read(HEADER + b"".join(LINES)[:-4])
    assert len(read.rows) == 49 and read.tail_bytes == len(LINES[-1]) - 4


def test_missing_lines_show_in_the_devices_time():
    read = Read(b"".join([HEADER, *LINES[:10], *LINES[13:]]))
    assert read.holes == (1, [{"after_samples": 10, "after_time": 180.0, "samples_about": 3}])


def test_a_reset_shows_in_the_devices_time():
    read = Read(b"".join([HEADER, *LINES[:30], b"\n# ready\n", HEADER, *LINES[:10]]))
    assert read.steps.backward == 1 and read.lines.bad == 0 and len(read.rows) == 40


@pytest.mark.parametrize("text", [b"1;2;3\n", b"1 2 3\n", b"1\t2\t3\n", b" 1, 2 ,3\n", b"1, 2, 3\n"])
def test_separators_are_understood(text):
    assert Read(HEADER + text).rows == [["1", "2", "3"]]


BOOT = (b"ets Jul 29 2019\r\n", b"TSA rig v2 ready\r\n", b"Hello, string world\r\n", b"> calibrating ...\r\n")


@pytest.mark.parametrize("header", [b"time_ms,motor_turns,displacement_mm\n", b"t;theta;x\n", b"time turns mm\n"])
def test_greetings_and_messages_are_passed_over_wherever_they_stand(header):
    printed = [*BOOT, header, *BOOT, *LINES[:20], b"debug: temp 25\n", *LINES[20:], b"done, bye now\n"]
    read = Read(b"".join(printed))
    assert len(read.rows) == 50 and len(read.lines.columns) == 3 and read.lines.columns[0].startswith("t")
    assert (read.lines.text, read.lines.bad) == (2 * len(BOOT) + 2, 0)
    assert read.lines.greetings[:2] == ["ets Jul 29 2019", "TSA rig v2 ready"]


def test_a_banner_of_as_many_words_as_there_are_columns_names_none():
    read = Read(b"TSA rig v2 ready\n" + b"1 2 3 4\n" * 5)
    assert not read.rows and read.lines.columns == () and (read.lines.bad, read.lines.unnamed.count) == (0, 5)
    assert "5 lines of 4 numbers like '1 2 3 4' came, and no line that names their columns" in read.lines.problem()[0]


@pytest.mark.parametrize("between", [";", " ", "\t", " ; "])
def test_decimal_commas_are_read_where_they_can_be_told(between):
    body = "".join(between.join((f"{n}", f"{n},25", f"-{n},5e-1")) + "\n" for n in range(3))
    read = Read(b"time_ms;motor_turns;displacement_mm\n" + body.encode())
    assert read.rows == [[f"{n}", f"{n}.25", f"-{n}.5e-1"] for n in range(3)] and read.lines.decimal_commas == 3


def test_decimal_commas_between_commas_are_refused_in_words():
    read = Read(HEADER + b"20,0,25,0,1\n" * 300)
    problem, mend = read.lines.problem()
    assert read.lines.bad == 300 and not read.rows
    assert problem.endswith("'20,0,25,0,1' have 5 numbers, and the columns are time_ms, motor_turns, displacement_mm")
    assert "print decimal points or put ; between" in mend and "--columns" in mend


def test_a_second_header_with_swapped_columns_puts_the_fields_back():
    swapped = [
        b"displacement_mm,time_ms,motor_turns\n",
        *(b"%.2f,%d,%.2f\n" % (n * 0.1, n * 20, n * 0.25) for n in range(50, 60)),
    ]
    read = Read(b"".join([HEADER, *LINES, *swapped, HEADER, line(60)]))
    assert [row[0] for row in read.rows] == [str(20 * n) for n in range(61)]
    assert read.rows[55] == ["1100", "13.75", "5.50"] and read.lines.swapped == 1


def test_a_second_header_that_names_other_columns_ends_what_is_read_until_the_first_comes_again():
    read = Read(
        b"".join([HEADER, *LINES[:10], b"time_ms,load_n,displacement_mm\n", *LINES[10:20], HEADER, *LINES[20:]])
    )
    assert len(read.rows) == 40 and read.lines.bad == 10 and read.lines.others == 1


LABELLED = ["t:{} turns:{} x:{}\r\n", "t:{},turns:{},x:{}\r\n", "t: {}; turns: {}; x: {}\n", "t={}\tturns={}\tx={}\n"]


@pytest.mark.parametrize("form", LABELLED)
def test_a_line_with_a_name_before_each_number_is_a_sample_of_these_names(form):
    printed = [form.format(20 * n, f"-{n}.25", f"{n}e-1") for n in range(40)]
    other = "x: 1, heap: 2, t: 3\n"  # a message in the same form, of other names
    order = "x:4.1 t:820 turns:-41.25\n"
    read = Read("".join(["fw: 3, rev: 2\n", *printed[:20], other, *printed[20:], order, *printed[:1]]).encode())
    assert read.lines.columns == ("t", "turns", "x") and read.lines.bad == 0 and read.lines.text == 2
    assert read.rows[:40] == [[f"{20 * n}", f"-{n}.25", f"{n}e-1"] for n in range(40)]
    assert read.rows[40:] == [["820", "-41.25", "4.1"], ["0", "-0.25", "0e-1"]]


@pytest.mark.parametrize("printed", [b"12:30:05 1 2\n", b"version: 2.1, board: 3\n", b"a: 1, b: 2, c: 3\n"])
def test_what_only_looks_like_names_before_numbers_names_none(printed):
    assert Read(HEADER + printed + line(1)).rows == [line(1).decode().strip().split(",")]
    assert Read(printed * 9).lines.columns == ()


def test_a_header_may_have_its_units_in_brackets():
    read = Read(b"time [ms], angle [turns], x [mm]\n" + b"".join(LINES))
    assert read.lines.columns == ("time [ms]", "angle [turns]", "x [mm]") and len(read.rows) == 50


def test_given_columns_win_over_what_the_rig_calls_them():
    read = Read(HEADER + b"".join(LINES), ("time_ms", "theta", "x_mm"))
    assert read.lines.columns == ("time_ms", "theta", "x_mm") and len(read.rows) == 50 and read.lines.bad == 0


def test_what_is_read_as_what_is_a_sentence(tmp_path):
    read = Read(b"".join([*BOOT, HEADER, *LINES[:5], b"1,2\n"]))
    sentence = (
        "reads time_ms = 80, motor_turns = 1.00, displacement_mm = 0.40; 5 lines are read, 5 are not (4 of text, 1 bad)"
    )
    values = ReadChannels(tmp_path, read.lines.columns).values(read.lines.last)
    assert read.lines.reading(values) == sentence


def test_a_line_is_counted_as_one():
    assert Read(BOOT[0] + HEADER + LINES[0]).lines.counts() == "1 line is read, 1 is not (1 of text, 0 bad)"
    assert Read(BOOT[0] + HEADER + LINES[0] + LINES[1]).lines.counts().startswith("2 lines are read, 1 is not")
    assert Read(LINES[0] + LINES[1]).lines.counts() == "1 line of numbers is kept, and nothing names the columns"
    assert Read(b"ready\r\n").lines.problem()[0] == "1 line came, and none of numbers"


@given(st.binary(max_size=600), st.binary(max_size=300), st.integers(1, 50))
def test_no_bytes_make_it_raise(garbage, more, piece):
    for data in (garbage, HEADER + garbage, garbage + b"\n" + HEADER + more):
        read = Read(data)
        assert all(len(row) == len(read.lines.columns) for row in read.rows)
        assert read.rows == Read(data, piece=piece).rows
        read.lines.problem()


def test_a_line_without_an_end_takes_no_memory():
    splitter = Splitter()
    for _ in range(100):
        assert splitter.feed(b"1" * 100_000) == []
        assert len(splitter._rest) <= MAX_LINE + 2
    (line,) = splitter.feed(b"\n")
    assert fields(line) == ([], "") and splitter.tail_bytes == 0


@pytest.mark.parametrize("text", [b"", b"1,2", b"time", b"a,a", b"a,=cmd()", b"\xff,b"])
def test_what_is_no_header_names_nothing(text):
    assert names(text) == ()


@pytest.fixture
def rig(tmp_path):
    """A port that prints, and a capture program on it: (our end, start)."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    started = []

    def start(*options: str) -> ready.Program:
        port = [] if "--recover" in options else [os.ttyname(theirs), str(tmp_path / "run-1"), "--text"]
        started.append(ready.start("pipeline.capture", *port, *options))
        return started[-1]

    yield ours, start
    for program in started:
        if program.poll() is None:
            program.kill()
        program.wait()
        program.stdout.close()
    os.close(theirs)
    os.close(ours)


def until(condition, process) -> None:
    until_s = time.monotonic() + 60
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
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 0 and "45 samples, 1 bad line\n" in output and "about 5 samples missing" in output
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
    assert start("--recover", str(folder)).wait(60) == 0, "the names that --columns gave were noted beside it"
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


def test_what_a_rig_prints_without_names_is_kept_and_named_by_recover(rig, tmp_path):
    ours, start = rig
    process, folder, number = start(), tmp_path / "run-1", 0

    def prints() -> None:
        nonlocal number
        os.write(ours, line(number))
        number += 1
        time.sleep(0.05)

    def begun() -> bool:
        prints()
        return (folder / "recording.lines").exists()

    until(begun, process)
    for _ in range(40):  # two seconds: it warns
        prints()
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 2 and re.search(
        r"warning: no line is read yet, but all are kept: \d+ lines of 3 numbers", output
    ), output
    assert "in the order in which the rig prints them" in output
    assert f"python -m pipeline.capture --recover {folder} --columns ...,...,..." in output.splitlines()[-1]
    kept = (folder / "recording.lines").read_bytes()
    assert kept.count(b"\n") > 45  # those before it knew that no name would come, too
    named = start("--recover", str(folder), "--columns", "time_ms,motor_turns,displacement_mm")
    assert named.wait(60) == 0
    assert json.loads((folder / "capture.json").read_text())["samples"]["received"] == kept.count(b"\n") - 1


def test_a_misspelt_channel_is_asked_about_before_anything_is_recorded(rig):
    _, start = rig
    process = start("--columns", "time_ms,motor_truns,displacement_mm")
    assert "run.yaml: is missing" in process.stdout.readline()
    assert process.stdout.readline().startswith(
        "--columns: motor_truns is no channel; did you mean time_ms,motor_turns,displacement_mm? What is recorded"
    )


def nameless(ours, start, folder, columns: str = "") -> tuple[int, str, float, float]:
    """Exit status and words of a recording of 60 lines of four numbers, and when it was started and ended."""
    began_s = time.time()
    process = start("--longest", "3", *(["--columns", columns] if columns else []))
    number = 0
    while process.poll() is None:
        os.write(ours, b"%d,1.5,2.5,20.0\r\n" % round(1000 * (time.time() - began_s)))
        number += 1
        time.sleep(0.05)
    return process.returncode, process.stdout.read(), began_s, time.time()


def test_a_recording_without_names_is_named_afterwards_as_if_they_had_been_known_from_the_start(rig, tmp_path):
    ours, start = rig
    folder = tmp_path / "run-1"
    status, output, began_s, ended_s = nameless(ours, start, folder)
    command = f"python -m pipeline.capture --recover {folder} --columns time_ms,...,...,..."
    warning = next(printed_line for printed_line in output.splitlines() if printed_line.startswith("warning: no line"))
    assert status == 2 and warning.endswith(command) and output.rstrip().endswith(command), output
    assert " bad" not in output and "lines of 4 numbers like" in output, output
    kept = (folder / "recording.lines").read_bytes()
    os.utime(folder / "recording.lines", (0, 0))  # a copy keeps no time
    refused = start("--recover", str(folder), "--columns", command.split()[-1])
    assert "put a name in the place of each ..." in refused.communicate(timeout=60)[0] and refused.returncode == 2
    named = start("--recover", str(folder), "--columns", "time_ms,motor_turns,displacement_mm,load_n")
    output, _ = named.communicate(timeout=60)
    info = json.loads((folder / "capture.json").read_text())
    assert named.returncode == 0 and "ended by --longest after 3 s" in output, output
    assert (info["exit_status"], info["ended_by"]) == ("ended", "--longest after 3 s")
    started_s, over_s = (datetime.fromisoformat(info[key]).timestamp() for key in ("started_utc", "ended_utc"))
    assert began_s <= started_s < over_s <= ended_s and over_s - started_s > 2.9
    assert info["samples"]["received"] == kept.count(b"\n") - 1
    assert (info["lines"]["bad"], info["lines"]["unnamed"], info["lines"]["text"]) == (0, 0, 0)
    assert sorted(os.listdir(folder)) == ["capture.json", "recording.csv", "recording.lines"]


def test_a_header_that_comes_again_names_the_lines_after_it_and_the_others_can_be_read_too(rig, tmp_path):
    ours, start = rig
    process, folder = start("--longest", "3"), tmp_path / "run-1"
    number, begun = 0, 0
    while process.poll() is None:
        begun += (folder / "recording.lines").exists()  # on a busy machine it takes a while
        os.write(ours, (HEADER if begun == 15 else b"") + line(number))
        number += 1
        time.sleep(0.05)
    output = process.stdout.read()
    info = json.loads((folder / "capture.json").read_text())
    assert process.returncode == 0 and info["samples"]["received"] > 3 and info["lines"]["unnamed"] > 3
    command = f"pipeline.capture --recover {folder} --columns time_ms,motor_turns,displacement_mm"
    assert f"{info['lines']['unnamed']} lines of numbers came before anything named their columns" in output
    assert f"{command} reads them too" in output and info["lines"]["bad"] == 0
    assert start("--recover", str(folder), *command.split()[3:]).wait(60) == 0
    after = json.loads((folder / "capture.json").read_text())
    assert after["samples"]["received"] == info["samples"]["received"] + info["lines"]["unnamed"]
    assert after["started_utc"] == info["started_utc"]


@pytest.mark.parametrize(
    ("row", "each_s", "columns"),
    [
        ("{n},1,2", 0.001, "time_ms,...,..."),
        ("{n},1,2,3", 1.0, "time_s,...,...,..."),
        ("{n},1,2", 1e-6, "time_us,...,..."),
        ("{n},1,2", 0.1, "...,...,..."),
        ("{n},1", 0.1, "...,..."),
        ("{n},1,2,3,4,5,6,7", 1.0, "time_s,...,...,...,...,...,...,..."),
    ],
)
def test_the_names_that_are_proposed_are_as_many_as_the_numbers_and_know_the_clock(row, each_s, columns):
    read = Read("".join(row.format(n=n) + "\n" for n in range(101)).encode() + b"1,2,3,4,5\n")
    _, mend = read.lines.problem(99 * each_s, "again")
    assert mend.endswith(f"again --columns {columns}"), mend


def test_what_is_no_line_of_numbers_at_all_is_refused_and_begins_no_run(rig, tmp_path):
    ours, start = rig
    process = start()
    until_s = time.monotonic() + 60
    while process.poll() is None and time.monotonic() < until_s:
        os.write(ours, b"#!?$,%\r\n7\r\n")
        time.sleep(0.1)
    assert process.returncode == 2 and "no sample" in process.stdout.read()
    assert not (tmp_path / "run-1").exists()


def test_a_rig_that_falls_silent_has_no_fault(rig, tmp_path):
    ours, start = rig
    process, folder = start(), tmp_path / "run-1"
    print_header(ours, folder, process)
    os.write(ours, b"".join(LINES))
    output, _ = process.communicate(timeout=60)
    info = json.loads((folder / "capture.json").read_text())
    assert process.returncode == 0 and (info["exit_status"], info["fault"]) == ("ended", None)
    assert info["ended_by"].startswith("3 s of silence") and f"{folder}: ended by 3 s of silence" in output


def test_a_time_that_falls_back_may_be_another_column(rig, tmp_path):
    _, start = rig
    folder = tmp_path / "run-1"
    folder.mkdir()
    (folder / "recording.lines").write_bytes(b"".join(LINES + LINES))
    output, _ = start("--recover", str(folder), "--columns", "t_ms,turns,mm").communicate(timeout=60)
    assert "falls back 1 time: was it reset, or is the time another column than t_ms?" in output


def test_the_screen_says_what_is_read_as_what_while_it_records(rig, tmp_path):
    ours, start = rig
    process, folder = start(), tmp_path / "run-1"
    os.write(ours, b"".join(BOOT))
    print_header(ours, folder, process)
    output = ""
    for number in range(2000):
        os.write(ours, line(number) + (b"moving on\r\n" if number % 50 == 0 else b""))
        ready, _, _ = select.select([process.stdout], [], [], 0.02)
        if ready and not re.search(r"Ctrl-C or kill|run\.yaml: is missing", output := process.stdout.readline()):
            break
    assert re.fullmatch(
        r"reads time_ms = \d+, motor_turns = [\d.]+, displacement_mm = [\d.]+; "
        r"\d+ lines? (is|are) read, \d+ (is|are) not \(\d+ of text, 0 bad\)\n",
        output,
    ), output
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 0, output
    info = json.loads((folder / "capture.json").read_text())
    assert info["samples"]["received"] > 10 and info["lines"]["bad"] == 0 and info["lines"]["text"] >= 1


def test_a_rig_that_prints_for_ever_is_ended_by_longest(rig, tmp_path):
    ours, start = rig
    process, folder = start("--columns", "time_ms,motor_turns,displacement_mm", "--longest", "1"), tmp_path / "run-1"
    until((folder / "recording.lines").exists, process)
    number = 0
    while process.poll() is None:
        os.write(ours, line(number))
        number += 1
        time.sleep(0.02)
    assert process.returncode == 0 and "ended by --longest after 1 s" in process.stdout.read()
    info = json.loads((folder / "capture.json").read_text())
    assert info["samples"]["received"] > 3
    assert (info["exit_status"], info["fault"], info["ended_by"]) == ("ended", None, "--longest after 1 s")
    assert start("--recover", str(folder), "--columns", "time_ms,turns,mm").wait(60) == 0  # and is kept
    assert json.loads((folder / "capture.json").read_text())["ended_by"] == "--longest after 1 s"


def test_holes_of_one_size_are_told_in_one_line(rig, tmp_path):
    _, start = rig
    folder = tmp_path / "run-1"
    folder.mkdir()
    kept_lines = [raw_line for number, raw_line in enumerate(LINES) if number not in (5, 10, 15, 20, 30, 31, 32)]
    (folder / "recording.lines").write_bytes(b"".join([HEADER, *kept_lines]))
    output, _ = start("--recover", str(folder)).communicate(timeout=60)
    holes = "about 3 samples missing, after the device's time 580 ms; 4 times about 1 sample missing, first after"
    assert len(re.findall("samples? missing", output)) == 2 and f"{folder}: {holes} the device's time 80 ms\n" in output


def test_the_mend_for_columns_without_names_knows_seconds_and_milliseconds():
    read = Read(b"".join(LINES))
    assert (
        "order in which the rig prints them, with a name for each ... (time_s or time_ms, motor_turns, displacement_mm"
        in read.lines.problem()[1]
    )


def test_a_port_that_comes_late_is_waited_for(tmp_path):
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    link, folder = tmp_path / "port", tmp_path / "run-1"
    command = [sys.executable, "-m", "pipeline.capture", "--text", str(link), str(folder), "--longest", "1"]
    command += ["--columns", "time_ms,motor_turns,displacement_mm"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        assert process.stdout.readline().startswith(f"warning: {folder}: run.yaml: is missing")
        assert process.stdout.readline() == f"{link}: is not there yet; waiting 10 s for it\n"
        link.symlink_to(os.ttyname(theirs))
        until((folder / "recording.lines").exists, process)
        for number in range(3000):
            if process.poll() is not None:
                break
            os.write(ours, line(number))
            time.sleep(0.02)
        output, _ = process.communicate(timeout=60)
        assert process.returncode == 0 and "ended by --longest" in output, output
    finally:
        process.kill()
        process.wait()
        os.close(theirs)
        os.close(ours)


COMMAS = b"".join(b"%d,%d,25,%d,1\r\n" % (number * 20, number, number) for number in range(300))


def test_a_run_without_a_sample_is_no_success_and_says_so_while_it_records(rig, tmp_path):
    ours, start = rig
    process, folder = start(), tmp_path / "run-1"
    print_header(ours, folder, process)
    for at in range(0, len(COMMAS), 100):
        os.write(ours, COMMAS[at : at + 100])
        time.sleep(0.04)
    until(lambda: (folder / "recording.lines").read_bytes().endswith(COMMAS), process)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 2 and "warning: no line is read yet, but all are kept: " in output.splitlines()[2], (
        output
    )
    assert "--recover" in output.splitlines()[-1] and "Traceback" not in output
    assert (folder / "recording.lines").exists() and not (folder / "capture.json").exists()
    assert not (folder / "recording.csv").exists()
    five = "time_ms,turns,turns_fraction,mm,mm_fraction"
    assert start("--recover", str(folder), "--columns", five).wait(60) == 0
    assert json.loads((folder / "capture.json").read_text())["samples"]["received"] == 300


def test_columns_that_were_guessed_wrongly_are_named_anew_by_recover(tmp_path):
    folder = tmp_path / "run-1"
    folder.mkdir()
    data = b"Real time rig\n" + b"".join(LINES).replace(b",", b" ")
    (folder / "recording.lines").write_bytes(data)
    before = recover_lines(folder, ())
    assert before["columns"] == ["Real", "time", "rig"]
    with pytest.raises(BadInput, match=r"there is nothing to recover; .* --columns"):
        recover_lines(folder, ())
    after = recover_lines(folder, ("time_ms", "motor_turns", "displacement_mm"))
    assert after["columns"] == ["time_ms", "motor_turns", "displacement_mm"]
    with pytest.raises(BadInput, match="nothing to recover: it is read by these columns already"):
        recover_lines(folder, ("time_ms", "motor_turns", "displacement_mm"))
    assert (after["started_utc"], after["sha256"]) == (before["started_utc"], before["sha256"])
    assert json.loads((folder / "capture.json").read_text()) == after
    assert (folder / "recording.csv").read_bytes().startswith(HEADER.replace(b"\r", b""))
    check_lines(folder / "recording.csv")
    assert (folder / "recording.lines").read_bytes() == data


@pytest.mark.long
def test_the_commit_of_a_long_text_run_takes_no_more_memory_than_of_a_short_one(tmp_path):
    def peak(count: int) -> int:
        folder = tmp_path / f"run-{count}"
        folder.mkdir()
        with (folder / "recording.lines").open("wb") as file:
            file.write(HEADER)
            file.writelines(map(line, range(count)))
        tracemalloc.start()
        assert recover_lines(folder, ())["samples"]["received"] == count
        used = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return used

    peak(100)  # what is made once
    assert peak(240_000) < 1.2 * peak(60_000)
