"""A second main job in a folder where one is at work: one sentence, and nothing of it runs."""

import os
import signal
import subprocess
import time

import pytest


def held(locks):
    """Whether a Snakemake has written down which files it holds."""
    return any(path.stat().st_size for path in locks.glob("*.lock"))


@pytest.mark.long  # it makes an environment of its own
def test_a_second_main_job_says_that_one_runs_already(bare_project):
    target = "raw/synthetic-01/run.yaml"
    locks = bare_project.folder / ".snakemake" / "locks"
    first = subprocess.Popen(
        bare_project.command(target), cwd=bare_project.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        until_s = time.monotonic() + 300
        while not held(locks) and first.poll() is None and time.monotonic() < until_s:
            time.sleep(0.01)
        os.kill(first.pid, signal.SIGSTOP)  # it holds its locks for as long as the second one needs
        assert list(locks.glob("*.lock")) and first.poll() is None
        second = bare_project.snakemake(target)
    finally:
        first.kill()
        first.wait()
    printed = second.stdout + second.stderr
    assert second.returncode == 1 and f"a main job runs in this folder already (process {first.pid})" in printed
    assert "A main job runs in this folder already, and makes the same files: wait until it has ended" in printed
    assert "LockException" not in printed and "--unlock" not in printed
    again = bare_project.snakemake(target)
    assert again.returncode == 0, again.stdout + again.stderr
