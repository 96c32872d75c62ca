"""The packages of the lock, installed into an environment by pip, which ends when the launcher does."""

import contextlib
import importlib.util
import os
import platform
import shlex
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from launcher.records import locked
from launcher.words import say

CPU_INDEX = "https://download.pytorch.org/whl/cpu"
ANSWER_WITHIN_S = 5
SET_PARENT_DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG


def dying_with_this_process() -> Callable[[], None] | None:
    """What a child calls first on Linux so that the kernel ends it with this process; None elsewhere."""
    if sys.platform != "linux":
        return None
    try:
        import ctypes

        prctl = ctypes.CDLL(None).prctl
    except (ImportError, OSError, AttributeError):
        return None
    launcher = os.getpid()

    def first() -> None:
        prctl(SET_PARENT_DEATH_SIGNAL, signal.SIGKILL)
        if os.getppid() != launcher:
            os._exit(1)

    return first


class Installer:
    """Runs what fills an environment; each child holds the launcher's lock and keeps its temporary files in there."""

    def __init__(self, place: Path, lock_file: int | None) -> None:
        self.place, self.lock_file = place, lock_file
        self.temporary = place / "tmp"

    def run(self, *command: str, quiet: bool = False, **environment: str) -> bool:
        """Whether a command succeeded."""
        self.temporary.mkdir(exist_ok=True)
        done = subprocess.run(
            command,
            capture_output=quiet,
            pass_fds=() if self.lock_file is None else (self.lock_file,),
            preexec_fn=dying_with_this_process(),
            env={**os.environ, "PIP_USER": "0", "TMPDIR": str(self.temporary), **environment},
        )
        return done.returncode == 0

    def pip(self, *arguments: str, quiet: bool = False) -> bool:
        """Whether pip in the environment did what it was asked."""
        python = str(self.place / "bin" / "python")
        return self.run(python, "-I", "-m", "pip", "--disable-pip-version-check", *arguments, quiet=quiet)

    def make_venv(self) -> None:
        """A fresh virtual environment, also on a Debian without python3-venv."""
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        help_text = (
            f"env: this Python cannot make environments; run: apt install python{version}-venv (or python3-venv)"
        )
        if importlib.util.find_spec("ensurepip"):
            if not self.run(sys.executable, "-m", "venv", str(self.place)):
                sys.exit("env: making the virtual environment failed, see above")
            return
        if not importlib.util.find_spec("pip"):
            sys.exit(help_text)
        say("no ensurepip here; using virtualenv")
        with tempfile.TemporaryDirectory() as folder:
            install = [sys.executable, "-m", "pip", "install", "--quiet", "--target", folder, "virtualenv"]
            make = [sys.executable, "-m", "virtualenv", "--quiet", str(self.place)]
            if not (self.run(*install) and self.run(*make, PYTHONPATH=folder)):
                sys.exit(help_text)

    def cpu_torch(self, requirement: str) -> None:
        """The CPU build of torch from a wheel on disk (pip's find-links) or PyTorch's index, if either has it."""
        if self.pip("install", "--quiet", "--no-deps", "--no-index", requirement, quiet=True):
            say("torch: CPU build from a wheel on disk")
        elif cpu_index_answers() and self.pip("install", "--no-deps", "--index-url", CPU_INDEX, requirement):
            say("torch: CPU build from PyTorch's index")
        else:
            say("torch: no CPU build found, so the CUDA build comes from the package index: about 3 GB")

    def packages(self, lock: Path) -> None:
        """Everything that the lock names, torch first."""
        torch = [line for line in lock.read_text(encoding="utf-8").splitlines() if line.startswith("torch==")]
        if torch and sys.platform == "linux" and platform.machine() == "x86_64" and not has_nvidia_gpu():
            self.cpu_torch(torch[0])
        say(f"installing {len(locked(lock))} packages; a hundred take a few minutes")
        # By PEP 517, else a pip before 23.1 leaves no record of what has a setup.py alone, and nothing can be checked.
        if not self.pip("install", "--quiet", "--use-pep517", "-r", str(lock)):
            sys.exit("env: installing failed, see above; run the same command again, nothing half-made is used")


def has_nvidia_gpu() -> bool:
    """Whether an NVIDIA driver is loaded, which alone makes the CUDA build of torch worth its 3 GB."""
    return Path("/proc/driver/nvidia/version").exists()


def cpu_index_answers() -> bool:
    """Whether PyTorch's own index of CPU builds can be reached."""
    import urllib.request  # here, as it is the slowest of all to import and seldom needed

    try:
        with urllib.request.urlopen(f"{CPU_INDEX}/torch/", timeout=ANSWER_WITHIN_S) as reply:
            return bool(reply.status == 200)
    except OSError:
        return False


def finish_activation(place: Path, profile: Path) -> None:
    """Let the activation scripts set Snakemake's profile too, whatever characters its path has."""
    quoted = shlex.quote(str(profile))
    for name, line in {
        "activate": f"export SNAKEMAKE_PROFILE={quoted}",
        "activate.fish": f"set -gx SNAKEMAKE_PROFILE {quoted}",
        "activate.csh": f"setenv SNAKEMAKE_PROFILE {quoted}",
    }.items():
        with contextlib.suppress(FileNotFoundError):
            path = place / "bin" / name
            path.write_text(f"{path.read_text(encoding='utf-8')}\n{line}\n", encoding="utf-8")
