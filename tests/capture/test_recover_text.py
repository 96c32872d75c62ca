"""Recovery of what a rig printed, whatever its numbers are and whatever somebody wrote into capture.json."""

import json
import subprocess

import pytest
import ready
import yaml
from made_recording import content

from pipeline.capture.holes import MOST
from pipeline.capture.lines_to_csv import recover_lines
from pipeline.capture.near_names import doubt
from pipeline.ground.errors import BadInput

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
    done = recover(folder, "--columns", "t_ms,turns,mm")
    words = "there are no columns 'motor_turns' and 'displacement_mm', only t_ms, turns, mm"
    assert done.returncode == 0 and words in done.stdout and "Until then nothing can use this run." in done.stdout
    assert f"--recover {folder} --columns ..." in done.stdout and "Next:" not in done.stdout
    done = recover(folder, "--columns", "time_ms,motor_turn,displacement_mm")
    assert "there is no column 'motor_turns', only time_ms, motor_turn, displacement_mm" in done.stdout
    right = "time_ms,motor_turns,displacement_mm"
    assert f"did you mean {right}? Then: python -m pipeline.capture --recover {folder} --columns {right}; or name" in (
        done.stdout
    )
    done = recover(folder, "--columns", "time_ms,motor_turns,displacement_mm")
    assert done.returncode == 0 and "nothing can use" not in done.stdout and "Next:" in done.stdout


@pytest.mark.parametrize(
    ("given", "meant"),
    [
        ("time_s,motor_truns,displacement_mm", "time_s,motor_turns,displacement_mm"),
        ("time_ms,motor_turns,displacment_mm,load", "time_ms,motor_turns,displacement_mm,load_n"),
        ("t,theta,x_mm", ""),
        ("time,motor_deg,displacement_cm,load_kg", ""),  # they carry units of their own
        ("time_ms,motor_turns,displacement_mm,pressure_bar", ""),
    ],
)
def test_names_that_are_nearly_those_of_channels_are_asked_about(tmp_path, given, meant):
    """`--columns time_s,motor_truns,…` recorded for an hour what nothing could use, without a word at its start."""
    said = doubt(given.split(","), tmp_path / "a b")
    assert bool(said) == bool(meant)
    if meant:
        assert f"did you mean {meant}?" in said and said.endswith(f"--recover '{tmp_path}/a b' --columns {meant}")


def test_a_name_that_the_run_gives_is_no_misspelt_one(folder):
    channels = {"motor_turns": {"column": "motor_turn", "unit": "deg"}}
    assert "is no channel; did you mean time_s,motor_turns,x?" in doubt(["time_s", "motor_turn", "x"], folder)
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
