"""Recordings of public rigs, which are not ours to keep: where they lie, and a skip that says so."""

import os
from pathlib import Path

import pytest

NAME = "TWISTBENCH_RECORDINGS"  # the environment variable that names a folder with a folder for each rig
SOURCES = {
    "tsa_haptic": "FaragSeif/tsa_haptic, scripts/data/*.csv",
    "davinci_tool": "MRDLab/mis-tool-characterization, Tool_4_Maryland_R_5_*.TXT",
    "emps": "wmkouw/NSI-EMPS, DATA_EMPS.mat",
}


def folder() -> Path:
    """Where the recordings lie; skips the test where nobody said it."""
    named = os.environ.get(NAME)
    if not named:
        pytest.skip(f"{NAME} names no folder of public recordings: docs/real.md says what it holds")
    return Path(named)


def files(rig: str, pattern: str) -> list[Path]:
    """Recordings of a rig whose names match, sorted; skips the test where there are none."""
    matching = sorted((folder() / rig).glob(pattern))
    if not matching:
        pytest.skip(f"{NAME} has no {rig}/{pattern}: get it from github.com/{SOURCES[rig]}")
    return matching
