"""A diagnosis is told a mark where another rig than the default one recorded, and no bare option elsewhere."""

import subprocess
import sys

import pytest


@pytest.mark.parametrize(("more", "mark"), [([], ""), (["--configfile", "pipeline/config/ci.yaml"], "set-up small (5")])
def test_a_diagnosis_is_marked_by_the_rig_of_its_configuration(bare_project, more, mark):
    words = ["snakemake", "--cores", "1", "--nolock", "--dry-run", "--printshellcmds", *more, "--"]
    command = [sys.executable, "-m", *words, "reports/diagnosis/synthetic-01"]
    done = subprocess.run(command, cwd=bare_project.folder, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    shell = next(line for line in (done.stdout + done.stderr).splitlines() if "pipeline.diagnose raw" in line)
    assert mark in shell and ("--mark 'recorded by ci.yaml" in shell if mark else "--mark" not in shell)
