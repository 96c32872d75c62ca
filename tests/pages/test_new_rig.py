"""docs/new_rig.md, executed: its files dropped into a copy of the package, and a pendulum that they have never seen."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import copied
import numpy as np
import pandas as pd
import pytest
from files_shown import shown

ROOT = Path(__file__).parents[2]
INERTIA_KG_M2, WEIGHT_NM = 0.0213, 0.94  # within the tolerance of what the page's run.yaml says
RATE_HZ = 500.0


def recorded(seed, bearing=0.0, oil=0.0, offset=0.0, air=0.0):
    """A pendulum swung through strokes at three speeds; its bearing sticks as bristles do, its oil thins a little."""
    chance = np.random.default_rng(seed)
    time_s = np.arange(0.0, 40.0, 1.0 / RATE_HZ)
    speed = np.interp(time_s, [0, 13, 14, 26, 27, 40], [1.6, 1.6, 3.1, 3.1, 4.6, 4.6])  # rad/s of the swing's phase
    phase = np.cumsum(speed) / RATE_HZ
    angle = 1.1 * (1.0 - np.cos(phase)) + 0.12 * np.sin(2.3 * phase)
    rate = np.gradient(angle, time_s)
    torque = INERTIA_KG_M2 * np.gradient(rate, time_s) + WEIGHT_NM * np.sin(angle)
    bristle = np.zeros_like(angle)
    for i in range(1, len(angle)):
        step = angle[i] - angle[i - 1]
        bristle[i] = np.clip(bristle[i - 1] + step - abs(step) * bristle[i - 1] / 4e-3, -4e-3, 4e-3)
    torque += bearing * bristle / 4e-3 * (1.0 + 0.05 * np.exp(-np.abs(rate) / 0.3))
    torque += oil * np.sign(rate) * np.abs(rate) ** 0.96 + air * rate * np.abs(rate) + offset
    torque += 0.004 * chance.standard_normal(len(time_s))
    grain = 2.0 * np.pi / 2**20
    angle = np.round(angle / grain) * grain
    return pd.DataFrame({"time_s": time_s, "angle_rad": angle, "torque_nm": np.round(torque, 4)})


@pytest.fixture(scope="module")
def house(tmp_path_factory):
    """A copy of the package with the page's two files in it; run.yaml's text besides."""
    root, files = tmp_path_factory.mktemp("house"), shown("docs/new_rig.md")
    copied.package(root)
    for path, text in files.items():
        if path.endswith(".py"):
            (root / path).write_text(text)
    return root, files["raw/pendulum-01/run.yaml"]


def diagnosed(house, samples):
    """The diagnosis of a recording, by the program."""
    root, run_yaml = house
    folder = root / "raw/pendulum-01"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "run.yaml").write_text(run_yaml)
    samples.to_csv(folder / "recording.csv", index=False)
    environment = {**os.environ, "PYTHONPATH": str(root)}
    diagnosis_file, out = root / "out/pendulum-01/diagnosis.json", root / "s.parquet"
    for command in (
        ["pipeline.diagnose", folder, "--out", root / "out"],
        ["pipeline.simulate", folder, "--simulation", diagnosis_file, "--out", out],
    ):
        done = subprocess.run(
            [sys.executable, "-m", *map(str, command)], cwd=root, env=environment, capture_output=True, text=True
        )
        assert done.returncode == 0 and "Traceback" not in done.stderr, done.stderr
    return json.loads(diagnosis_file.read_text()), pd.read_parquet(out)


def named(content):
    """What a diagnosis names, by id."""
    return {mechanism["id"]: mechanism for mechanism in content["mechanisms"]}


def value(entry, *names):
    """Value of the one of some parameters that is there."""
    return next(entry["parameters"][name] for name in names if name in entry["parameters"])


def test_the_page_has_its_files():
    assert set(shown("docs/new_rig.md")) == {
        "pipeline/systems/pendulum.py", "raw/pendulum-01/run.yaml", "pipeline/diagnosis/mechanisms/x_air_drag.py",
    }  # fmt: skip


@pytest.mark.long
def test_a_strangers_rig_is_diagnosed_in_its_own_units(house):
    samples = recorded(1, bearing=0.06, oil=0.03, offset=0.02)
    content, simulated = diagnosed(house, samples)
    mechanisms = named(content)
    assert content["verdict"] == "explained"
    assert set(mechanisms) == {"friction_hysteresis", "viscous_loss", "sensor_offset"}
    assert content["parameters"]["inertia_kg_m2"]["value"] == pytest.approx(INERTIA_KG_M2, rel=0.03)
    assert content["parameters"]["weight_nm"]["value"] == pytest.approx(WEIGHT_NM, rel=0.02)
    loop = value(mechanisms["friction_hysteresis"], "half_loop_nm", "dry_nm")
    assert loop["value"] == pytest.approx(0.06, rel=0.2) and loop["unit"] == "Nm"
    straight = mechanisms["viscous_loss"]["parameters"]["straight_nm_per_rad_s"]
    assert straight["value"] == pytest.approx(0.03, rel=0.2) and straight["unit"] == "Nm s/rad"
    assert mechanisms["sensor_offset"]["parameters"]["offset_nm"]["value"] == pytest.approx(0.02, rel=0.25)
    assert "angle_rad" in content["mismatch"]["location"]
    assert content["fit"]["heldout"]["explained_nm"] < 0.3 * content["fit"]["heldout"]["calibrated_nm"]
    assert list(simulated.columns) == ["time_s", "torque_nm"] and len(simulated) == len(samples)
    assert abs(np.mean(simulated["torque_nm"] - samples["torque_nm"])) < 0.004  # a true zero is not tared away
    error = np.std(simulated["torque_nm"] - samples["torque_nm"])
    assert error < 0.4 * np.std(samples["torque_nm"] - WEIGHT_NM * np.sin(samples["angle_rad"]))


@pytest.mark.long
def test_a_strangers_mechanism_is_named_beside_the_librarys(house):
    content, _ = diagnosed(house, recorded(2, bearing=0.06, air=0.05))
    mechanisms = named(content)
    assert content["verdict"] == "ambiguous"
    assert set(mechanisms) == {"friction_hysteresis", "x_air_drag"}
    square = mechanisms["x_air_drag"]["parameters"]["square_nm_per_rad2_s2"]
    assert square["value"] == pytest.approx(0.05, rel=0.15) and square["unit"] == "Nm s2/rad2"


@pytest.mark.long
def test_nothing_is_named_where_nothing_is_missing(house):
    content, _ = diagnosed(house, recorded(3))
    assert content["verdict"] in ("consistent", "parameters") and not content["mechanisms"]
    assert content["parameters"]["inertia_kg_m2"]["value"] == pytest.approx(INERTIA_KG_M2, rel=0.03)


@pytest.mark.long
def test_a_mechanism_of_ones_own_alone_counts_as_unknown_but_is_told_with_its_simulation(house):
    content, _ = diagnosed(house, recorded(5, air=0.05))
    assert content["verdict"] == "unknown" and not content["mechanisms"] and not content["simulation"]
    (own,) = content["of_your_own"]["mechanisms"]
    assert own["parameters"]["square_nm_per_rad2_s2"]["value"] == pytest.approx(0.05, rel=0.1)
    assert [entry["id"] for entry in content["of_your_own"]["simulation"]] == ["x_air_drag"]
    assert not {"load", "wind", "twist"} & set(re.findall(r"\w+", content["next_experiment"]))


@pytest.mark.long
def test_the_tests_that_the_page_names_accept_its_files(house):
    root, _ = house
    shutil.copytree(ROOT / "tests", root / "tests", ignore=shutil.ignore_patterns("__pycache__", "data"))
    named = ["tests/systems/test_systems.py", "tests/diagnosis/mechanisms/test_library.py"]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *named, "-k", "not longer_recording"],
        cwd=root, env={**os.environ, "PYTHONPATH": str(root)}, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
