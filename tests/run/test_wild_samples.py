"""One damaged sample is left out and said; an ordinary outlier, and every sample of a good recording, stays."""

from pathlib import Path

import downloaded
import numpy as np
import pandas as pd
import programs
import pytest
from made_recording import recording

from pipeline.foreign.imported import import_run
from pipeline.ground.stored import schemas
from pipeline.ground.stored.rows import Held
from pipeline.run.doubts.wild_samples import wild_samples
from pipeline.run.samples import read_samples

ROOT = Path(__file__).parents[2]
BLIND = sorted((ROOT / "tests" / "data" / "blind").rglob("recording.parquet"))
KINDS = {"tsa": ("tsa_haptic", "*.csv.gz"), "davinci": ("davinci_tool", "*.gz"), "emps": ("emps", "*.mat")}
MAPPINGS = [
    path
    for path in sorted((ROOT / "pipeline" / "mappings").glob("*.yaml"))
    if path.stem.split("_")[0] in KINDS and path.stem != "emps_pulses"
]
GOOD = recording()


def ingested(folder, out):
    return programs.run("pipeline.stages.ingest", folder, "--out", out)


@pytest.mark.parametrize(
    ("column", "value"),
    [
        ("displacement_mm", 1e3),
        ("displacement_mm", -1e6),
        ("motor_turns", 1e3),
        ("motor_turns", 1e308),
        ("load_n", 1e5),
    ],
)
@pytest.mark.parametrize("row", [0, 300, len(GOOD) - 1])
def test_one_impossible_sample_is_left_out_and_said(make_run, tmp_path, column, value, row):
    samples = GOOD.copy()
    samples.loc[row, column] = value
    done = ingested(make_run("a-01", samples), tmp_path / "samples.parquet")
    assert done.returncode == 0, done.stderr
    warning = f"1 sample will not count; the recording keeps it: {column} reads {value:.3g} in row {row + 1}"
    assert f"{warning}, where its neighbours" in done.stderr
    assert schemas.read(tmp_path / "samples.parquet").equals(GOOD.drop(index=row).reset_index(drop=True))


def test_ordinary_outliers_stay(make_run, tmp_path):
    samples = GOOD.copy()
    samples.loc[[50, 200, 201], "displacement_mm"] += [30.0, -2.0, -2.0]
    samples.loc[[60, 210], "load_n"] += [25.0, -19.0]
    samples.loc[400, "motor_turns"] += 20.0
    done = ingested(make_run("a-01", samples), tmp_path / "samples.parquet")
    assert done.returncode == 0 and "will not count" not in done.stderr
    assert len(schemas.read(tmp_path / "samples.parquet")) == len(GOOD)


def test_more_than_a_percent_is_refused_with_the_mend(make_run, tmp_path):
    samples = GOOD.copy()
    samples.loc[::60, "displacement_mm"] = 1e4
    done = ingested(make_run("a-01", samples), tmp_path / "samples.parquet")
    assert done.returncode == 2 and "displacement_mm" in done.stderr
    assert "samples are impossible, over 1 %" in done.stderr and "Mend: check the sensor" in done.stderr


def test_an_import_keeps_what_ingest_leaves_out(tmp_path, make_run, capsys):
    """It said "1 sample left out", kept it, and gave its value as the channel's range."""
    folder = make_run("a-01")
    samples = GOOD.copy()
    samples.loc[300, "displacement_mm"] = 1e6
    samples.to_csv(tmp_path / "log.csv", index=False)
    mapping = tmp_path / "map.yaml"
    mapping.write_text((folder / "run.yaml").read_text().replace("run: a-01\n", ""))
    summary = import_run(tmp_path / "log.csv", mapping, "b-01", tmp_path)
    assert "1 sample will not count; the recording keeps it: displacement_mm reads 1e+06" in capsys.readouterr().err
    assert f"log.csv has {len(GOOD)} samples, of which 1 will not count (see the warning)." in summary
    most = GOOD["displacement_mm"].drop(index=300).max()
    assert f"displacement_mm {GOOD['displacement_mm'].min():.4g} to {most:.4g}" in summary and "1e+06" not in summary
    assert len(pd.read_parquet(tmp_path / "b-01" / "recording.parquet")) == len(GOOD)
    assert len(read_samples(tmp_path / "b-01")[1]) == len(GOOD) - 1


@pytest.mark.parametrize("path", BLIND, ids=lambda path: path.parent.name)
def test_no_blind_recording_loses_a_sample(path):
    _, samples = read_samples(path.parent)
    assert len(samples) == len(pd.read_parquet(path))


def test_noise_about_no_load_is_no_range(make_run):
    samples = GOOD.copy()
    samples["load_n"] = 0.001 * np.random.default_rng(1).standard_normal(len(samples))
    samples.loc[100, "load_n"] = 0.1
    assert len(read_samples(make_run("a-01", samples))[1]) == len(GOOD)


@pytest.mark.parametrize("mapping", MAPPINGS, ids=lambda path: path.stem)
def test_no_downloaded_recording_loses_a_sample(tmp_path, mapping):
    for number, file in enumerate(downloaded.files(*KINDS[mapping.stem.split("_")[0]])):
        import_run(file, mapping, f"a-{number}", tmp_path)
        run, samples = read_samples(tmp_path / f"a-{number}")
        gone, warnings = wild_samples(run, Held(samples), file)
        assert not len(gone) and not warnings
        assert len(samples) == len(pd.read_parquet(tmp_path / f"a-{number}" / "recording.parquet"))
