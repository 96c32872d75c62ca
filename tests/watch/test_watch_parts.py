"""Parts of the page: the noise of a reading, and the workflow's jobs as the real program logs them."""

import subprocess
import sys
from datetime import datetime
from pathlib import Path

import numpy as np
import pytest

from pipeline.watch.came_of_run import Means
from pipeline.watch.jobs import Jobs
from pipeline.watch.reading_noise import Noise

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


def test_the_noise_of_a_sensor_with_steps_is_a_steady_number(tmp_path):
    """Of a sensor with steps of 0.02 mm the band was 0.048 or 0.073 mm by turns, as medians of steps are; 0.062 is."""
    time_s = np.arange(31_000) / 100
    turning = 8 - 8 * np.cos(time_s / 8)
    readings = np.round((turning + np.random.default_rng(1).normal(0, 0.03, len(time_s))) / 0.02) * 0.02
    true = np.hypot(0.03, 0.02 / np.sqrt(12))
    sigmas = []
    for pieces in (1, 620, 5000):  # however the file was read
        noise = Noise()
        for piece in np.array_split(readings, pieces):
            noise.add(piece)
            sigmas.append(noise.sigma)
        assert sigmas[-1] == sigmas[0] == pytest.approx(true, rel=0.03)
    early = [sigma for sigma in sigmas if sigma is not None]
    assert min(early) > 0.9 * true and max(early) < 1.1 * true, "it does not jump while samples come"
    assert None in sigmas, "a few samples tell nothing yet"


def test_what_came_is_drawn_as_means_of_a_bounded_number():
    """The page drew what was foretold in tenths of a mm, and what came only over 10 mm."""
    means = Means()
    time_s = np.arange(0.0, 2000.0, 0.01)
    rows = np.column_stack([time_s, 0.01 * time_s, np.where(time_s < 1000.0, 5.0, 6.0)])
    for piece in np.array_split(rows[:800], 17):
        means.add(piece)
    assert len(means.rows) == 32 and means.rows[1] == pytest.approx([0.37, 0.0037, 5.0])
    for piece in np.array_split(rows[800:], 50):
        means.add(piece)
    kept = means.rows
    assert len(kept) == 2000 and set(kept[:, 2]) == {5.0, 6.0} and np.diff(kept[:, 0]) == pytest.approx(1.0)
    means.add(np.zeros((3, 2)))
    assert means.rows.shape == (1, 2), "another recording, of other columns"


def snakemake(place: Path, *words: str) -> int:
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--keep-going", *words]
    return subprocess.run(command, cwd=place, capture_output=True, timeout=300).returncode


@pytest.mark.long
def test_jobs_are_told_as_the_workflow_did_them(tmp_path):
    jobs = Jobs(tmp_path)
    jobs.poll()
    assert jobs.told() is None
    (tmp_path / "Snakefile").write_text(SNAKEFILE)
    assert snakemake(tmp_path) == 1
    jobs.poll()
    progress = jobs.told()
    assert (progress["done"], progress["total"], progress["ended"]) == (2, 4, True)
    assert (progress["failed"], progress["failures"], progress["running"]) == (["bad"], 1, [])
    (tmp_path / "Snakefile").write_text(SNAKEFILE.replace("exit 3", "touch c"))
    assert snakemake(tmp_path) == 0
    jobs.poll()
    progress = jobs.told()  # of the newer log, which plans what was left
    assert (progress["done"], progress["total"], progress["failed"]) == (2, 2, [])


def test_a_log_is_read_on_while_it_grows_and_hostile_lines_are_text(tmp_path):
    place = tmp_path / ".snakemake" / "log"
    place.mkdir(parents=True)
    path = place / "2026-01-01T000000.000000.snakemake.log"
    path.write_text("total   3\n\n[now]\nJob 2: make <img src=x>\n")
    jobs = Jobs(tmp_path)
    jobs.poll()
    assert jobs.told()["running"] == ["make <img src=x>"] and not jobs.told()["ended"]
    assert jobs.told()["ended_utc"] is None
    with open(path, "ab") as file:
        file.write(b"\xff\xfe\nJob 1: other\nFinished jobid: 2 (Rule: a)\n1 of 3 steps (33%) do")
    jobs.poll()
    assert jobs.told()["running"] == ["other"] and jobs.told()["done"] == 0
    with open(path, "ab") as file:
        file.write(b"ne\nError in rule b:\n    message: None\n    jobid: 1\nComplete log(s): x\n")
    jobs.poll()
    progress = jobs.told()
    assert (progress["done"], progress["failed"], progress["running"], progress["ended"]) == (1, ["other"], [], True)
    at_s = datetime.fromisoformat(progress["ended_utc"]).timestamp()
    assert abs(at_s - path.stat().st_mtime) < 1e-3, "beside a recording of today stood the jobs of last week"
