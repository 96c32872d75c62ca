"""Logs as a lab has them, through both doors, import_run and new_run: what is damaged costs itself, by its line."""

import gzip
import re
import shlex

import numpy as np
import programs
import pytest
import yaml
from foreign.test_import_guess import filled
from made_recording import recording

from pipeline.run.samples import read_samples

GOOD = recording()
SIZES = ["--radius-mm", "0.4", "--length-mm", "400", "--torsion-zone-mm", "150", "--separator-mm", "8"]
MOST_WORDS = 420  # characters of a message: four lines or so of a terminal


def german(value, digits=3):
    return f"{value:.{digits}f}".replace(".", ",")


def rows(write, sign):
    """The recording in ms, degrees, mm and N."""
    numbers = GOOD[["time_s", "motor_turns", "displacement_mm", "load_n"]].to_numpy()
    return [sign.join([f"{1e3 * t:.0f}", write(360 * m), write(x), write(f)]) for t, m, x, f in numbers]


def banner_and_header_again():
    lines, head = rows(german, ";"), ["Zeit;Winkel;Weg;Kraft", "ms;°;mm;N"]
    return ["Prüfstand 3", "Bediener: K. W.   24.11.2026", "", *head, *lines[:1000], *head, *lines[1000:]]


def holes_a_spike_and_a_cut_end():
    lines = rows("{:.3f}".format, ",")
    for row in (300, 301, 702):
        lines[row] = re.sub(r",[^,]*(,[^,]*)$", r",NaN\1", lines[row])
    lines[500] = re.sub(r",[^,]*(,[^,]*)$", r",1e9\1", lines[500])
    lines[900] = lines[900].rpartition(",")[0] + ",---"
    lines[-1] = lines[-1][:8]
    return ["# logger v1.2", "# 25 Hz", "time_ms,angle_deg,laser_mm,force_N", *lines]


def a_reset_on_the_wire():
    lines = rows("{:.3f}".format, " ")
    lines[700] = lines[700][:7]
    lines[1000] = "ESP32 boot: rst:0x1 (POWERON) at 0"
    return ["t_ms motor_deg slide_mm load_N", *lines]


LOGS = {  # what makes it, what is said of it, and how many samples it loses
    "banner.csv": (banner_and_header_again, ["2 damaged lines left out: line 1006, 'Zeit;", "line 1007, 'ms;"], 0),
    "holes.csv": (
        holes_a_spike_and_a_cut_end,
        ["4 damaged lines left out: line 304, ", "; line 904, ", "mm reads 1e+09 in line 504, where", "is cut off"],
        6,
    ),
    "reset.csv": (a_reset_on_the_wire, ["too many left out: line 1002, 'ESP32", "line left out: line 702, "], 2),
}


def written(folder, name):
    text = "\n".join(LOGS[name][0]()) + ("" if name == "holes.csv" else "\n")
    (folder / name).write_bytes(text.encode("cp1252"))


def options(message):
    """The words behind the program in the command that a message ends with."""
    return shlex.split(message.splitlines()[-1])[3:]


def as_recorded(folder, lost):
    """That a run holds the recording, but for so many samples that were damaged."""
    read = read_samples(folder)[1]
    assert len(read) == len(GOOD) - lost
    at = np.searchsorted(GOOD["time_s"] + 1e-6, read["time_s"])
    for name in ("motor_turns", "displacement_mm", "load_n"):
        assert read[name].to_numpy() == pytest.approx(GOOD[name].to_numpy()[at], abs=1e-3), name


@pytest.mark.parametrize("name", LOGS)
def test_a_messy_log_is_imported_the_first_time_through_its_draft(tmp_path, name):
    written(tmp_path, name)
    done = programs.run("pipeline.import_run", "--guess", name, cwd=tmp_path)
    (tmp_path / "map.yaml").write_text(filled(done.stdout, unit="N"), encoding="utf-8")
    done = programs.run("pipeline.import_run", name, "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert all(words in done.stderr for words in LOGS[name][1]), done.stderr
    assert max(map(len, done.stderr.splitlines())) < MOST_WORDS
    as_recorded(tmp_path / "raw" / "a-01", LOGS[name][2])


@pytest.mark.parametrize("name", LOGS)
def test_new_run_says_at_once_how_a_messy_log_is_read_and_leaves_out_what_is_damaged(tmp_path, name):
    """It refused a line after the other, gave a key of the layout each time, and showed a range up to 1e9 mm."""
    written(tmp_path, name)
    words = ["pipeline.new_run", "a-01", "--material", "nylon", *SIZES, "--recording", name]
    done = programs.run(*words, cwd=tmp_path)
    assert done.returncode == 2 and max(map(len, done.stderr.splitlines())) < MOST_WORDS, done.stderr
    done = programs.run("pipeline.new_run", *options(done.stderr), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert all(words in done.stderr for words in LOGS[name][1]), done.stderr
    assert "displacement_mm -5.1" in done.stdout and "1e+09" not in done.stdout, "no range that is none"
    as_recorded(tmp_path / "raw" / "a-01", LOGS[name][2])
    text = (tmp_path / "raw" / "a-01" / "run.yaml").read_text()
    assert re.match(rf"# the recording is '{name}' without \d damaged lines: \d+, ", text), "it is said where it counts"


def clean_log(tmp_path, name="log.csv", wrong=()):
    """Our own columns; the lines `wrong`, from 1, have a cell that is no number."""
    lines = GOOD.to_csv(index=False).splitlines()
    for number in wrong:
        lines[number - 1] = lines[number - 1].replace(",", ",off ", 1)
    text = "\n".join(lines) + "\n"
    (tmp_path / name).write_bytes(gzip.compress(text.encode()) if name.endswith(".gz") else text.encode())
    return lines


@pytest.mark.parametrize("name", ["log.csv", "log.csv.gz"])
def test_a_copy_in_a_run_folder_has_all_lines_but_the_damaged_ones(tmp_path, name):
    lines = clean_log(tmp_path, name, wrong=(50, 60))
    words = ["pipeline.new_run", "a-01", "--material", "nylon", *SIZES, "--recording", name]
    done = programs.run(*words, "--file", "{rows: [10, 1500]}", cwd=tmp_path)
    assert done.returncode == 0 and "2 damaged lines left out: line 50, " in done.stderr, done.stderr
    copied = (tmp_path / "raw" / "a-01" / f"recording{name[3:]}").read_bytes()
    copied = gzip.decompress(copied) if name.endswith(".gz") else copied
    assert copied.decode().splitlines() == [*lines[:49], *lines[50:59], *lines[60:]]
    run, samples = read_samples(tmp_path / "raw" / "a-01")
    assert run.file.rows == (10, 1498) and len(samples) == 1488
    assert samples["time_s"].iloc[-1] == GOOD["time_s"].iloc[1499]


def test_many_damaged_lines_are_refused_by_new_run_with_what_to_do(tmp_path):
    clean_log(tmp_path, wrong=range(50, 80))
    words = ["pipeline.new_run", "a-01", "--material", "nylon", *SIZES, "--recording", "log.csv"]
    done = programs.run(*words, cwd=tmp_path)
    assert done.returncode == 2 and "motor_turns: line 50 holds 'off " in done.stderr and "29 more lines" in done.stderr
    assert "Mend: remove these lines, or name the column" in done.stderr and not (tmp_path / "raw").exists()


def test_a_run_like_one_of_another_logger_is_offered_the_columns_and_units_of_its_own_file(tmp_path):
    """The template in the message had the units and signs of the other run's columns."""
    foreign = GOOD.assign(t_ms=1e3 * GOOD["time_s"], theta_rad=2 * np.pi * GOOD["motor_turns"])
    foreign = foreign.assign(laser_mm=90 - GOOD["displacement_mm"])[["t_ms", "theta_rad", "laser_mm"]]
    foreign.to_csv(tmp_path / "a.csv", index=False)
    clean_log(tmp_path)
    first = ["pipeline.new_run", "a-01", "--material", "nylon", *SIZES, "--load-n", "20", "--recording", "a.csv"]
    done = programs.run(*first, cwd=tmp_path)
    assert programs.run("pipeline.new_run", *options(done.stderr), cwd=tmp_path).returncode == 0, done.stderr
    like = ["pipeline.new_run", "a-02", "--like", "raw/a-01", "--recording", "log.csv"]
    done = programs.run(*like, cwd=tmp_path)
    assert done.returncode == 2 and len(done.stderr) < MOST_WORDS, done.stderr
    assert "there are no columns 't_ms', 'theta_rad' and 'laser_mm', only time_s, motor_turns, " in done.stderr
    assert "unit" not in done.stderr and "scale" not in done.stderr, "of the other run's columns"
    done = programs.run("pipeline.new_run", *options(done.stderr), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    as_recorded(tmp_path / "raw" / "a-02", 0)


def two_axes(tmp_path, *words):
    names = {"a": ("motor_1", "slide_1"), "b": ("motor_2", "slide_2")}
    twice = {m: GOOD["motor_turns"] for m, _ in names.values()}
    twice |= {x: GOOD["displacement_mm"] for _, x in names.values()}
    GOOD[["time_s"]].assign(**twice).to_csv(tmp_path / "two.csv", index=False)
    axes = {axis: {"channels": {"motor_turns": m, "displacement_mm": x}} for axis, (m, x) in names.items()}
    string, rig = {"material": "nylon", "radius_mm": 0.4, "length_mm": 400}, {"torsion_zone_mm": 150, "separator_mm": 8}
    mapping = {"string": string, "rig": {**rig, "load_n": 20}, "axes": axes}
    (tmp_path / "map.yaml").write_text(yaml.safe_dump(mapping))
    return programs.run("pipeline.import_run", "two.csv", "--map", "map.yaml", "--run", "r", *words, cwd=tmp_path)


def test_two_axes_of_one_file_are_of_two_strings(tmp_path):
    """Each was said to be perhaps of the other's string, and `--string-id` made both of one."""
    done = two_axes(tmp_path)
    assert done.returncode == 0 and "counts as another string" not in done.stderr, done.stderr
    done = programs.run("pipeline.import_run", "--guess", "two.csv", cwd=tmp_path)
    assert "# two axes in one file: write their channels under axes (docs/import.md)" in done.stdout
    other = tmp_path / "other"
    other.mkdir()
    assert two_axes(other, "--string-id", "s3").returncode == 0
    assert [read_samples(other / "raw" / run)[0].string.id for run in ("r-a", "r-b")] == ["s3-a", "s3-b"]


def test_a_sensor_that_is_read_every_other_time_is_drafted_and_what_to_do_is_said(tmp_path):
    """The draft asked for "one of " no column at all."""
    table = GOOD[["time_s", "displacement_mm", "motor_turns"]].copy()
    table.loc[1::2, "displacement_mm"] = np.nan
    table.to_csv(tmp_path / "slow.csv", index=False)
    done = programs.run("pipeline.import_run", "--guess", "slow.csv", cwd=tmp_path)
    assert "displacement_mm: {column: displacement_mm, unit: mm}" in done.stdout
    assert "displacement_mm has no number in 1150 of 2300 lines, first in line 3, " in done.stderr
    assert "The import refuses it so: remove these lines first; missing ones are no harm" in done.stderr
    kept = table.dropna()
    kept.to_csv(tmp_path / "slow.csv", index=False)
    (tmp_path / "map.yaml").write_text(filled(done.stdout, load=20))
    done = programs.run("pipeline.import_run", "slow.csv", "--map", "map.yaml", "--run", "a-01", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
