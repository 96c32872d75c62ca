"""A node evaluates the Snakefile for one job: by the plan that it is handed, without a look at other runs or a note."""

import os
import subprocess
import sys

import pytest
from made_recording import content, recording

from pipeline.workflow import handed_plan
from pipeline.workflow.dag import Plan


@pytest.mark.long
def test_a_node_goes_by_the_plan_that_it_is_handed(bare_project, make_run):
    run = make_run("nylon-1", recording(2), string={**content("nylon-1")["string"], "material": "nylon"})
    (bare_project.folder / "raw").symlink_to(run.parent)
    other = run.parent / "nylon-2"  # is in raw/ and would be refused, but the plan does not have it
    other.mkdir()
    (other / "run.yaml").write_text("no: run\n")
    files = {"nylon-1": ["raw/nylon-1/run.yaml", "raw/nylon-1/recording.parquet"]}
    environment = {**os.environ, handed_plan.PLAN: handed_plan.packed(Plan({"nylon": ["nylon-1"]}), files)}
    words = [
        "--mode",
        "remote",
        "--dry-run",
        "--cores",
        "1",
        "--force",
        "--nolock",
        "--target-files-omit-workdir-adjustment",
    ]
    words += ["--allowed-rules", "ingest", "--target-jobs", "ingest:run=nylon-1"]
    command = [sys.executable, "-m", "snakemake", *words, "--configfile", "pipeline/config/ci.yaml"]
    done = subprocess.run(command, cwd=bare_project.folder, env=environment, capture_output=True, text=True)
    printed = done.stdout + done.stderr
    assert done.returncode == 0 and "ingest nylon-1" in printed, printed
    assert "node: " in printed and "left out" not in printed and "nylon-2" not in printed
    assert not (bare_project.folder / ".snakemake" / "known_files.json").exists()
