"""A main job of two models that is killed: what goes on from it, and what it leaves behind."""

import os
import shutil
import signal
import subprocess
import time

import pytest
import yaml

pytestmark = pytest.mark.long  # the main job is run again


def test_killed_at_any_point_the_launcher_goes_on_to_the_same_tables(few, few_finished):
    project = few
    shutil.rmtree(project.folder / "processed" / "synthetic")
    shutil.rmtree(project.folder / "reports")
    kills = 0
    for wait_for in ("dataset-synthetic", "train-synthetic-inn", "evaluate-synthetic"):
        log = project.folder / "processed" / "logs" / wait_for
        for old in log.parent.glob(f"{wait_for}*"):
            old.unlink()
        run = subprocess.Popen(
            project.command(), cwd=project.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        deadline_s = time.monotonic() + 300
        while run.poll() is None and not list(log.parent.glob(f"{wait_for}*")) and time.monotonic() < deadline_s:
            time.sleep(0.02)
        kills += run.poll() is None
        os.kill(run.pid, signal.SIGKILL)
        run.wait()
    assert kills == 3
    done = project.snakemake()
    assert done.returncode == 0, done.stdout + done.stderr
    for name in ("table_1.csv", "table_2.csv", "comparison.md"):
        assert project.read(f"reports/synthetic/{name}") == few_finished.read(f"reports/synthetic/{name}")


def test_a_killed_snakemake_leaves_no_job_behind(few):
    project = few
    shutil.rmtree(project.folder / "processed" / "synthetic" / "inn")
    slow = project.folder / "pipeline/config/ci.yaml"
    config = yaml.safe_load(slow.read_text())
    config["models"]["inn"]["settings"]["epochs"] = 3000
    slow.write_text(yaml.safe_dump(config))
    run = subprocess.Popen(project.command(), cwd=project.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        deadline_s = time.monotonic() + 120
        while not jobs_in(project.folder) and time.monotonic() < deadline_s:
            time.sleep(0.1)
        assert jobs_in(project.folder)
    finally:
        run.kill()
        run.wait()
    deadline_s = time.monotonic() + 30  # a job that was still importing ends when it has done so
    while jobs_in(project.folder) and time.monotonic() < deadline_s:
        time.sleep(0.1)
    assert not jobs_in(project.folder)


def test_ctrl_c_is_said_in_a_sentence_and_the_same_command_goes_on(few):
    """It ended in tracebacks of the jobs, as if they had failed."""
    settings = few.folder / "pipeline/config/ci.yaml"
    usual = settings.read_text()
    slow = yaml.safe_load(usual)
    slow["models"]["inn"]["settings"]["epochs"] = 3000
    settings.write_text(yaml.safe_dump(slow))
    shutil.rmtree(few.folder / "processed" / "synthetic" / "inn", ignore_errors=True)
    pipe = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    run = subprocess.Popen(few.command(), cwd=few.folder, start_new_session=True, **pipe)
    deadline_s = time.monotonic() + 120
    while not jobs_in(few.folder) and run.poll() is None and time.monotonic() < deadline_s:
        time.sleep(0.05)
    assert run.poll() is None, run.communicate()[0][-3000:]
    os.killpg(run.pid, signal.SIGINT)  # a terminal sends it to every process of the command
    words, _ = run.communicate(timeout=120)
    settings.write_text(usual)
    assert run.returncode != 0 and "Stopped by Ctrl-C. What is made is kept:" in words, words[-3000:]
    assert "Not all was made" not in words and not jobs_in(few.folder)
    done = few.snakemake()
    assert done.returncode == 0 and "Stopped by" not in done.stdout + done.stderr, done.stdout + done.stderr


def jobs_in(folder):
    """Training programs at work in a folder."""
    done = subprocess.run(["pgrep", "-f", "pipeline.stages.train"], capture_output=True, text=True)
    places = []
    for pid in done.stdout.split():
        try:
            places.append(os.readlink(f"/proc/{pid}/cwd"))
        except OSError:
            continue
    return [place for place in places if place == str(folder)]
