"""What the workflow says of its jobs in a terminal of a person's own snakemake, which has no profile of ours."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def planned(place: Path, *words: str) -> str:
    """What a dry run of one job says."""
    environment = {name: value for name, value in os.environ.items() if name != "SNAKEMAKE_PROFILE"}
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "-n", *words, "--", "raw/synthetic-01/run.yaml"]
    done = subprocess.run(command, cwd=place, env=environment, capture_output=True, text=True)
    assert done.returncode == 0 and "Job 0: record synthetic-01" in done.stdout + done.stderr, done
    return done.stdout + done.stderr


def test_why_a_job_runs_is_printed_to_whom_asks_for_it_alone(tmp_path: Path) -> None:
    """Each job listed all of its files, in a terminal that had not entered the environment."""
    shutil.copy(ROOT / "Snakefile", tmp_path)
    for folder in ("pipeline", "profiles"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    (tmp_path / "raw").mkdir()
    assert "\nReason: " not in planned(tmp_path)
    assert "\nReason: Missing output files" in planned(tmp_path, "--quiet", "host")
    (tmp_path / "profiles").unlink()
    assert "\nReason: " in planned(tmp_path), "it is the profile that says so"
