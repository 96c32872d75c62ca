"""A recording of many row groups gives what it gives when it is held whole, and needs no more memory when longer."""

import importlib
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml
from made_recording import content, motion, recording
from whole_strokes import label as label_whole
from whole_strokes import segment as segment_whole

from pipeline import wire
from pipeline.capture.commit import recover
from pipeline.ground.errors import BadInput
from pipeline.ground.numbers import quantiles
from pipeline.ground.stored import schemas
from pipeline.ground.stored.rows import Held, Stored
from pipeline.run.doubts import wild_samples
from pipeline.run.samples import read_samples, stored_strokes
from pipeline.run.strokes import label, segment
from pipeline.string.from_raw import read, read_long

ROOT = Path(__file__).parents[2]
GROUP = 101  # samples: strokes of made recordings are longer, stands are shorter


@pytest.fixture
def short_pieces(monkeypatch):
    """Everything is read and sorted in pieces that a test's recording has many of."""
    monkeypatch.setattr(schemas, "ROW_GROUP", GROUP)
    monkeypatch.setattr(quantiles, "HELD", 64)
    monkeypatch.setattr(quantiles, "DIGITS", (8,) * 8)


def spoiled(seed):
    """A motion with reversals, stands, noise, steps, holes and outliers of its own."""
    rng = np.random.default_rng(seed)
    corners = np.cumsum(rng.uniform(0.1, 5.0, 9) * rng.choice([1.0, 0.2], 9))
    time_s = np.arange(corners[0], corners[-1], 1.0 / rng.choice([10.0, 50.0, 120.0]))
    turns = np.interp(time_s, corners, rng.choice([0.0, 0.0, 5.0, 16.0, 20.0], 9))
    turns = turns + rng.choice([0.0, 0.003, 0.05, 0.5]) * rng.standard_normal(len(time_s))
    turns = np.round(4.0 * turns) / 4.0 if rng.random() < 0.3 else turns
    if rng.random() < 0.3:
        turns[rng.integers(0, len(turns), 3)] += 1000.0
    turns = 0.001 * turns if seed % 10 == 9 else turns
    kept = rng.random(len(time_s)) < rng.choice([1.0, 0.8])
    return pd.DataFrame({"time_s": time_s[kept], "motor_turns": turns[kept]})


def outcome(cut, table):
    try:
        return cut(table, "motor_turns", "here")
    except BadInput as error:
        return str(error)


@pytest.mark.parametrize("seed", range(60))
def test_strokes_in_pieces_are_those_of_marks_for_every_sample(seed, short_pieces):
    table = spoiled(seed)
    if len(table) < 20:
        return
    whole, pieces = outcome(segment_whole, table), outcome(segment, table)
    assert whole.equals(pieces) if isinstance(whole, pd.DataFrame) else whole == pieces
    marks = [cut(table["time_s"].to_numpy(), table["motor_turns"].to_numpy()) for cut in (label_whole, label)]
    assert all((whole_labels == other).all() for whole_labels, other in zip(*marks, strict=True))


def test_some_spoiled_motions_hold_strokes_and_some_hold_none():
    outcomes = [outcome(segment_whole, spoiled(seed)) for seed in range(60) if len(spoiled(seed)) >= 20]
    assert 10 < sum(isinstance(answer, pd.DataFrame) for answer in outcomes) < len(outcomes)


@pytest.mark.parametrize("suffix", [".parquet", ".csv", ".csv.gz"])
def test_samples_in_pieces_are_those_read_whole(make_run, tmp_path, monkeypatch, suffix):
    folder = make_run("a-01", recording(3), suffix)
    run, whole = read_samples(folder)
    monkeypatch.setattr(schemas, "ROW_GROUP", GROUP)
    _, stored, _ = stored_strokes(folder, tmp_path / "samples.parquet")
    assert len(stored.borders) == len(whole) // GROUP + 2
    assert stored.frame(0, len(stored)).equals(whole)
    strokes = segment(stored, "motor_turns", folder)
    assert strokes.equals(segment_whole(whole, "motor_turns", folder))
    straddling = strokes["first_sample"] // GROUP < strokes["last_sample"] // GROUP
    assert straddling.sum() > 5 and run.run == "a-01"


@pytest.mark.parametrize(
    "rows",
    [
        *(pytest.param(rows, marks=pytest.mark.long) for rows in ([GROUP - 1], [GROUP], [2 * GROUP, 2 * GROUP - 1])),
        [0, GROUP - 2, 3 * GROUP],
    ],
)
def test_damaged_samples_at_the_border_of_two_groups_are_left_out_and_said(
    make_run, tmp_path, short_pieces, capsys, rows
):
    samples = recording(4)
    samples.loc[rows, "displacement_mm"] = 1e6
    _, stored, _ = stored_strokes(make_run("a-01", samples), tmp_path / "samples.parquet")
    assert stored.frame(0, len(stored)).equals(recording(4).drop(index=rows).reset_index(drop=True))
    keeps = f"will not count; the recording keeps {'them' if len(rows) > 1 else 'it'}"
    count = f"{len(rows)} sample{'s' * (len(rows) > 1)}"
    assert f"{count} {keeps}: displacement_mm reads 1e+06 in row {min(rows) + 1}" in capsys.readouterr().err


def test_what_the_neighbours_read_is_the_same_at_the_border_of_two_groups():
    rows = Held(recording(3))
    whole = wild_samples._beside(rows, "displacement_mm", 0, len(rows))
    borders = [*range(0, len(rows), GROUP), len(rows)]
    parts = [wild_samples._beside(rows, "displacement_mm", *span) for span in pairwise(borders)]
    assert np.array_equal(np.concatenate(parts), whole)


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        ({"displacement_mm": np.nan}, f"not a number in 1 of 2300 lines, first in line {GROUP + 2}"),
        ({"time_s": 0.0}, f"runs backwards at line {GROUP + 2} "),
        ({"load_n": "high"}, f"line {GROUP + 2} holds 'high', not a number"),
    ],
)
def test_what_is_wrong_in_the_second_group_is_named_by_its_line(make_run, tmp_path, short_pieces, spoil, says):
    samples = recording(3).astype(object)
    for name, value in spoil.items():
        samples.loc[GROUP, name] = value
    with pytest.raises(BadInput, match=says):
        stored_strokes(make_run("a-01", samples, ".csv"), tmp_path / "samples.parquet")


def test_times_of_day_go_on_from_piece_to_piece_and_past_midnight(make_run, tmp_path, short_pieces):
    samples = recording(3)
    clock = pd.Timestamp("2026-11-23 23:59:40") + pd.to_timedelta(samples["time_s"], unit="s")
    for number, form in enumerate(("%H:%M:%S.%f", "%m/%d/%Y %H:%M:%S.%f")):
        folder = make_run(f"a-{number}", samples.assign(time_s=clock.dt.strftime(form)), ".csv")
        _, stored, _ = stored_strokes(folder, tmp_path / "samples.parquet")
        assert stored.read("time_s", 0, len(stored)) == pytest.approx(samples["time_s"].to_numpy(), abs=1e-6)


def test_a_run_on_disk_has_the_tare_the_noise_and_the_rests_of_one_in_memory(make_run, tmp_path, short_pieces):
    folder = make_run("a-01", recording(4))
    run_in_memory, stored = read(folder), read_long(folder, tmp_path / "samples.parquet")
    assert isinstance(stored.samples, Stored) and isinstance(run_in_memory.samples, pd.DataFrame)
    assert stored.span_s == run_in_memory.span_s and stored.level_mm(0, 40) == run_in_memory.level_mm(0, 40)


MAIN = (
    "import atexit, pathlib; atexit.register(lambda: print(pathlib.Path('/proc/self/status').read_text())); "
    "from pipeline.ground.numbers import quantiles; from pipeline.ground.stored import schemas; "
    "schemas.ROW_GROUP = quantiles.HELD = 1 << 15; quantiles.DIGITS = (16,) * 4; "
    "import {module} as stage; stage.main()"
)


def peak_mb(module, *words):
    """Memory that a stage took at most; what wait4 would tell counts the tests' own process with it."""
    program = [sys.executable, "-c", MAIN.format(module=module), *map(str, words)]
    done = subprocess.run(program, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return int(done.stdout.rpartition("VmHWM:")[2].split()[0]) / 1024.0


@pytest.fixture(scope="module")
def long_recordings():
    """The benchmark of long recordings, which makes them."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    try:
        return importlib.import_module("long_recordings")
    finally:
        sys.path.remove(str(ROOT / "benchmarks"))


def test_a_captured_run_in_pieces_is_the_one_that_is_read_whole(tmp_path, monkeypatch, long_recordings):
    """Its second and third pieces begin amid damaged frames."""
    folder, size = tmp_path / "a-01", 1 << 16
    long_recordings.record(folder, 0.6, "frames")
    path = folder / "recording.frames"
    data = bytearray(path.read_bytes())
    for at in (size, 2 * size - 1, 2 * size):
        data[at] ^= 0x55
    path.write_bytes(data)
    info = recover(folder)
    assert info["frames"]["lost"] in (2, 3) and info["samples"]["received"] == 36_000 - info["frames"]["lost"]
    table_bytes = []
    for piece in (1 << 30, size):
        monkeypatch.setattr(wire, "PIECE", piece)
        run, *_ = stored_strokes(folder, tmp_path / f"{piece}.parquet")
        table_bytes.append((tmp_path / f"{piece}.parquet").read_bytes())
    assert table_bytes[0] == table_bytes[1] and len(data) > 10 * size and run.run == "a-01"
    _, samples = read_samples(folder)
    assert len(samples) == info["samples"]["received"]
    _, turns, *_ = long_recordings.motion(0, 36_000, np.random.default_rng(1))
    truth = np.round(turns * 4096.0) / 4096.0
    assert np.array_equal(samples["motor_turns"], truth[np.round(samples["time_s"] * 1000.0).astype(int)])


@pytest.mark.long
@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="nothing tells what a process took")
def test_a_captured_run_four_times_as_long_needs_no_more_memory(tmp_path, long_recordings):
    peaks = []
    for minutes in (10, 40):
        folder = tmp_path / f"a-{minutes}"
        long_recordings.record(folder, minutes, "frames")
        recover(folder)
        peaks.append(peak_mb("pipeline.stages.ingest", folder, "--out", tmp_path / folder.name / "samples.parquet"))
    assert peaks[1] < 1.3 * peaks[0], peaks


@pytest.mark.long
@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="nothing tells what a process took")
def test_four_times_as_long_needs_no_more_memory(tmp_path):
    """Row groups are short, so that minutes are what hours are otherwise; read whole, the ratio was 1.6 and more."""
    peaks = []
    for minutes in (10, 40):
        folder = tmp_path / f"a-{minutes}"
        folder.mkdir()
        (folder / "run.yaml").write_text(yaml.safe_dump(content(folder.name)))
        strokes = round(minutes * 60 / motion(1)[-1, 0])
        recording(strokes, rate_hz=1000.0).to_parquet(folder / "recording.parquet", index=False, row_group_size=1 << 15)
        samples, table = tmp_path / "processed" / folder.name / "samples.parquet", tmp_path / "strokes.parquet"
        peaks.append(
            {
                "ingest": peak_mb("pipeline.stages.ingest", folder, "--out", samples, "--out-strokes", table),
                "lifespan": peak_mb("pipeline.lifespan.__main__", folder, "--out", tmp_path / "life"),
            }
        )
    for stage, peak in peaks[1].items():
        assert peak < 1.3 * peaks[0][stage], (stage, peaks)


@pytest.mark.long
@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="nothing tells what a process took")
def test_forty_minutes_at_1_khz_leave_room_for_two_hours(tmp_path, long_recordings):
    """In MB: 1,078 and 1,204 were measured, of two hours 1,176 and 1,609. The goal is 2,000 for two hours."""
    folder, processed = tmp_path / "a-40", tmp_path / "processed"
    long_recordings.record(folder, 40, "parquet")
    samples, strokes = (processed / folder.name / f"{stored}.parquet" for stored in ("samples", "strokes"))
    samples.parent.mkdir(parents=True)
    peak_mb("pipeline.stages.ingest", folder, "--out", samples, "--out-strokes", strokes)
    dataset = ("pipeline.stages.dataset", folder, "--processed", processed, "--out", tmp_path / "dataset.parquet")
    assert peak_mb(*dataset) < 1400.0
    assert peak_mb("pipeline.diagnose", folder, "--out", tmp_path / "out") < 1500.0
