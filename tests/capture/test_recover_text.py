"""Recovery of what a rig printed, whatever its numbers are and whatever somebody wrote into capture.json."""

import json
import math
import re
import subprocess

import numpy as np
import pytest
import ready
import yaml
from made_recording import content

from pipeline.capture.printed.holes import MOST
from pipeline.capture.printed.likely_names import likely
from pipeline.capture.printed.lines_to_csv import recover_lines
from pipeline.capture.printed.naming import USUAL
from pipeline.capture.printed.near_names import doubt
from pipeline.ground.errors import BadInput
from pipeline.run.samples import read_strokes

HEADER = "time_ms,motor_turns,displacement_mm\n"
LINES = "".join(f"{20 * number},{number},{number / 10}\n" for number in range(50))
NAMES = "t,theta,x"


@pytest.fixture
def folder(tmp_path):
    """A run folder with nothing but what was printed."""
    folder = tmp_path / "run-1"
    folder.mkdir()
    (folder / "recording.lines").write_text(HEADER + LINES)
    return folder


def recover(folder, *options: str) -> subprocess.CompletedProcess[str]:
    return ready.run("pipeline.capture", "--recover", folder, *options)


@pytest.mark.parametrize(
    ("printed", "holes"),
    [
        (LINES + "-1e308,1,1\n1e308,1,1\n", [MOST - 1]),
        ("-1e308,1,1\n1e308,1,1\n" + LINES, [MOST - 1]),
        ("-1e308,1,1\n1e308,1,1\n" * 3, []),
        ("0,1,1\n1e-300,1,1\n2e-300,1,1\n1e308,1,1\n", [MOST - 1]),
    ],
)
def test_times_as_large_as_numbers_go_are_committed(folder, printed, holes):
    (folder / "recording.lines").write_text(HEADER + printed)
    done = recover(folder)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    info = json.loads((folder / "capture.json").read_text())
    assert info["samples"]["received"] == printed.count("\n")
    assert [hole["samples_about"] for hole in info["holes"]] == holes


def test_names_that_no_channel_has_are_said_with_the_command_that_mends_them(folder):
    """A newcomer named the columns as his rig does: it ended as a success, and the next program refused the run."""
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    (folder / "recording.lines").write_text(wound())
    done = recover(folder, "--columns", "t_ms,turns,mm")
    words = "there are no columns 'motor_turns' and 'displacement_mm', only t_ms, turns, mm"
    assert done.returncode == 2 and words in done.stdout and "Until then nothing can use this run." in done.stdout
    right = "t_ms,motor_turns,displacement_mm"
    assert f"printed: python -m pipeline.capture --recover {folder} --columns {right}; or name the" in done.stdout
    assert done.stdout.count("--recover") == 1 and "Next:" not in done.stdout, "the one command that works"
    done = recover(folder, "--columns", "time_ms,motor_turn,displacement_mm")
    assert "there is no column 'motor_turns', only time_ms, motor_turn, displacement_mm" in done.stdout
    right = f"time{right[1:]}"
    assert f"did you mean {right}? Then: python -m pipeline.capture --recover {folder} --columns {right}; or name" in (
        done.stdout
    )
    done = recover(folder, "--columns", "time_ms,motor_turns,displacement_mm")
    assert done.returncode == 0 and "nothing can use" not in done.stdout and "Next:" in done.stdout


def test_lines_before_a_header_of_other_names_get_one_command_that_reads_all(folder):
    """Two commands were printed, and the first one left the run unusable, with exit status 1."""
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    head, *lines = wound().splitlines(keepends=True)
    (folder / "recording.lines").write_text("".join([*lines[:100], "time_ms,turns,mm\n", *lines[100:]]))
    done = recover(folder)
    assert (
        "99 lines of numbers came before anything named their columns; the command below reads them too" in done.stdout
    )
    commands = re.findall(r"pipeline\.capture (--recover \S+ --columns [\w,]+)", done.stdout)
    assert commands == [f"--recover {folder} --columns {head.strip()}"], done.stdout
    done = ready.run("pipeline.capture", *commands[0].split())
    assert done.returncode == 0 and "799 samples" in done.stdout and "Next:" in done.stdout, done.stdout


@pytest.mark.parametrize(
    ("printed", "names"),
    [
        ("time_ms,turns,mm", "time_ms,motor_turns,displacement_mm"),
        ("millis,mm,turns,force", "millis,displacement_mm,motor_turns,load_n"),
        ("t,theta,x_mm", "time_s,motor_turns,displacement_mm (time_ms where it prints milliseconds)"),
        ("time_ms,theta_deg,x_cm,pressure_bar", "time_ms,motor_deg,displacement_cm,pressure_bar"),
        ("time_ms,angle,mm", "time_ms,angle,displacement_mm"),  # run.yaml gives it
        ("Real,time,rig", ""),  # a banner
        ("time_ms,turns,load,disp", "time_ms,motor_turns,load_n,displacement_mm"),
        ("t_ms,turns,q", "t_ms,motor_turns,displacement_mm"),  # one is left, and one lacks
        ("t_ms,q1,q2,load", ""),  # their order would be a guess
        ("time,motor_deg,displacement_cm,load_kg", ""),  # no column is load_kg
        ("turns,mm", ""),
    ],
)
def test_what_a_rigs_own_names_mean_goes_by_their_words_then_by_what_is_left(printed, names):
    assert likely(printed.split(","), USUAL, {"angle": "motor_turns"} if "angle" in printed else {}) == names


def test_a_run_whose_cable_went_is_said_to_be_usable_and_what_comes_next(folder):
    """Its phases were counted as strokes (4 of 2), and it was to be diagnosed, which needs 6."""
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    (folder / "recording.lines").write_text(wound())
    recover(folder)
    info = json.loads((folder / "capture.json").read_text())
    (folder / "capture.json").write_text(json.dumps(info | {"exit_status": "fault", "fault": "the port went away"}))
    (folder / "recording.csv").unlink()
    done = recover(folder)
    words = "what came before the fault can be used: 800 samples in 2 strokes\n"
    assert done.returncode == 0 and words in done.stdout and "Next:" in done.stdout, done.stdout
    (folder / "run.yaml").rename(folder / "away.yaml")
    (folder / "recording.csv").unlink()
    assert recover(folder).returncode == 1, "of a run that nobody has described nobody knows it"
    (folder / "away.yaml").rename(folder / "run.yaml")
    assert "2 strokes so far, and a diagnosis needs at least 6 to 8" in done.stdout
    assert "pipeline.diagnose" not in done.stdout and "snakemake" not in done.stdout, "no two strokes tell enough"
    (folder / "capture.json").write_text(json.dumps(info | {"exit_status": "fault", "fault": "the port went away"}))
    (folder / "recording.lines").chmod(0o644)
    (folder / "recording.lines").write_text(HEADER + "0,1,1\n20,1,1\n")
    (folder / "capture.json").unlink()
    (folder / "capture-pending.json").write_text(
        json.dumps({**info, "columns": [], "exit_status": "fault", "fault": "the port went away"})
    )
    done = recover(folder)
    assert done.returncode == 1 and "too few for a stroke" in done.stdout and "Next:" not in done.stdout, done.stdout
    assert recover(folder).returncode == 1, "it is finished, and cannot be used all the same"


@pytest.mark.parametrize(
    ("columns", "meant"),
    [
        ("time_s,motor_truns,displacement_mm", "time_s,motor_turns,displacement_mm"),
        ("time_ms,motor_turns,displacment_mm,load", "time_ms,motor_turns,displacement_mm,load_n"),
        ("t,theta,x_mm", ""),
        ("time,motor_deg,displacement_cm,load_kg", ""),  # they carry units of their own
        ("time_ms,motor_turns,displacement_mm,pressure_bar", ""),
    ],
)
def test_names_that_are_nearly_those_of_channels_are_asked_about(tmp_path, columns, meant):
    """`--columns time_s,motor_truns,…` recorded for an hour what nothing could use, without a word at its start."""
    question = doubt(columns.split(","), tmp_path / "a b")
    assert bool(question) == bool(meant)
    if meant:
        assert f"did you mean {meant}?" in question and question.endswith(
            f"--recover '{tmp_path}/a b' --columns {meant}"
        )


def test_a_name_that_the_run_gives_is_no_misspelt_one(folder):
    channels = {"motor_turns": {"column": "motor_turn", "unit": "deg"}}
    question = doubt(["time_s", "motor_turn", "x"], folder)
    assert "motor_turn and x are no channels; did you mean time_s,motor_turns,displacement_mm?" in question
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1") | {"channels": channels}))
    assert doubt(["time_s", "motor_turn", "x"], folder) == ""


WRONG = [
    *(("columns", value) for value in (5, None, "t,x", [5, 6], ["t"], [["t"], "x"], {"t": 1})),
    *(("started_utc", value) for value in (5, None, "yesterday", ["2026"], "0001-01-01T00:00:00+14:00")),
    *(("ended_utc", value) for value in (5, None, "", {}, "9999-12-31T23:59:59-14:00")),
    *(("exit_status", value) for value in (5, None, "x", [1])),
    *(("fault", value) for value in (5, ["x"], {})),
]


def test_a_capture_json_that_says_what_none_can_say_is_refused_with_the_mend(folder):
    good = recover_lines(folder, ())
    for field, value in WRONG:
        (folder / "capture.json").write_text(json.dumps(good | {field: value}))
        with pytest.raises(
            BadInput, match=rf"{field}: is not what the capture program writes\. Mend: restore .* or move"
        ):
            recover_lines(folder, ("t", "theta", "x"))
    for field in ("columns", "started_utc", "ended_utc", "exit_status"):
        (folder / "capture.json").write_text(json.dumps({key: good[key] for key in good if key != field}))
        with pytest.raises(BadInput, match=f"{field}: is not what the capture program writes"):
            recover_lines(folder, ("t", "theta", "x"))


def test_the_mend_of_a_wrong_capture_json_works(folder):
    good = recover_lines(folder, ())
    (folder / "capture.json").write_text(json.dumps(good | {"started_utc": 5}))
    done = recover(folder, "--columns", NAMES)
    assert done.returncode == 2 and "started_utc" in done.stderr and "Traceback" not in done.stderr
    (folder / "capture.json").rename(folder.parent / "away.json")
    assert recover(folder, "--columns", NAMES).returncode == 0
    assert json.loads((folder / "capture.json").read_text())["columns"] == NAMES.split(",")


def wound(stands=(), falls=(), reset=0) -> str:
    """Lines of two strokes in 20 ms steps: some stand, some fall back, and after `reset` the clock begins anew.

    As a rig prints them by millis(), which is read before its lines wait for the port.
    """
    text = HEADER
    for number in range(800):
        time_ms = 20 * (number - (number in stands)) - 25 * (number in falls) - 20 * reset * (number >= reset > 0)
        turns = 15.0 * (1.0 - math.cos(2.0 * math.pi * number / 400)) / 2.0
        text += f"{time_ms},{turns:.4f},{turns**2 / 34.0:.4f}\n"
    return text


def test_a_printed_time_that_stands_or_falls_back_is_mended_when_the_run_is_read(folder):
    """A text run ended with a command that died: `time_s: stands still at row 965 (14 times in all)`."""
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    stands, falls = range(50, 750, 50), (333,)
    (folder / "recording.lines").write_text(wound(stands, falls))
    done = recover(folder)
    sentence = "its clock gave 1 backward time stamp and 14 repeated time stamps, mended when the run is read"
    assert done.returncode == 0 and sentence in done.stdout and "Next:" in done.stdout, done.stdout
    assert "was it reset" not in done.stdout
    _, samples, strokes = read_strokes(folder)
    right = 0.02 * np.arange(800)
    assert len(samples) == 800 and len(strokes) == 4 and (np.diff(samples["time_s"]) > 0).all()
    assert np.abs(samples["time_s"].to_numpy() - right).max() < 0.021, "a step at most"
    apart = np.flatnonzero(np.abs(samples["time_s"].to_numpy() - right) > 1e-9)
    assert len(apart) < 32, "all other stamps stay"


def test_a_long_recording_is_mended_as_a_short_one(folder, monkeypatch, capsys):
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    (folder / "recording.lines").write_text(wound(range(50, 750, 50)))
    assert recover(folder).returncode == 0
    capsys.readouterr()
    _, kept, _ = read_strokes(folder)
    messages = capsys.readouterr().err
    monkeypatch.setattr("pipeline.run.table.mended_time.KEPT", 10)
    _, anew, _ = read_strokes(folder)
    assert kept.equals(anew) and capsys.readouterr().err == messages
    assert (
        "recording.csv: mended 14 repeated time stamps" in messages and messages.count("is read from its column") == 1
    )


def test_where_every_stamp_rises_none_is_touched(folder):
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    printed = wound().replace("\n15980,", "\n90000,")  # the last: a gap, not a wrong stamp
    (folder / "recording.lines").write_text(printed)
    assert "time stamp" not in recover(folder).stdout
    times = read_strokes(folder)[1]["time_s"].to_numpy()
    assert times[-1] == 90.0 and (times[:-1] == 0.001 * (20 * np.arange(799))).all()


def test_a_clock_that_was_reset_is_refused_with_a_mend_that_works_and_nothing_comes_next(folder):
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    (folder / "recording.lines").write_text(wound(reset=500))
    done = recover(folder)
    assert "time_s: falls back near row 501, which only moving 300 stamps would mend" in done.stdout, done.stdout
    assert "was it reset, or is the time another column than time_ms?" in done.stdout and "Next:" not in done.stdout
    mend = re.search(r"file: (\{rows: \[0, 500\]\}) in run\.yaml", done.stdout)[1]
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1") | {"file": yaml.safe_load(mend)}))
    assert len(read_strokes(folder)[1]) == 500


def test_what_is_no_clock_at_all_is_refused_with_the_command_that_names_the_columns(folder):
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    (folder / "recording.lines").write_text(wound(falls=range(0, 800, 4)))
    done = recover(folder)
    assert "time_s: stands or runs backwards at 199 of 799 steps from sample to sample" in done.stdout, done.stdout
    assert f"--recover {folder} --columns ..." in done.stdout and "Next:" not in done.stdout


def test_the_next_command_names_no_run_that_cannot_be_read(folder):
    string = content("run-1")["string"] | {"id": "spool-1"}
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", string=string)))
    (folder / "recording.lines").write_text(wound(reset=500))
    recover(folder)
    for name in ("run-2", "run-3", "run-4"):  # of two strokes each: a diagnosis needs six
        other = folder.parent / name
        other.mkdir()
        (other / "run.yaml").write_text(yaml.safe_dump(content(name, string=string)))
        (other / "recording.lines").write_text(wound())
        done = recover(other)
    runs = f"{folder.parent}/run-2 {folder.parent}/run-3 {other}"
    assert f"pipeline.diagnose {runs} --together" in done.stdout, done.stdout
    assert str(folder) not in done.stdout


def printed_lines(clock: str, every: float = 20.0) -> str:
    """200 lines of a rig that calls its clock so, of which three are lost."""
    rows = (f"{number * every:g},{number},{number / 10}\n" for number in range(200) if number not in (50, 51, 52))
    return "".join([f"{clock},turns,disp\n", *rows])


@pytest.mark.parametrize(
    ("clock", "channel", "every", "at"),
    [
        ("ms", {"column": "ms", "unit": "ms"}, 20.0, "980 ms"),
        ("Uhr", "Uhr", 0.02, "0.98 s"),
        ("tick", {"column": 0, "unit": "us"}, 20000.0, "980000 us"),
        ("ms", None, 20.0, "980 ms"),
        ("us", None, 20000.0, "980000 us"),
        ("s", None, 0.02, "0.98 s"),
    ],
)
def test_lost_lines_show_in_the_column_that_run_yaml_reads_as_the_time(folder, clock, channel, every, at):
    """A rig with the clock `ms` was said to print no time, beside `reads time_s = 2000 ms`, and lost lines were not."""
    if channel is not None:
        channels = {"time_s": channel, "motor_turns": "turns", "displacement_mm": "disp"}
        (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=channels)))
    (folder / "recording.lines").write_text(printed_lines(clock, every))
    done = recover(folder)
    assert f"about 3 samples missing, after the device's time {at}\n" in done.stdout, done.stdout
    assert "prints no time" not in done.stdout
    info = json.loads((folder / "capture.json").read_text())
    assert info["lines"]["device_time"] and info["lines"]["holes"] == 1 and info["holes"][0]["samples_about"] == 3


def test_a_clock_that_run_yaml_names_afterwards_makes_recover_look_for_lost_lines(folder):
    """The recording was said to be finished, and its lost lines stayed unseen."""
    (folder / "recording.lines").write_text(printed_lines("Uhr", 0.02))
    assert "the rig prints no time" in recover(folder).stdout
    channels = {"time_s": "Uhr", "motor_turns": "turns", "displacement_mm": "disp"}
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=channels)))
    assert "about 3 samples missing" in recover(folder).stdout
    assert "nothing is to be recovered" in recover(folder).stdout
