"""What each job of the workflow takes, and which files it opens: CPU seconds, memory, bytes in and out.

    python benchmarks/jobs.py --out jobs.csv [--trace] FOLDER -- snakemake --cores 2 [...]

runs the command in FOLDER, a checkout. A stand-in for `python` comes first on its PATH: it starts the real one, waits
for all that this started, and writes a line a job: CPU seconds of all its processes, and the most memory that they
held at once (pages that several share count once; looked at 5 times a second, or that of the largest process). With
--trace each job runs under strace, and OUT gets the files of the checkout that it opened.
"""

import argparse
import contextlib
import csv
import ctypes
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil

EACH_S = 0.2
PR_SET_CHILD_SUBREAPER = 36  # of Linux: whom a dying process leaves behind becomes a child of this one
COLUMNS = ("log", "module", "node", "wall_s", "cpu_s", "peak_mb", "read", "written")
OPENED = re.compile(r'open(?:at)?\((?:AT_FDCWD, )?"([^"]+)", ([A-Z_|]+).*\) = \d')
MOVED = re.compile(r'rename(?:at2?)?\((?:AT_FDCWD, )?"([^"]+)", (?:AT_FDCWD, )?"([^"]+)".*\) = 0')
STAND_IN = """#!/bin/sh
exec {python} {program} --job "$@"
"""


def opened(trace: Path, folder: Path) -> tuple[list[str], list[str]]:
    """Files of the checkout that a job read, and those that it wrote; a file that was renamed has its last name."""
    read: set[str] = set()
    written: set[str] = set()
    for line in trace.read_text(encoding="utf-8", errors="replace").splitlines():
        found, moved = OPENED.search(line), MOVED.search(line)
        for name, kind in [(found[1], found[2])] if found else []:
            if "O_DIRECTORY" not in kind:
                (written if "O_WRONLY" in kind or "O_RDWR" in kind else read).add(os.path.abspath(folder / name))
        if moved:  # a file, or a folder with what was written in it
            old, new = (os.path.abspath(folder / moved[part]) for part in (1, 2))
            written = {new + name[len(old) :] if f"{name}/".startswith(f"{old}/") else name for name in written} | {new}
    inside = f"{folder}{os.sep}"
    own = [
        sorted(name.removeprefix(inside) for name in names if name.startswith(inside) and os.path.isfile(name))
        for names in (read - written, written)
    ]
    return own[0], own[1]


def held_kb() -> int:
    """Memory that the processes below this one hold now, shared pages once."""
    held = 0
    for process in psutil.Process().children(recursive=True):
        with contextlib.suppress(psutil.Error, OSError):
            held += process.memory_full_info().pss // 1024
    return held


def watched(command: list[str]) -> tuple[int, int]:
    """Run a command until the last process that it started has ended: its exit status, and the peak of their memory."""
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    child, peak_kb, status = subprocess.Popen(command), 0, 0
    with contextlib.suppress(ChildProcessError):
        while True:
            process, ended = os.waitpid(-1, os.WNOHANG)
            if process == child.pid:
                status = os.waitstatus_to_exitcode(ended)
            if not process:
                peak_kb = max(peak_kb, held_kb())
                time.sleep(EACH_S)
    return status, peak_kb


def job(words: list[str]) -> None:
    """Stand in for `python`: run it, and write what it took."""
    real, out = os.environ["TWISTBENCH_JOBS_PYTHON"], Path(os.environ["TWISTBENCH_JOBS"])
    folder = Path.cwd()
    log = os.path.relpath(os.readlink("/proc/self/fd/1"), folder)
    trace = Path(tempfile.mkstemp(suffix=".trace", dir=out)[1])
    command = [real, *words]
    if os.environ.get("TWISTBENCH_JOBS_TRACE"):
        command = [
            "strace",
            "-f",
            "--seccomp-bpf",
            "-qq",
            "-s",
            "4096",
            "-e",
            "trace=open,openat,rename,renameat,renameat2",
            "-o",
            str(trace),
            *command,
        ]
    os.environ.pop("TWISTBENCH_PARENT", None)  # whose child it is no more
    began = time.monotonic()
    status, peak_kb = watched(command)
    wall, used = time.monotonic() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    read, written = opened(trace, folder)
    module = words[words.index("-m") + 1] if "-m" in words else ""
    cpu = used.ru_utime + used.ru_stime
    peak_mb = max(used.ru_maxrss, peak_kb) // 1024
    row = [log, module, os.environ.get("SLURMD_NODENAME", ""), f"{wall:.2f}", f"{cpu:.2f}", peak_mb]
    with open(f"{trace}.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerow([*row, "|".join(read), "|".join(written)])
    trace.unlink()
    sys.exit(status if status >= 0 else 128 - status)


def main() -> None:
    """Measure the jobs of a command."""
    if sys.argv[1:2] == ["--job"]:
        job(sys.argv[2:])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--trace", action="store_true")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "bin").mkdir()
        stand_in = Path(place) / "bin" / "python"
        stand_in.write_text(STAND_IN.format(python=sys.executable, program=Path(__file__).resolve()))
        stand_in.chmod(0o755)
        environment = {
            **os.environ,
            "PATH": f"{place}/bin:{Path(sys.executable).parent}:{os.environ['PATH']}",
            "SNAKEMAKE_PROFILE": str(asked.folder.resolve() / "env" / "profile"),
            "TWISTBENCH_JOBS": place,
            "TWISTBENCH_JOBS_PYTHON": sys.executable,
            "TWISTBENCH_JOBS_TRACE": "1" if asked.trace else "",
        }
        words = asked.command[asked.command[:1] == ["--"] :]
        program = shutil.which(words[0], path=environment["PATH"]) or words[0]
        done = subprocess.run([program, *words[1:]], cwd=asked.folder, env=environment)
        rows = sorted(line for path in Path(place).glob("*.csv") for line in csv.reader(path.open(encoding="utf-8")))
    with open(asked.out, "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([COLUMNS, *rows])
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
