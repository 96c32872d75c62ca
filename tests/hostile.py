"""Hostile command lines, settings and model files: what a fuzz feeds the programs, and how it tells a clean refusal."""

import contextlib
import importlib
import io
import os
import sys
import warnings
from pathlib import Path

import numpy as np

from pipeline.ground.errors import program

NAMES = (
    "", ".", "..", "../x", "/", "/dev/full", "/dev/null", "/proc/self/mem", "a" * 300, "x/" * 2000 + "x",
    "it's $(touch PWNED)", "-", "--", "-1", "\n", "ünïcode 名", "\udcff", "*", "a;b", "nan", "1e999", "[]", "{}",
    "null", "#", "%s%n", "~",
)  # fmt: skip
NUMBERS = ("0", "-1", "1", "nan", "inf", "-inf", "1e400", "1e-400", "0x10", "１", "9" * 5000, "2.5", "", " ", "True")


def ended(module: str, words: list[str], place: Path) -> tuple[int, str]:
    """Exit status and complaint of a program run in this process, in a folder; an exception of it is not caught."""
    output, complained, before, start_folder = io.StringIO(), io.StringIO(), sys.argv, Path.cwd()
    sys.argv = [module, *words]
    os.chdir(place)
    try:
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(complained), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            program(importlib.import_module(module).main)()
        return 0, complained.getvalue()
    except SystemExit as end:
        return int(end.code or 0), complained.getvalue()
    finally:
        sys.argv = before
        os.chdir(start_folder)


def damaged(content: bytes, rng: np.random.Generator) -> bytes:
    """A file's content, hurt: bits flipped, cut off, a stretch doubled, zeroed or lost, or digits replaced."""
    changed, at = bytearray(content), int(rng.integers(max(len(content), 1)))
    end = min(at + int(rng.integers(1, 200)), len(content))
    how = int(rng.integers(7))
    if how == 0:
        for place in rng.integers(len(content), size=int(rng.integers(1, 20))):
            changed[place] ^= 1 << int(rng.integers(8))
    elif how == 1:
        del changed[at:]
    elif how == 2:
        del changed[at:end]
    elif how == 3:
        changed[at:end] = bytes(end - at)
    elif how == 4:
        changed[at:at] = changed[at:end]
    elif how == 5:
        changed[at:end] = rng.integers(256, size=end - at, dtype=np.uint8).tobytes()
    else:  # text stays text: a number, a name or a bracket becomes another
        pairs = [(b"1", b"-9e99"), (b"0.", b"NaN,"), (b"[", b"{"), (b'"', b""), (b":", b","), (b"e", b"E"), (b".", b"")]
        old, new = pairs[int(rng.integers(len(pairs)))]
        where = changed.find(old, at)
        if where >= 0:
            changed[where : where + len(old)] = new
    return bytes(changed)
