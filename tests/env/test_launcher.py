"""What the launcher says and asks for: torch's build, systems that it refuses, commands that are not there."""

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

RUN = Path(__file__).parents[2] / "env" / "run.py"
NOTHING_IS_MADE = "sys.modules['launcher'] = None"  # what is not refused ends before it makes an environment


@pytest.fixture
def install(monkeypatch):
    """The launcher's module that installs."""
    monkeypatch.syspath_prepend(str(RUN.parent))
    return importlib.import_module("launcher.install")


@pytest.mark.parametrize(
    ("gpu", "on_disk", "index", "expected"),
    [
        (False, True, True, ["--no-index"]),
        (False, False, True, ["--no-index", "--index-url"]),
        (False, False, False, ["--no-index"]),
        (True, True, True, []),
    ],
)
def test_the_cpu_build_of_torch_is_preferred_without_a_gpu(
    install, tmp_path, monkeypatch, gpu, on_disk, index, expected
):
    lock = tmp_path / "requirements.lock"
    lock.write_text("six==1.16.0\ntorch==2.13.0\n")
    monkeypatch.setattr(install.sys, "platform", "linux")
    monkeypatch.setattr(install.platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(install, "has_nvidia_gpu", lambda: gpu)
    monkeypatch.setattr(install, "cpu_index_answers", lambda: index)
    pip_calls = []

    def pip(self, *words, quiet=False):
        pip_calls.append(words)
        return on_disk or "--no-index" not in words

    monkeypatch.setattr(install.Installer, "pip", pip)
    install.Installer(tmp_path, None).packages(lock)
    options = [word for words in pip_calls for word in words if word in ("--no-index", "--index-url")]
    assert options == expected
    assert any("torch==2.13.0" in words for words in pip_calls) == bool(expected)
    assert pip_calls[-1][-2] == "-r"  # the lock comes last, and finds torch there


def test_a_package_with_a_setup_py_alone_gets_a_record_from_an_old_pip_too(install, tmp_path, monkeypatch):
    lock = tmp_path / "requirements.lock"
    lock.write_text("six==1.16.0\n")
    pip_calls = []
    monkeypatch.setattr(install.Installer, "pip", lambda self, *words, quiet=False: pip_calls.append(words) or True)
    install.Installer(tmp_path, None).packages(lock)
    assert ["--use-pep517" in words for words in pip_calls] == [True]


@pytest.mark.parametrize("pip_too", [True, False])
def test_without_python3_venv_it_takes_virtualenv_or_says_what_to_install(install, tmp_path, monkeypatch, pip_too):
    missing = {"ensurepip"} if pip_too else {"ensurepip", "pip"}
    monkeypatch.setattr(install.importlib.util, "find_spec", lambda name: None if name in missing else object())
    commands = []

    def run(command, **_):
        commands.append(command)
        return subprocess.CompletedProcess(command, 0 if pip_too else 1)

    monkeypatch.setattr(install.subprocess, "run", run)
    if pip_too:
        install.Installer(tmp_path, None).make_venv()
        assert "virtualenv" in commands[0] and commands[1][1:3] == ("-m", "virtualenv")
    else:
        with pytest.raises(SystemExit, match=r"apt install python3\.\d+-venv"):
            install.Installer(tmp_path, None).make_venv()


def launched(*words, first="pass"):
    """The launcher, after some code of the test's own."""
    code = f"import os, runpy, shutil, sys; {first}; sys.argv = {['run.py', *words]!r}; "
    code += f"runpy.run_path({str(RUN)!r}, run_name='__main__')"
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)


def test_without_a_command_it_says_how_it_is_used():
    done = launched()
    assert done.returncode == 1 and "env/run.py snakemake" in done.stderr


def test_windows_is_refused_in_one_sentence():
    done = launched("pytest", first=f"os.name = 'nt'; {NOTHING_IS_MADE}")
    assert done.returncode == 1 and "WSL" in done.stderr and len(done.stderr.splitlines()) == 1


def test_macos_is_refused_in_one_sentence_by_the_launcher_alone():
    done = launched("pytest", first=f"sys.platform = 'darwin'; {NOTHING_IS_MADE}")
    assert done.returncode == 1 and "never tried on macOS" in done.stderr and len(done.stderr.splitlines()) == 1
    assert "a Linux container or virtual machine" in done.stderr
    root = RUN.parents[1]
    for page, begins in (("README.md", "- Needed are"), ("docs/jobs.md", "- **System**")):
        needed = (root / page).read_text().partition(begins)[2].partition("Python")[0]
        assert all(word in needed for word in ("Linux", "WSL 2", "macOS", "Linux container")), page
    code = "import pandas, scipy, sys; sys.platform = 'darwin'; from pipeline import new_run, notebook"
    done = subprocess.run([sys.executable, "-c", code], cwd=root, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_an_old_python_is_refused_in_one_sentence():
    done = launched("pytest", first=f"sys.version_info = (3, 10, 2); {NOTHING_IS_MADE}")
    assert done.returncode == 1 and "Python 3.11 or newer" in done.stderr and len(done.stderr.splitlines()) == 1


def test_a_command_that_is_not_there_or_does_not_run_is_a_sentence(checkout, tmp_path):
    done = checkout.run("no-such-command")
    assert done.returncode == 1 and "no command 'no-such-command'" in done.stderr
    broken = tmp_path / "broken"
    broken.write_bytes(b"\0\1\2\3")
    broken.chmod(0o755)
    done = checkout.run(str(broken))
    assert done.returncode == 1 and "cannot be run" in done.stderr and "Traceback" not in done.stderr


@pytest.mark.long
def test_it_makes_runs_and_keeps_where_the_system_has_no_locks_and_no_proc(bare, tmp_path):
    """Where it cannot be known whether an old environment is used, it stays, and how to remove it is said."""
    site = Path(bare.quick["PYTHONPATH"]) / "sitecustomize.py"
    poor = "import os, sys\nif os.path.basename(sys.orig_argv[1]) == 'run.py':\n"
    poor += "    sys.modules['fcntl'] = sys.modules['ctypes'] = None\n    del os.fdatasync\n"
    (tmp_path / "sitecustomize.py").write_text(site.read_text() + poor)
    without = {"PYTHONPATH": str(tmp_path)}
    assert bare.run("alpha", **without).stdout.startswith("alpha 1.0")
    old = bare.link.resolve()
    bare.lock("alpha==2.0", "beta==1.0")
    done = bare.run("alpha", **without)
    assert done.stdout.startswith("alpha 2.0") and old in bare.places()
    assert f"when no job runs, delete in env/: {old.name}" in done.stderr
