"""The program that conceals writes a run that the pipeline reads, and seals the answer elsewhere."""

import json
import subprocess
import sys

import pytest

from pipeline.recording import read_recording
from pipeline.runs import read_run


def conceal(place, *arguments):
    command = [sys.executable, "-m", "pipeline.proof.conceal", "--raw", str(place / "raw"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


@pytest.mark.parametrize("protocol", ["rich", "poor"])
def test_a_concealed_run_is_read_by_the_pipeline_and_says_nothing(protocol, tmp_path):
    told = ["--seed", "11", "--stratum", "single", "--effect", "thermal", "--kappa", "1", "--protocol", protocol]
    done = conceal(tmp_path, *told, "--run", "case-011", "--answer", str(tmp_path / "sealed" / "case-011.json"))
    assert done.returncode == 0, done.stderr
    folder = tmp_path / "raw" / "case-011"
    assert {path.name for path in folder.iterdir()} == {"run.yaml", "recording.parquet"}
    samples = read_recording(read_run(folder), folder)
    assert {"time_s", "motor_turns", "displacement_mm", "load_n"} <= set(samples.columns) and len(samples) > 6_000
    assert b"thermal" not in (folder / "run.yaml").read_bytes() + (folder / "recording.parquet").read_bytes()
    sealed = json.loads((tmp_path / "sealed" / "case-011.json").read_text())
    assert sealed["effects"][0]["id"] == "thermal" and sealed["protocol"] == protocol
    room = "room_k" in sealed["effects"][0]["parameters"]
    assert not room or "temperature_c" in samples
    assert set(sealed["location"]) >= {"motor_turns", "strokes", "phase", "share"}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--stratum", "single", "--effect", "axial_elasticity", "--protocol", "poor"], "leaves no 1 noise floors"),
        (["--stratum", "none", "--effect", "creep"], "hides 0 effects"),
    ],
)
def test_a_case_that_cannot_be_is_refused(arguments, said, tmp_path):
    answer = str(tmp_path / "answer.json")
    done = conceal(tmp_path, "--seed", "1", *arguments, "--run", "case-1", "--answer", answer)
    assert done.returncode == 2 and said in done.stderr and not (tmp_path / "raw").exists()


def test_an_answer_is_never_laid_beside_the_recording(tmp_path):
    answer = str(tmp_path / "raw" / "case-1" / "answer.json")
    done = conceal(tmp_path, "--seed", "1", "--stratum", "none", "--run", "case-1", "--answer", answer)
    assert done.returncode == 2 and "seal it outside" in done.stderr
