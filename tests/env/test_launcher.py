"""The launcher: when it makes the environment, what it says when it cannot, and which locks it clears."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

PATH = Path(__file__).parents[2] / "env" / "run.py"


@pytest.fixture
def launcher(tmp_path, monkeypatch):
    """The launcher as a module, on an environment folder of its own."""
    spec = importlib.util.spec_from_file_location("launcher", PATH)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    (tmp_path / "requirements.lock").write_text("torch==2.13.0\nsix==1.16.0\n")
    for name, path in {"ENV": tmp_path, "VENV": tmp_path / ".venv", "STAMP": tmp_path / ".venv" / "stamp"}.items():
        monkeypatch.setattr(module, name, path)
    monkeypatch.setattr(module, "LOCK", tmp_path / "requirements.lock")
    return module


@pytest.fixture
def asked(launcher, monkeypatch):
    """What pip is asked for; it always succeeds, and making the venv does nothing."""
    calls = []
    monkeypatch.setattr(launcher, "pip", lambda *words, quiet=False: calls.append(words) or True)

    def make_venv():
        (launcher.VENV / "bin").mkdir(parents=True, exist_ok=True)
        (launcher.VENV / "bin" / "activate").write_text("")

    monkeypatch.setattr(launcher, "make_venv", make_venv)
    return calls


def test_the_environment_is_made_once_and_again_when_the_lock_changes(launcher, asked):
    launcher.ensure_environment()
    made = len(asked)
    assert made and launcher.STAMP.read_text() == launcher.stamp()
    launcher.ensure_environment()
    assert len(asked) == made
    launcher.LOCK.write_text("torch==2.13.0\n")
    launcher.ensure_environment()
    assert len(asked) > made


def test_a_failed_install_leaves_no_stamp(launcher, asked, monkeypatch):
    monkeypatch.setattr(launcher, "pip", lambda *words, quiet=False: "-r" not in words)
    with pytest.raises(SystemExit, match="installing failed"):
        launcher.ensure_environment()
    assert not launcher.STAMP.exists()


@pytest.mark.parametrize(
    ("gpu", "on_disk", "index", "expected"),
    [
        (False, True, True, ["--no-index"]),
        (False, False, True, ["--no-index", "--index-url"]),
        (False, False, False, ["--no-index"]),
        (True, True, True, []),
    ],
)
def test_the_cpu_build_of_torch_is_preferred_without_a_gpu(launcher, asked, monkeypatch, gpu, on_disk, index, expected):
    monkeypatch.setattr(launcher.sys, "platform", "linux")
    monkeypatch.setattr(launcher, "has_nvidia_gpu", lambda: gpu)
    monkeypatch.setattr(launcher, "cpu_index_answers", lambda: index)

    def pip(*words, quiet=False):
        asked.append(words)
        return on_disk or "--no-index" not in words

    monkeypatch.setattr(launcher, "pip", pip)
    launcher.ensure_environment()
    options = [word for words in asked for word in words if word in ("--no-index", "--index-url")]
    assert options == expected
    assert any("torch==2.13.0" in words for words in asked) == bool(expected)
    assert asked[-1][-2] == "-r"  # the lock comes last, and finds torch there


@pytest.mark.parametrize("pip_too", [True, False])
def test_without_python3_venv_it_takes_virtualenv_or_says_what_to_install(launcher, monkeypatch, pip_too):
    missing = {"ensurepip"} if pip_too else {"ensurepip", "pip"}
    monkeypatch.setattr(launcher.importlib.util, "find_spec", lambda name: None if name in missing else object())
    commands = []

    def run(command, **_):
        commands.append(command)
        return subprocess.CompletedProcess(command, 0 if pip_too else 1)

    monkeypatch.setattr(launcher.subprocess, "run", run)
    if pip_too:
        launcher.make_venv()
        assert "virtualenv" in commands[0] and commands[1][1:3] == ["-m", "virtualenv"]
    else:
        with pytest.raises(SystemExit, match=r"apt install python3\.\d+-venv"):
            launcher.make_venv()


def test_stale_locks_go_and_live_ones_stay(launcher, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    lock = tmp_path / ".snakemake" / "locks" / "0.input.lock"
    lock.parent.mkdir(parents=True)
    lock.touch()
    program = tmp_path / "bin" / "snakemake"
    program.parent.mkdir()
    program.write_text("import time; print('at work', flush=True); time.sleep(60)")
    alive = subprocess.Popen([sys.executable, str(program)], cwd=tmp_path, stdout=subprocess.PIPE)
    try:
        alive.stdout.readline()
        launcher.clear_stale_locks()
        assert lock.exists()
    finally:
        alive.kill()
        alive.communicate()
    launcher.clear_stale_locks()
    assert not lock.exists()


def test_without_a_command_it_says_how_it_is_used():
    done = subprocess.run([sys.executable, str(PATH)], capture_output=True, text=True)
    assert done.returncode == 1 and "env/run.py snakemake" in done.stderr
