"""Asking by the command line: what each case took, which its own process counts."""

import json
import shutil
import subprocess
import sys

import numpy as np
import pandas as pd
import pytest

from pipeline.proof.conceal_batch import concealed
from pipeline.proof.plan import plan
from pipeline.proof.verdicts import REFUSED, ask


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """A run folder, with its recording changed."""
    mix = {"stratum": "none", "protocol": "poor", "count": 1}
    (case,) = plan({"seed": 5, "batch": 1, "mixes": [mix]})
    place = tmp_path_factory.mktemp("asked")
    concealed(case, place)
    samples = pd.read_parquet(place / case.run / "recording.parquet")

    def make(name, changed):
        folder = place / name
        shutil.copytree(place / case.run, folder)
        (folder / "run.yaml").write_text((folder / "run.yaml").read_text().replace(case.run, name))
        changed(samples).to_parquet(folder / "recording.parquet", index=False)
        return folder

    return make


def faint(samples):
    """Noise in which nothing can be told: refused after the dimensions were calibrated."""
    noise_mm = np.random.default_rng(0).normal(scale=0.6 * samples["displacement_mm"].std(), size=len(samples))
    return samples.assign(displacement_mm=samples["displacement_mm"] + noise_mm)


def short(samples):
    """One stroke, or less: refused when it is read."""
    return samples[samples["time_s"] < samples["time_s"].iloc[0] + 10.0]


def still(samples):
    """A rest, in which nothing moves: refused when it is read, whatever is read with it."""
    first = samples.iloc[0]
    return samples.assign(motor_turns=first["motor_turns"], displacement_mm=first["displacement_mm"])


@pytest.mark.long
def test_each_case_takes_the_cpu_seconds_of_its_own_process(recorded, tmp_path):
    report = ask([recorded("short-1", short), recorded("faint-1", faint)], tmp_path / "out")
    assert report["status"] == REFUSED and list(report["seconds"]) == ["short-1", "faint-1"]
    assert 0.0 < report["seconds"]["short-1"] < 0.5 < report["seconds"]["faint-1"]


@pytest.mark.long
def test_a_proposed_run_that_is_refused_counts_for_its_case_alone(recorded, tmp_path):
    runs, more, out = (tmp_path / name for name in ("runs", "more", "out"))
    shutil.copytree(recorded("tied-1", lambda samples: samples), runs / "tied-1")
    shutil.copytree(recorded("tied-1-more", still), more / "tied-1" / "proposed" / "tied-1-more")
    command = [sys.executable, "-m", "pipeline.proof.settle", "--runs", runs, "--more", more, "--out", out]
    subprocess.run(command, check=True)
    questions = json.loads((out / "settled.json").read_text())
    assert questions == {"tied-1/proposed": {"seconds": {}, "status": REFUSED}}
    assert list((out / "tied-1" / "proposed").iterdir()) == []
