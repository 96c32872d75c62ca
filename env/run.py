"""Run a command in the project's environment, making that environment first where it is missing or out of date.

    python3 env/run.py snakemake --cores 2
    python3 env/run.py pytest

Standard library only. The environment lies in env/.venv and is stamped last: a stamp means that it is whole.
"""

import fcntl
import hashlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import urllib.request
from pathlib import Path

ENV = Path(__file__).resolve().parent
ROOT = ENV.parent
VENV, LOCK, STAMP = ENV / ".venv", ENV / "requirements.lock", ENV / ".venv" / "stamp"
CPU_INDEX = "https://download.pytorch.org/whl/cpu"
ANSWER_WITHIN_S = 5


def say(text: str) -> None:
    """One line to the person who waits."""
    print(f"env: {text}", file=sys.stderr, flush=True)


def stamp() -> str:
    """What the environment is made from: the lock and the Python that runs it."""
    made_from = LOCK.read_bytes() + sys.version.encode()
    return hashlib.sha256(made_from).hexdigest()


def make_venv() -> None:
    """A fresh virtual environment, also on a Debian without python3-venv."""
    shutil.rmtree(VENV, ignore_errors=True)
    if importlib.util.find_spec("ensurepip"):
        subprocess.run([sys.executable, "-m", "venv", str(VENV)], check=True)
        return
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    help_text = f"env: this Python cannot make environments; run: apt install python{version}-venv (or python3-venv)"
    if not importlib.util.find_spec("pip"):
        sys.exit(help_text)
    say("no ensurepip here; using virtualenv")
    with tempfile.TemporaryDirectory() as folder:
        install = [sys.executable, "-m", "pip", "install", "--quiet", "--target", folder, "virtualenv"]
        make = [sys.executable, "-m", "virtualenv", "--quiet", str(VENV)]
        if (
            subprocess.run(install).returncode
            or subprocess.run(make, env={**os.environ, "PYTHONPATH": folder}).returncode
        ):
            sys.exit(help_text)


def pip(*arguments: str, quiet: bool = False) -> bool:
    """Whether pip in the environment did what it was asked."""
    command = [str(VENV / "bin" / "python"), "-m", "pip", "--disable-pip-version-check", *arguments]
    return subprocess.run(command, capture_output=quiet).returncode == 0


def has_nvidia_gpu() -> bool:
    """Whether an NVIDIA driver is loaded, which alone makes the CUDA build of torch worth its 3 GB."""
    return Path("/proc/driver/nvidia/version").exists()


def cpu_index_answers() -> bool:
    """Whether PyTorch's own index of CPU builds can be reached."""
    try:
        with urllib.request.urlopen(f"{CPU_INDEX}/torch/", timeout=ANSWER_WITHIN_S) as reply:
            return bool(reply.status == 200)
    except OSError:
        return False


def install_cpu_torch(requirement: str) -> None:
    """The CPU build of torch from a wheel on disk (pip's find-links) or PyTorch's index, if either has it."""
    if pip("install", "--quiet", "--no-deps", "--no-index", requirement, quiet=True):
        say("torch: CPU build from a wheel on disk")
    elif cpu_index_answers() and pip("install", "--no-deps", "--index-url", CPU_INDEX, requirement):
        say("torch: CPU build from PyTorch's index")
    else:
        say("torch: no CPU build found, so the CUDA build comes from the package index: about 3 GB")


def make_environment() -> None:
    """Install exactly what the lock says, the stamp last."""
    if sys.version_info < (3, 11):  # noqa: UP036 (this file must say so itself)
        sys.exit(
            f"env: Python 3.11 or newer is needed, this is {sys.version.split()[0]}; run it as python3.11 env/run.py …"
        )
    say("making the environment in env/.venv; this happens once")
    make_venv()
    requirements = [line for line in LOCK.read_text().splitlines() if line.startswith("torch==")]
    if sys.platform == "linux" and os.uname().machine == "x86_64" and not has_nvidia_gpu():
        install_cpu_torch(requirements[0])
    say("installing about 100 packages, which takes a few minutes")
    if not pip("install", "--quiet", "-r", str(LOCK)):
        sys.exit("env: installing failed, see above; run the same command again, nothing half-made is used")
    activate = VENV / "bin" / "activate"
    activate.write_text(activate.read_text() + f"\nexport SNAKEMAKE_PROFILE={ENV / 'profile'}\n")
    STAMP.write_text(stamp())


def ensure_environment() -> None:
    """Make the environment unless it is whole and up to date; one launcher at a time."""
    if STAMP.is_file() and STAMP.read_text() == stamp():
        return
    with open(ENV / ".venv.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not STAMP.is_file() or STAMP.read_text() != stamp():
            make_environment()


def snakemake_runs_here() -> bool:
    """Whether another Snakemake is at work in this folder."""
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")[:3]
            named = any(os.path.basename(word) == b"snakemake" for word in words)
            if named and process.name != str(os.getpid()) and os.path.samefile(process / "cwd", "."):
                return True
        except OSError:
            continue  # it ended meanwhile, or is somebody else's
    return False


def clear_stale_locks() -> None:
    """Remove the locks that a killed Snakemake left in this folder; a live one's stay."""
    locks = list(Path(".snakemake/locks").glob("*"))
    if locks and not snakemake_runs_here():
        for lock in locks:
            lock.unlink(missing_ok=True)


def main() -> None:
    """Make the environment if needed, then become the command."""
    command = sys.argv[1:]
    if not command or command[0] in ("-h", "--help"):
        sys.exit(__doc__)
    ensure_environment()
    os.environ["VIRTUAL_ENV"] = str(VENV)
    os.environ["PATH"] = f"{VENV / 'bin'}{os.pathsep}{os.environ.get('PATH', os.defpath)}"
    os.environ.setdefault("SNAKEMAKE_PROFILE", str(ENV / "profile"))
    os.environ.pop("PYTHONHOME", None)
    if command[0] == "snakemake":
        clear_stale_locks()
    program = shutil.which(command[0])
    if program is None:
        sys.exit(f"env: there is no command {command[0]!r} in the environment or on the PATH")
    os.execv(program, command)


if __name__ == "__main__":
    main()
