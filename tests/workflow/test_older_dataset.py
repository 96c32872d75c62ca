"""A dataset that is older than `raw/`: what `predict` says of it is over once the main job made it anew."""

import subprocess
import sys
from pathlib import Path

import pytest
from added_runs import add_run

TARGET = "processed/flax/dataset.parquet"


def said(folder: Path) -> str:
    """What `predict` says of the dataset's age."""
    (folder / "questions.csv").write_text("string,stroke,direction,motor_turns\nflax-01,2,1,9\n")
    words = ["pipeline.predict", TARGET, "questions.csv", "--out", "answers.csv", "--model", "polynomial"]
    done = subprocess.run([sys.executable, "-m", *words], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return "\n".join(line for line in done.stderr.splitlines() if "was made before this" in line)


@pytest.mark.long
def test_what_predict_says_of_an_older_dataset_is_over_once_it_is_made_anew(bare_project):
    """Also where ingest ran alone before, and where a recording cannot be used: neither is in a dataset made anew."""
    folder = bare_project.folder
    first = add_run(bare_project, "flax-01", "flax")
    add_run(bare_project, "flax-02", "flax")
    assert bare_project.snakemake(TARGET).returncode == 0
    assert said(folder) == ""
    with open(first / "run.yaml", "a", encoding="utf-8") as file:
        file.write("tare: checked\n")
    broken = add_run(bare_project, "flax-03", "flax") / "recording.parquet"
    broken.write_bytes(b"PAR1 is no table")
    assert "run.yaml of flax-01 changed and flax-03 in raw/ is not in it. To make it anew: " in said(folder)
    assert bare_project.snakemake("processed/flax-01/samples.parquet").returncode == 0
    assert "run.yaml of flax-01 changed. To make it anew: " in said(folder)
    assert bare_project.snakemake(TARGET).returncode == 0
    assert said(folder) == ""
