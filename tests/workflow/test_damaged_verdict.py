"""A start finds a damaged diagnosis.json, names it, and plans the diagnosis of its run again, and nothing else."""

import json
import os
import shutil

import pytest
from made_recording import recording

from pipeline.ground.stored import schemas
from pipeline.ground.stored.checked_json import write_checked
from pipeline.run.strokes import segment

TARGET = "reports/diagnosis/a-3"
VERDICT = {
    "verdict": "consistent", "mismatch": None, "mechanisms": [], "alternatives": [],
    "fit": {"noise_floor_mm": 0.2, "heldout": None},
}  # fmt: skip


@pytest.mark.parametrize("content", [b"{", None], ids=["cut", "whole"])
def test_the_diagnosis_of_its_run_is_planned_again(bare_project, make_run, tmp_path, content):
    """Its files lie there as if an earlier start had made them."""
    project, names = type(bare_project)(tmp_path / "project"), ("samples", "strokes")
    shutil.copytree(bare_project.folder, project.folder, symlinks=True)
    shutil.move(make_run("a-3", recording(4)), project.folder / "raw" / "a-3")
    samples, strokes = (project.folder / "processed" / "a-3" / f"{name}.parquet" for name in names)
    schemas.write(recording(4), schemas.samples(list(recording(4).columns)), samples)
    schemas.write(segment(recording(4), "motor_turns", samples), schemas.STROKES, strokes)
    path = project.folder / TARGET / "diagnosis.json"
    write_checked(path, json.dumps(VERDICT))
    if content is not None:
        path.write_bytes(content)
    os.utime(path.parent)
    done = project.snakemake("--dry-run", TARGET)
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert project.rules_of(said) == ({} if content is None else {"diagnose": 1})
    assert (f"{TARGET}/diagnosis.json: is damaged" in said) == (content is not None)
    assert content is None or "it is made again" in said
