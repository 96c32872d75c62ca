"""A diagnosis is told a mark where another rig than the default one recorded, and no bare option elsewhere."""

import json
import shlex
import subprocess
import sys

import pytest


@pytest.mark.parametrize(("more", "mark"), [([], ""), (["--configfile", "pipeline/config/ci.yaml"], "set-up small (5")])
def test_a_diagnosis_is_marked_by_the_rig_of_its_configuration(bare_project, more, mark):
    shell = planned(bare_project.folder, "pipeline.diagnose raw", *more, "--", "reports/diagnosis/synthetic-01")
    assert mark in shell and ("--mark 'recorded by ci.yaml" in shell if mark else "--mark" not in shell)


@pytest.mark.parametrize("more", [(), ("--configfile", "pipeline/config/ci.yaml")], ids=["default", "ci"])
def test_the_index_is_told_apart_what_made_a_material_and_what_recorded_a_run(bare_project, more):
    words = shlex.split(planned(bare_project.folder, "pipeline.report.index", *more, "--", "reports/index.html"))
    marks = json.loads(words[words.index("--part-marks") + 1])
    rigs = {part: mark["rig"] for part, mark in marks.items()}
    assert rigs["material"] == "" and rigs["synthetic"] == rigs["rig"] and bool(rigs["rig"]) == bool(more)
    assert marks["rig"]["fits"] == "" and "INN model" in marks["material"]["fits"]


def planned(folder, program, *words):
    """The line that a dry run shows of a program."""
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--nolock", "--dry-run", "--printshellcmds", *words]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return next(line for line in (done.stdout + done.stderr).splitlines() if program in line)
