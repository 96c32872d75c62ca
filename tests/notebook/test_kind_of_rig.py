"""Whoever reads a diagnosis back need not know of which kind of rig it is, and cannot read it as another's."""

import json
from pathlib import Path

import pytest

import pipeline as tb
from pipeline.ground.units import unit_of
from pipeline.systems import systems


def written(folder: Path, actuator: str, *, placed: bool = True) -> Path:
    """A diagnosis of this kind of rig, as short as may be."""
    system = systems()[actuator]
    unit = unit_of(system.channel)
    mismatch = {f"rms_{unit}": 1.0, "location": {system.driver: [0.0, 1.0], "phase": "all"}, "driver": "motion"}
    content = {
        "run": "lab-1",
        "verdict": "unknown" if placed else "consistent",
        "mismatch": mismatch if placed else None,
        "parameters": {name: {"value": 1.0} for name in system.rig},
        "fit": {f"noise_floor_{unit}": 0.1},
        "simulation": [],
    }
    path = folder / "diagnosis.json"
    path.write_text(json.dumps(content))
    return path


@pytest.mark.parametrize("actuator", systems())
def test_a_diagnosis_says_of_which_kind_of_rig_it_is(actuator: str, tmp_path: Path) -> None:
    assert tb.Diagnosis.read(written(tmp_path, actuator)).actuator == actuator
    assert tb.Diagnosis.read(written(tmp_path, actuator), actuator).actuator == actuator


def test_dimensions_alone_tell_two_rigs_of_one_unit_apart(tmp_path: Path) -> None:
    assert tb.Diagnosis.read(written(tmp_path, "cable_drive", placed=False)).actuator == "cable_drive"
    assert tb.Diagnosis.read(written(tmp_path, "tendon_sheath", placed=False)).actuator == "tendon_sheath"


def test_a_diagnosis_is_not_read_as_another_rigs(tmp_path: Path) -> None:
    path = written(tmp_path, "cable_drive")
    with pytest.raises(tb.BadInput, match=r"'separator' measures displacement_mm.* deg.*take one of cable_drive"):
        tb.Diagnosis.read(path, "separator")
    with pytest.raises(tb.BadInput, match=r"'winch' is none.*take one of cable_drive"):
        tb.Diagnosis.read(path, "winch")


def test_a_diagnosis_that_does_not_tell_its_rig_asks_for_it(tmp_path: Path) -> None:
    path = written(tmp_path, "cable_drive", placed=False)
    content = json.loads(path.read_text())
    path.write_text(json.dumps(content | {"parameters": {"gear_ratio": {}, "pulley_radius_mm": {}}}))
    with pytest.raises(tb.BadInput, match=r"fits cable_drive, tendon_sheath.*say the kind of rig"):
        tb.Diagnosis.read(path)
    path.write_text(json.dumps(content | {"fit": {}}))
    with pytest.raises(tb.BadInput, match=r"has no noise_floor_.*say the kind of rig"):
        tb.Diagnosis.read(path)
