"""Recordings of public rigs, which are not ours to keep: where they lie, and a skip that says so."""

import os
from pathlib import Path

import pytest

NAME = "TWISTBENCH_RECORDINGS"  # the environment variable that names a folder with a folder for each rig
BESIDE = Path(__file__).resolve().parents[2] / "shared" / "recordings"  # such a folder beside the checkout
SOURCES = {
    "tsa_haptic": "FaragSeif/tsa_haptic, scripts/data/*.csv",
    "davinci_tool": "MRDLab/mis-tool-characterization, Tool_4_Maryland_R_5_*.TXT",
    "emps": "wmkouw/NSI-EMPS, DATA_EMPS.mat",
}


def folder() -> Path:
    """Where the variable says, or else beside the checkout; skips the test where neither is."""
    named = os.environ.get(NAME)
    if named:
        return Path(named)
    if not BESIDE.is_dir():
        pytest.skip(f"{NAME} names no folder of public recordings: docs/real.md says what it holds")
    return BESIDE


def files(rig: str, pattern: str) -> list[Path]:
    """Recordings of a rig whose names match, sorted; skips the test where there are none.

    In CI it fails instead where the rig has a folder: a recording that was there is gone, or is called otherwise.
    """
    place = folder() / rig
    matching = sorted(place.glob(pattern))
    if not matching:
        lacking = f"{place} has no {pattern}: get it from github.com/{SOURCES[rig]}"
        if os.environ.get("CI") and place.is_dir():
            pytest.fail(lacking)
        pytest.skip(lacking)
    return matching
