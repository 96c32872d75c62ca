"""The program that conceals writes a run that the pipeline reads, and seals the answer elsewhere."""

import json

import programs
import pytest

from pipeline.proof.plan import Planned, written
from pipeline.run.folder import read_run
from pipeline.run.table.recorded_table import read_recording


def conceal(place, *arguments):
    return programs.run("pipeline.proof.conceal", "--raw", place / "raw", *arguments)


@pytest.mark.parametrize("protocol", ["rich", "poor"])
def test_a_concealed_run_is_read_by_the_pipeline_and_says_nothing(protocol, tmp_path):
    case_options = [
        "--seed",
        "11",
        "--stratum",
        "single",
        "--effect",
        "thermal",
        "--kappa",
        "1",
        "--protocol",
        protocol,
    ]
    done = conceal(tmp_path, *case_options, "--run", "case-011", "--answer", str(tmp_path / "sealed" / "case-011.json"))
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
    ("arguments", "message"),
    [
        (["--stratum", "single", "--effect", "axial_elasticity", "--protocol", "poor"], "leaves no 1 noise floors"),
        (["--stratum", "none", "--effect", "creep"], "hides 0 effects"),
    ],
)
def test_a_case_that_cannot_be_is_refused(arguments, message, tmp_path):
    answer = str(tmp_path / "answer.json")
    done = conceal(tmp_path, "--seed", "1", *arguments, "--run", "case-1", "--answer", answer)
    assert done.returncode == 2 and message in done.stderr and not (tmp_path / "raw").exists()


def test_an_answer_is_never_laid_beside_the_recording(tmp_path):
    answer = str(tmp_path / "raw" / "case-1" / "answer.json")
    done = conceal(tmp_path, "--seed", "1", "--stratum", "none", "--run", "case-1", "--answer", answer)
    assert done.returncode == 2 and "seal it outside" in done.stderr


def test_a_batch_seals_its_answers_elsewhere_and_says_what_it_could_not_make(tmp_path):
    cases = [
        Planned("case-1", 1, "none", "poor"),
        Planned("case-2", 1, "single", "poor", ("axial_elasticity",), (1.0,)),
    ]
    command = ["pipeline.proof.conceal_batch", "--cases", written(cases), "--runs", tmp_path / "runs", "--answers"]
    beside = programs.run(*command, tmp_path / "runs" / "a.json")
    assert beside.returncode == 2 and "seal it outside" in beside.stderr and not (tmp_path / "runs").exists()
    sealed = tmp_path / "sealed.json"
    done = programs.run(*command, sealed)
    assert done.returncode == 0 and "1 recordings concealed" in done.stdout, done.stderr
    assert [path.name for path in (tmp_path / "runs").iterdir()] == ["case-1"]
    answer, skipped = json.loads(sealed.read_text())
    assert answer["asked"]["stratum"] == "none" and answer["effects"] == [] and 0.01 < answer["heldout_noise_mm"] < 0.1
    assert "leaves no 1 noise floors" in skipped["skipped"] and skipped["asked"]["effects"] == ["axial_elasticity"]
