"""Parts of the page: the noise of a reading, and the workflow's jobs as the real program logs them."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pipeline.watch.jobs import Jobs
from pipeline.watch.noise import Noise

SNAKEFILE = """
rule all:
    input: "a", "b", "c"
rule good:
    output: "a"
    message: "make a, which is good"
    shell: "touch {output}"
rule slow:
    output: "b"
    shell: "touch {output}"
rule bad:
    output: "c"
    shell: "exit 3"
"""


@pytest.mark.parametrize("sigma", [0.002, 0.05])
def test_the_noise_of_a_reading_is_found_while_it_moves(sigma):
    noise, time_s = Noise(), np.arange(20_000) / 1000
    assert noise.sigma is None
    readings = 10 * np.sin(time_s) + np.random.default_rng(1).normal(0, sigma, len(time_s))
    readings[5000] += 40.0  # one outlier
    for piece in np.split(readings, 40):
        noise.add(piece)
    noise.add(readings[:3])  # too few to tell
    assert noise.sigma == pytest.approx(sigma, rel=0.1)


def snakemake(place: Path, *words: str) -> int:
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--keep-going", *words]
    return subprocess.run(command, cwd=place, capture_output=True, timeout=300).returncode


def test_jobs_are_told_as_the_workflow_did_them(tmp_path):
    jobs = Jobs(tmp_path)
    jobs.poll()
    assert jobs.told() is None
    (tmp_path / "Snakefile").write_text(SNAKEFILE)
    assert snakemake(tmp_path) == 1
    jobs.poll()
    found = jobs.told()
    assert (found["done"], found["total"], found["ended"]) == (2, 4, True)
    assert (found["failed"], found["failures"], found["running"]) == (["bad"], 1, [])
    (tmp_path / "Snakefile").write_text(SNAKEFILE.replace("exit 3", "touch c"))
    assert snakemake(tmp_path) == 0
    jobs.poll()
    found = jobs.told()  # of the newer log, which plans what was left
    assert (found["done"], found["total"], found["failed"]) == (2, 2, [])


def test_a_log_is_read_on_while_it_grows_and_hostile_lines_are_text(tmp_path):
    place = tmp_path / ".snakemake" / "log"
    place.mkdir(parents=True)
    path = place / "2026-01-01T000000.000000.snakemake.log"
    path.write_text("total   3\n\n[now]\nJob 2: make <img src=x>\n")
    jobs = Jobs(tmp_path)
    jobs.poll()
    assert jobs.told()["running"] == ["make <img src=x>"] and not jobs.told()["ended"]
    with open(path, "ab") as file:
        file.write(b"\xff\xfe\nJob 1: other\nFinished jobid: 2 (Rule: a)\n1 of 3 steps (33%) do")
    jobs.poll()
    assert jobs.told()["running"] == ["other"] and jobs.told()["done"] == 0
    with open(path, "ab") as file:
        file.write(b"ne\nError in rule b:\n    message: None\n    jobid: 1\nComplete log(s): x\n")
    jobs.poll()
    found = jobs.told()
    assert (found["done"], found["failed"], found["running"], found["ended"]) == (1, ["other"], [], True)
