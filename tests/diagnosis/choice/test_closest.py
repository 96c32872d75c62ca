"""Of an unknown mismatch, what comes closest predicts the rig, and is no name."""

import json
import shutil
from types import SimpleNamespace

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.diagnosis.choice import closest
from pipeline.diagnosis.prediction.without_a_name import said_of_no_name, to_simulate
from pipeline.run.samples import read_samples

DIRECTED = ("friction_hysteresis", "backlash", "viscous_loss", "sensor_lag", "stick_slip", "x_clock", "load_swing")


@pytest.fixture(scope="module")
def unknown(conceal, remembered, tmp_path_factory):
    """A run with friction, the `diagnosis.json` by a library that has no friction and no play, and its folder."""
    folder, out = conceal("friction_hysteresis")[0], tmp_path_factory.mktemp("out")
    lacking = [word for id_ in DIRECTED for word in ("--without", id_)]
    with remembered():
        done = programs.run("pipeline.diagnose", folder, "--out", out, *lacking)
    assert done.returncode == 0, done.stderr
    path = next(out.rglob("diagnosis.json"))
    return folder, path, json.loads(path.read_text())


@pytest.mark.long
def test_it_is_simulated_named_nowhere_and_said_to_be_no_name(unknown):
    _, path, content = unknown
    heldout, ids = content["fit"]["heldout"], content["closest"]["ids"]
    assert content["verdict"] == "unknown" and ids
    assert content["mechanisms"] == [] and content["simulation"] == []
    assert [entry["id"] for entry in content["closest"]["simulation"]] == ids
    assert content["evidence"]["chosen_without_them"] == [] and content["evidence"]["closest_without_them"]
    assert heldout["explained_mm"] < closest.FORETOLD * heldout["calibrated_mm"]
    page = " ".join((path.parent / "verdict.txt").read_text().split())
    assert f"pipeline.simulate uses {' + '.join(ids)}" in page and "as a curve" in page and "no name" in page


@pytest.mark.long
def test_simulate_keeps_what_the_diagnosis_claims(unknown, tmp_path):
    folder, path, content = unknown
    done = programs.run("pipeline.simulate", folder, "--simulation", path, "--out", tmp_path / "out.csv")
    assert done.returncode == 0, done.stderr
    assert "comes closest and is no name: the verdict is unknown" in " ".join(done.stdout.split())
    residual = read_samples(folder)[1]["displacement_mm"] - pd.read_csv(tmp_path / "out.csv")["displacement_mm"]
    assert float(np.sqrt(np.mean(np.square(residual)))) == pytest.approx(
        content["fit"]["heldout"]["explained_mm"], rel=0.1
    )


@pytest.mark.long
def test_without_a_name_nothing_is_adopted(unknown, tmp_path):
    folder, path, _ = unknown
    copy = shutil.copytree(folder, tmp_path / folder.name)
    assert "stays as it is" in programs.run("pipeline.adopt", path, copy, "--sure").stdout
    assert (copy / "run.yaml").read_bytes() == (folder / "run.yaml").read_bytes()


@pytest.mark.parametrize(
    ("ids", "share", "errors", "predicts"),
    [
        (("creep",), 0.8, (1.0, 0.5), True),
        (("creep",), 0.7, (1.0, 0.5), False),  # takes less than half of the mismatch
        (("creep",), 0.8, (1.0, 0.8), False),  # does not keep it where it was not fitted
        (("creep", "x_wave"), 0.8, (1.0, 0.5), False),  # no physics takes a part of it
        ((), 0.8, (1.0, 0.5), False),
    ],
)
def test_what_may_predict_without_a_name(monkeypatch, ids, share, errors, predicts):
    monkeypatch.setattr(closest, "left_out_errors", lambda linear, sets: list(errors))
    monkeypatch.setattr(closest, "cancels", lambda problem, state: False)
    search = SimpleNamespace(linear=None, nothing=None, explain=lambda names: names)
    sets = [SimpleNamespace(ids=ids)] if ids else []
    study = SimpleNamespace(sets=sets, share=share, problem=None, best=None, search=search)
    assert closest.foretells(study) == predicts


def test_of_another_run_the_dimensions_alone_are_simulated():
    diagnosis = {"run": "a-1", "parameters": {"radius_mm": {"value": 0.5}}, "simulation": [], "closest": {
        "ids": ["creep"], "parameters": {"radius_mm": {"value": 0.6}}, "simulation": [{"id": "creep"}]}}  # fmt: skip
    own = to_simulate(diagnosis, "a-1")
    assert own["simulation"] == [{"id": "creep"}] and own["parameters"]["radius_mm"] == {"value": 0.6}
    assert said_of_no_name(own, "mm") and not said_of_no_name(diagnosis, "mm")
    assert said_of_no_name(own, "mm")[0].endswith("the verdict is unknown, and more is missing")
    alike = {**own, "fit": {"noise_floor_mm": 0.017, "heldout": {"explained_mm": 0.018}}}
    (at_noise,) = said_of_no_name(alike, "mm")
    assert "no fit had seen hardly more than the noise is left" in at_noise and "more is missing" not in at_noise
    assert to_simulate(diagnosis, "a-2") == diagnosis
