"""An environment whose folder was moved or copied: its scripts are given their new path, without installing anything.

What holds the path: the first line of each script in bin/, the activation scripts and pyvenv.cfg.
"""

import os
import re
import subprocess
from pathlib import Path

from launcher import stamp
from launcher.install import finish_activation
from launcher.words import say

LONGEST_SHEBANG = 127  # bytes that every kernel reads of a first line
HEADER = re.compile(rb"\A#![^\n]*\n(?:'''exec'[^\n]*\n' '''\n)?")


def header(python: Path) -> bytes:
    """The first lines of a script that `python` runs, as pip writes them."""
    path = os.fsencode(python)
    plain = b"#!" + path + b"\n"
    if b" " not in path and len(plain) <= LONGEST_SHEBANG:
        return plain
    return b"#!/bin/sh\n'''exec' \"" + path + b'" "$0" "$@"\n' + b"' '''\n"


def rewrite(script: Path, old: bytes, python: Path) -> None:
    """Give a script of the old place its new first lines."""
    with open(script, "rb") as file:
        if file.read(2) != b"#!":
            return
    content = script.read_bytes()
    first = HEADER.match(content)
    if first and old in first.group():
        temporary = script.with_name(f".{script.name}.{os.getpid()}")
        temporary.write_bytes(header(python) + content[first.end() :])
        temporary.chmod(script.stat().st_mode)
        os.replace(temporary, script)


def mend(place: Path, old: str, lock: Path, profile: Path) -> bool:
    """Fit an environment that was made at `old` to the place where it lies now; whether that worked."""
    say("this checkout was moved or copied: fitting its environment to its new place")
    try:
        for script in sorted((place / "bin").iterdir()):
            if script.is_file() and not script.is_symlink():
                rewrite(script, os.fsencode(old) + b"/bin/", place / "bin" / "python")
        # writes pyvenv.cfg and the activation scripts anew, by the Python behind them, and leaves the packages
        command = [str(place / "bin" / "python"), "-I", "-m", "venv", "--without-pip", str(place)]
        if subprocess.run(command, capture_output=True).returncode:
            return False
        finish_activation(place, profile)
        stamp.write(place, lock)
    except OSError:
        return False
    return True
