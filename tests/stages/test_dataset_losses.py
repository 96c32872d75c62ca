"""Strokes in which samples were lost are left out of the dataset unless told otherwise."""

import json
import subprocess
import sys
from pathlib import Path

import pandas as pd
import programs
import pytest
from made_recording import content, recording

from pipeline.ground.stored import schemas
from pipeline.ground.words.jump_notes import read_jumps
from pipeline.ground.words.left_out import read_left_out
from pipeline.run.strokes import segment
from pipeline.stages.dataset import touched

ROOT = Path(__file__).parents[2]
STROKES = pd.DataFrame(
    {
        "stroke": [0, 1, 1, 1, 2, 2],
        "phase": ["rest", "winding", "rest", "unwinding", "winding", "unwinding"],
        "first_sample": [0, 10, 20, 30, 40, 50],
        "last_sample": [9, 19, 29, 39, 49, 59],
    }
)


@pytest.mark.parametrize(
    ("after", "strokes"),
    [
        ([], set()),
        ([5], set()),
        ([10], {1}),
        ([25], set()),
        ([35], {1}),
        ([40], {1, 2}),
        ([60], {2}),
        ([15, 55], {1, 2}),
    ],
)
def test_a_gap_touches_the_stroke_in_whose_movement_it_lies(after, strokes):
    for kind in ("gaps", "holes"):
        assert touched(STROKES, {kind: [{"after_samples": count} for count in after]}) == strokes


def test_gaps_that_are_no_longer_listed_may_be_anywhere_later():
    assert touched(STROKES, {"gaps": [{"after_samples": 25}] * 1000}) == {1, 2}
    assert touched(STROKES, {}) == set()


def made(folder, processed, out, *options):
    folders = [str(run_folder) for run_folder in (folder if isinstance(folder, list) else [folder])]
    done = programs.run("pipeline.stages.dataset", *folders, "--processed", processed, "--out", out, *options)
    return done, schemas.read(out, schemas.DATASET) if done.returncode == 0 else None


def test_the_program_leaves_lossy_strokes_out_and_says_so(make_run, tmp_path):
    folder, processed = make_run("run-1"), tmp_path / "processed"
    samples, cut = (processed / "run-1" / f"{table}.parquet" for table in ("samples", "strokes"))
    done = programs.run("pipeline.stages.ingest", folder, "--out", samples, "--out-strokes", cut)
    assert done.returncode == 0, done.stderr
    strokes = schemas.read(cut, schemas.STROKES)
    again = segment(schemas.read(samples), "motor_turns", folder)
    pd.testing.assert_frame_equal(strokes, again, check_dtype=False, check_exact=True)
    assert f"{strokes['stroke'].max()} strokes in {len(strokes)} stretches" in done.stdout
    second = strokes[(strokes["stroke"] == 2) & (strokes["phase"] == "winding")].iloc[0]
    (folder / "capture.json").write_text(json.dumps({"gaps": [{"after_samples": int(second["first_sample"]) + 3}]}))
    done, clean_points = made(folder, processed, tmp_path / "left.parquet")
    assert "samples are missing in stroke 2: left out" in done.stdout and 2 not in set(clean_points["stroke"])
    jumps = tmp_path / "jumps.json"
    done, kept = made(folder, processed, tmp_path / "kept.parquet", "--keep-lossy", "--out-jumps", jumps)
    assert "kept all the same" in done.stdout and set(kept["stroke"]) - {2} == set(clean_points["stroke"]) != set(
        kept["stroke"]
    )
    assert read_jumps([jumps]) == [] and jumps.read_text().endswith("\n")
    for split in ("within", "later"):
        learnt, held_out_count = ((kept[split] == part).sum() for part in ("train", "test"))
        assert f"{split}: {learnt} points to train on, {held_out_count} held out\n" in done.stdout


def test_a_run_in_which_every_stroke_is_lossy_is_left_out_and_its_strokes_still_count(make_run, tmp_path):
    string, processed = {**content("x")["string"], "id": "spool-1"}, tmp_path / "processed"
    folders = [make_run(name, string=string) for name in ("run-1", "run-2")]
    for folder in folders:
        samples = processed / folder.name / "samples.parquet"
        schemas.write(recording(), schemas.samples(list(recording().columns)), samples)
        strokes = segment(recording(), "motor_turns", samples)
        schemas.write(strokes, schemas.STROKES, samples.with_name("strokes.parquet"))
    gaps = [
        {"after_samples": int(first_sample) + 3}
        for first_sample in strokes.loc[strokes["phase"] == "winding", "first_sample"]
    ]
    (folders[0] / "capture.json").write_text(json.dumps({"gaps": gaps}))
    more = ["--out-left-out", str(tmp_path / "left.json")]
    done, _ = made(folders, processed, tmp_path / "d.parquet", *more)
    assert done.returncode == 2 and "samples are missing in every one" in done.stderr
    done, points = made(folders, processed, tmp_path / "d.parquet", *more, "--note-refusals")
    assert done.returncode == 0, done.stderr
    assert set(points["run"]) == {"run-2"} and set(points["stroke"]) == {4, 5, 6}
    assert [refusal.run for refusal in read_left_out(tmp_path / "left.json")] == ["run-1"]


@pytest.mark.parametrize(
    ("value", "kept", "status"),
    [("False", False, 0), pytest.param("True", True, 0, marks=pytest.mark.long), ("perhaps", False, 1)],
    ids=str,
)
def test_the_configuration_says_whether_they_are_kept(tmp_path, value, kept, status):
    what = [
        "--dry-run",
        "--printshellcmds",
        "--config",
        f"keep_lossy={value}",
        "--",
        "processed/synthetic/dataset.parquet",
    ]
    command = [sys.executable, "-m", "snakemake", "--snakefile", str(ROOT / "Snakefile"), "--directory", str(tmp_path)]
    done = subprocess.run([*command, *what], capture_output=True, text=True)
    printed = done.stdout + done.stderr
    assert done.returncode == status, printed
    assert ("--keep-lossy" in printed) == kept
    assert ("pipeline.stages.dataset raw/synthetic-01" in printed) == (status == 0)
