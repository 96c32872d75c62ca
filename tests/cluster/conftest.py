"""What a cluster makes is held against a copy of the project in which all has run here."""

import csv
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import once
import pytest
from small_project import ROOT, SMALL, small_copy


@pytest.fixture(scope="session")
def copied(tmp_path_factory: pytest.TempPathFactory) -> Callable[[], Path]:
    return lambda: small_copy(tmp_path_factory.mktemp("copy") / "project")


@pytest.fixture(scope="session")
def local(copied: Callable[[], Path], tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[dict[str, str]]]:
    """A copy in which all has run on this machine, one for all processes, and of each of its jobs what it opened."""

    def make() -> tuple[Path, list[dict[str, str]]]:
        folder = copied()
        traced = [sys.executable, str(ROOT / "benchmarks" / "jobs.py"), "--out", "jobs.csv", "--trace", str(folder)]
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        arguments = ("--cores", "2", "all", "proof", "campaign", "real", "--retries", "2", *SMALL)
        words = [*traced, "--", "snakemake", *arguments]
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, env=environment)
        assert done.returncode == 0, done.stdout + done.stderr
        with open(folder / "jobs.csv", encoding="utf-8", newline="") as file:
            return folder, list(csv.DictReader(file))

    folder, jobs = once.made_once(once.place(tmp_path_factory), "local", make)
    return folder, jobs
