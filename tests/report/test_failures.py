"""The last lines of a main job that did not make all: each failure with its reason and its mend."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from pipeline.report.end_of_job.failures import ALL_ELSE, ELSE, FAILS, told, without

ROOT = Path(__file__).parents[2]


def test_every_failure_is_named_once_with_its_reason_and_mend(tmp_path):
    log, last, silent = (tmp_path / name for name in ("ingest-a-01.log", "left_out.log", "train.log"))
    log.write_text("reading\nerror: old. Mend: no.\nerror: raw/a-01: time_s: runs backwards. Mend: record it again.\n")
    last.write_text("left out: raw/b: x. Mend: y.\nerror: raw/c: x. Mend: y.\n")
    silent.write_text("Traceback\nZeroDivisionError: division\n\n")
    failed = [("ingest a-01", str(log)), ("left_out", str(last)), ("train inn", str(silent)), ("gone", "no.log")]
    lines = told(failed, ["raw/c: x. Mend: y."], keep_going=True).splitlines()
    assert lines[0] == "Not all was made:" and len(lines) == 6
    assert {"left out: raw/c: x. Mend: y.", "left out: raw/b: x. Mend: y."} < set(lines)
    assert f"failed: ingest a-01: raw/a-01: time_s: runs backwards. Mend: record it again. Its log: {log}" in lines
    assert f"failed: train inn: ZeroDivisionError: division Its log: {silent}" in lines
    alone = told([("left_out", str(last))], ["raw/c: x. Mend: y."], keep_going=False).splitlines()
    assert alone == [ALL_ELSE, "left out: raw/c: x. Mend: y.", "left out: raw/b: x. Mend: y.", FAILS]
    assert without(["a", "a"]).splitlines() == [ALL_ELSE, "left out: a"] and without([]) == ""
    assert told([], [], keep_going=False).splitlines() == ["Not all was made: see the errors above.", ELSE]


@pytest.mark.long
def test_the_main_job_ends_with_what_failed(tmp_path):
    """On the real rules, with a recording that ingest refuses beside a folder that can be no run.

    The launcher sets a profile that keeps going. This test sets it aside, to see both ways of ending.
    """
    shutil.copytree(ROOT / "pipeline", tmp_path / "pipeline", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "Snakefile", tmp_path)
    run = tmp_path / "raw" / "bad-01"
    make = ["--material", "nylon", "--radius-mm", "0.4", "--length-mm", "400", "--torsion-zone-mm", "150"]
    command = [sys.executable, "-m", "pipeline.new_run", "bad-01", *make, "--separator-mm", "8"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    (run / "recording.csv").write_text("time_s,motor_turns,displacement_mm\n0,0,0\n")
    silk = ["silk-01", *make, "--separator-mm", "8"]  # without a recording, and of a material that nobody asks for
    silk[silk.index("nylon")] = "silk"
    subprocess.run([*command[:3], *silk], cwd=tmp_path, check=True, capture_output=True)
    (tmp_path / "raw" / "A copy").mkdir()
    (tmp_path / "raw" / "A copy" / "run.yaml").write_text("")
    snakemake = [sys.executable, "-m", "snakemake", "--cores", "1", "--configfile", "pipeline/config/ci.yaml"]

    environment = {name: value for name, value in os.environ.items() if name != "SNAKEMAKE_PROFILE"}

    def last(*words, status, title):
        done = subprocess.run([*snakemake, *words], cwd=tmp_path, env=environment, capture_output=True, text=True)
        assert done.returncode == status, done.stdout + done.stderr
        return done.stdout.rstrip().partition(f"{title}\n")[2].splitlines()

    samples = ("--", "processed/bad-01/samples.parquet")
    refused, folder, *rest = last(*samples, status=1, title="Not all was made:")
    assert folder.startswith("left out: raw/A copy: its name: ") and "Mend: rename the folder" in folder
    assert refused.startswith("left out: raw/bad-01/recording.csv: ") and "Mend: " in refused and rest == [ELSE]
    assert last("--keep-going", *samples, status=0, title=ALL_ELSE) == [refused, folder]
    command = [*snakemake, "--", "reports/nylon/table_1.csv"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert (
        done.returncode == 1 and "no run in raw/ is of material nylon, but for those that are left out" in done.stderr
    )
