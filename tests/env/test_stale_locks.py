"""Snakemake's locks: removed when their Snakemake is known to be dead, and only then."""

import importlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

ENV = Path(__file__).parents[2] / "env"
NOBODY = 65534


@pytest.fixture
def stale_locks(monkeypatch):
    monkeypatch.syspath_prepend(str(ENV))
    return importlib.import_module("launcher.stale_locks")


@pytest.fixture
def lock(tmp_path, monkeypatch):
    """A lock in the working folder."""
    monkeypatch.chdir(tmp_path)
    lock = tmp_path / ".snakemake" / "locks" / "0.input.lock"
    lock.parent.mkdir(parents=True)
    lock.touch()
    return lock


@pytest.fixture
def alive(tmp_path):
    """A program called snakemake, at work in a folder; ended at the end."""
    started = []

    def start(folder, *words, **how):
        program = tmp_path / "bin" / "snakemake"
        program.parent.mkdir(exist_ok=True)
        program.write_text("import time; print('at work', flush=True); time.sleep(600)")
        tmp_path.chmod(0o755)
        command = [*words, str(program)]
        started.append(subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, **how))
        started[-1].stdout.readline()
        return started[-1]

    yield start
    for process in started:
        end(process)
        process.stdout.close()


def end(process):
    process.kill()
    process.wait()


@pytest.mark.parametrize("options", [[], ["-u"], ["-X", "utf8", "-W", "ignore"]])
def test_stale_locks_go_and_live_ones_stay(stale_locks, lock, alive, tmp_path, capsys, options):
    process = alive(tmp_path, sys.executable, *options)
    stale_locks.clear_stale_locks()
    message = f"env: a main job runs in this folder already (process {process.pid}): wait until it has ended\n"
    assert lock.exists() and capsys.readouterr().err == message
    end(process)
    stale_locks.clear_stale_locks()
    message = "env: the main job before was killed: its locks are removed, and what it had not finished is made now\n"
    assert not lock.exists() and capsys.readouterr().err == message
    stale_locks.clear_stale_locks()
    assert capsys.readouterr().err == ""


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="only /proc tells where a process works")
def test_a_snakemake_in_another_folder_is_no_reason_to_keep_locks(stale_locks, lock, alive, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    alive(elsewhere, sys.executable)
    stale_locks.clear_stale_locks()
    assert not lock.exists()


@pytest.mark.parametrize("owner", ["same", "another"])
def test_the_locks_of_another_users_snakemake_stay(stale_locks, lock, tmp_path, monkeypatch, capsys, owner):
    """What another user's process does cannot be seen: its folder is unreadable, or it is hidden as a whole."""
    me = os.geteuid()
    user = me if owner == "same" else me + 1
    theirs = stale_locks.running().processes[0].__class__(7, user, [b"/bin/snakemake"], b"", None)
    monkeypatch.setattr(stale_locks, "running", lambda: stale_locks.Running([theirs], True))
    stale_locks.clear_stale_locks()
    assert lock.exists() == (owner == "same")  # a lock is its maker's: another user's Snakemake did not make this one
    if owner == "same":
        assert "snakemake --unlock" in capsys.readouterr().err


def test_where_processes_are_hidden_only_ones_own_locks_go(stale_locks, lock, monkeypatch, capsys):
    monkeypatch.setattr(stale_locks, "running", lambda: stale_locks.Running([], False))
    assert stale_locks.is_stale(os.geteuid(), stale_locks.running())
    assert not stale_locks.is_stale(os.geteuid() + 1, stale_locks.running())
    stale_locks.clear_stale_locks()
    assert not lock.exists()


@pytest.mark.skipif(os.geteuid() != 0 or sys.platform != "linux", reason="only root can be two users")
def test_a_real_snakemake_of_another_user_keeps_its_locks(lock, alive, tmp_path):
    """As that user's colleague: the launcher's part runs without root's right to look into others' processes."""
    system_python = "/usr/bin/python3"
    if not Path(system_python).exists():
        pytest.skip("no Python that every user may run")
    for parent in (lock.parent, lock.parent.parent):
        parent.chmod(0o777)
    os.chown(lock, NOBODY, NOBODY)
    for folder in lock.parents:
        if folder == Path("/tmp"):
            break
        folder.chmod(folder.stat().st_mode | 0o055)
    process = alive(tmp_path, system_python, user=NOBODY, group=NOBODY, extra_groups=[])
    code = f"import sys; sys.path.insert(0, {str(ENV)!r}); from launcher.stale_locks import clear_stale_locks as c; c()"
    drop = "import ctypes, os, sys; [ctypes.CDLL(None).prctl(24, right, 0, 0, 0) for right in (1, 2, 19, 5)]; "
    drop += "os.execv(sys.executable, [sys.executable, '-c', sys.argv[1]])"

    def ask():
        return subprocess.run([sys.executable, "-c", drop, code], cwd=tmp_path, capture_output=True, text=True).stderr

    assert "snakemake --unlock" in ask() and lock.exists()
    end(process)
    assert "its locks are removed" in ask() and not lock.exists()


def test_without_proc_ps_is_asked(stale_locks, lock, alive, tmp_path, monkeypatch):
    processes = importlib.import_module("launcher.processes")
    monkeypatch.setattr(processes, "PROC", tmp_path / "no-proc")
    process = alive(tmp_path, sys.executable)
    stale_locks.clear_stale_locks()
    assert lock.exists()
    end(process)
    mark = os.fsencode(tmp_path)  # this machine may run others, whose folders `ps` does not tell
    monkeypatch.setattr(stale_locks, "is_snakemake", lambda words: mark in b" ".join(words))
    stale_locks.clear_stale_locks()
    assert not lock.exists()


def test_without_proc_and_ps_they_stay(stale_locks, lock, tmp_path, monkeypatch, capsys):
    processes = importlib.import_module("launcher.processes")
    monkeypatch.setattr(processes, "PROC", tmp_path / "no-proc")
    monkeypatch.setenv("PATH", "")
    stale_locks.clear_stale_locks()
    assert lock.exists() and "snakemake --unlock" in capsys.readouterr().err


def test_a_lock_that_cannot_be_removed_is_a_sentence(stale_locks, lock, monkeypatch, capsys):
    def refuse(self, missing_ok=False):
        raise PermissionError(13, "Permission denied", str(self))

    monkeypatch.setattr(stale_locks.Path, "unlink", refuse)
    monkeypatch.setattr(stale_locks, "running", lambda: stale_locks.Running([], True))
    stale_locks.clear_stale_locks()
    assert lock.exists() and "snakemake --unlock" in capsys.readouterr().err
