"""`snakemake real` plans a job for whatever lies in the folder, and says what to give when nothing does."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def dry_run(tmp_path, *words):
    command = [sys.executable, "-m", "snakemake", "--snakefile", str(ROOT / "Snakefile"), "--directory", str(tmp_path)]
    done = subprocess.run([*command, "--dry-run", "--cores", "1", "real", *words], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


@pytest.mark.long
def test_every_file_gets_its_jobs_and_every_group_its_own(tmp_path):
    folder = tmp_path / "my downloads"
    folder.mkdir()
    for name in ("Tool_1_A_00.TXT", "Tool_1_A_13.TXT.gz", "Tool_2_B_00.TXT", "DATA_EMPS.mat", "notes (1).md"):
        (folder / name).write_bytes(b"")
    status, printed = dry_run(tmp_path, "--config", f"recordings={folder}")
    assert "passed over 1 file whose names no pattern" in printed and "'notes (1).md'" in printed
    jobs = {name: int(count) for name, count in re.findall(r"^(\w+) +(\d+)$", printed, re.M)}
    assert status == 0 and jobs == {
        "bring": 4, "real_verdicts": 4, "black_box": 4, "real_verdicts_together": 1, "transfer": 1, "real_page": 2,
        "real": 1, "total": 17,
    }  # fmt: skip


@pytest.mark.long
def test_without_recordings_it_says_what_to_give(tmp_path):
    status, printed = dry_run(tmp_path)
    assert status != 0 and "--config recordings=DIR" in printed
    status, printed = dry_run(tmp_path, "--config", f"recordings={tmp_path / 'nowhere'}")
    assert status != 0 and "is no folder" in printed
