"""A start finds a damaged diagnosis.json, names it, and plans the diagnosis of its run again, and nothing else."""

import json
import os
import re
import shutil

import pytest
from made_recording import recording

from pipeline.ground.stored import schemas
from pipeline.ground.stored.checked_json import write_checked
from pipeline.run.strokes import segment

VERDICT = {
    "verdict": "consistent", "mismatch": None, "mechanisms": [], "alternatives": [],
    "fit": {"noise_floor_mm": 0.2, "heldout": None},
}  # fmt: skip


def as_if_made(project, make_run, name):
    """The files of a diagnosis lie there as if an earlier start had made them; where they are, from the project."""
    shutil.move(make_run(name, recording(4)), project.folder / "raw" / name)
    samples, strokes = (project.folder / "processed" / name / f"{kind}.parquet" for kind in ("samples", "strokes"))
    schemas.write(recording(4), schemas.samples(list(recording(4).columns)), samples)
    schemas.write(segment(recording(4), "motor_turns", samples), schemas.STROKES, strokes)
    write_checked(project.folder / "reports" / "diagnosis" / name / "diagnosis.json", json.dumps(VERDICT))
    return f"reports/diagnosis/{name}"


@pytest.mark.long
def test_the_diagnosis_of_its_run_is_planned_again_and_that_of_no_other(bare_project, make_run, tmp_path):
    project = type(bare_project)(tmp_path / "project")
    shutil.copytree(bare_project.folder, project.folder, symlinks=True)
    cut, whole = (as_if_made(project, make_run, name) for name in ("a-3", "a-4"))
    (project.folder / cut / "diagnosis.json").write_bytes(b"{")
    for place in (cut, whole):
        os.utime(project.folder / place)
    done = project.snakemake("--dry-run", cut, whole)
    printed = done.stdout + done.stderr
    assert done.returncode == 0, printed
    assert project.rules_of(printed) == {"diagnose": 1} and re.findall(r"Job \d+: diagnose (.*)", printed) == ["a-3"], (
        printed
    )
    assert f"{cut}/diagnosis.json: is damaged" in printed and "it is made again" in printed
    assert f"{whole}/diagnosis.json" not in printed
