"""A diagnosis is told a mark where another rig than the default one recorded, and no bare option elsewhere."""

import json
import shlex
import subprocess
import sys

import pytest

SMALL = ("--configfile", "pipeline/config/ci.yaml")
ASKED = ("reports/diagnosis/synthetic-01", "reports/index.html")


@pytest.fixture(scope="module", params=[(), SMALL], ids=["default", "ci"])
def planned(bare_project, request):
    """Whether a small rig was asked for, and the lines of programs that a dry run shows."""
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--nolock", "--dry-run", "--printshellcmds"]
    words = [*command, *request.param, "--", *ASKED]
    done = subprocess.run(words, cwd=bare_project.folder, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return bool(request.param), (done.stdout + done.stderr).splitlines()


def line_of(program, planned):
    """The line of a program."""
    return next(line for line in planned[1] if program in line)


@pytest.mark.long
def test_a_diagnosis_is_marked_by_the_rig_of_its_configuration(planned):
    shell, small = line_of("pipeline.diagnose raw", planned), planned[0]
    assert ("--mark 'recorded by ci.yaml" in shell and "set-up small (5" in shell) if small else "--mark" not in shell


@pytest.mark.long
def test_the_pages_of_a_material_and_of_a_run_are_told_apart_what_made_them(planned):
    words = shlex.split(line_of("pipeline.report.index", planned))
    rig = json.loads(words[words.index("--rig-mark") + 1])
    assert rig["fits"] == "" and bool(rig["rig"]) == planned[0]
    words = shlex.split(line_of("pipeline.report.material_page", planned))
    material = json.loads(words[words.index("--made-by") + 1])
    assert "INN model" in material["fits"] and material["rig"] == rig["rig"]
