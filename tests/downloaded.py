"""Recordings of public rigs, which are not ours to keep: where they lie, and a skip that says where to get them."""

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
NAME = "TWISTBENCH_RECORDINGS"
# a folder for each rig, beside the checkout unless the variable names another place
FOLDER = Path(os.environ.get(NAME) or ROOT.parent / "shared" / "recordings")
SOURCES = {
    "tsa_haptic": "FaragSeif/tsa_haptic, scripts/data/*.csv",
    "davinci_tool": "MRDLab/mis-tool-characterization, Tool_4_Maryland_R_5_*.TXT",
    "emps": "wmkouw/NSI-EMPS, DATA_EMPS.mat",
}


def files(rig: str, pattern: str) -> list[Path]:
    """Recordings of a rig whose names match, sorted; skips the test where there are none."""
    found = sorted((FOLDER / rig).glob(pattern))
    if not found:
        pytest.skip(f"{NAME} has no {rig}/{pattern}: get it from github.com/{SOURCES[rig]}")
    return found
