"""What named effects leave by the place goes into a drive's simulator, and names get fewer by it, never more."""

import json
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study import beside, engine, heldout, own_rate
from pipeline.rig.others import cases, made
from pipeline.run.samples import read_samples

SMALL_DEG = 0.3  # of an error by the place, too small to be suggested before anything is named


def recorded(tmp_path, case, seed, size_deg=0.0):
    """A recording of the other hand's cable drive, with an error added to the jaw that follows the place."""
    drawn = cases.make(case, seed)
    folder = tmp_path / drawn.run["run"]
    made.write_run(drawn, folder)
    run, samples = read_samples(folder)
    share = (samples["motor_deg"] - samples["motor_deg"].min()) / np.ptp(samples["motor_deg"])
    wrong_deg = size_deg * np.sin(3.0 * np.pi * share + 0.4)
    return folder, RecordedRun.cut(run, samples.assign(jaw_deg=samples["jaw_deg"] + wrong_deg))


def names(study):
    return [set(explanation.ids) for explanation in study.sets]


def quietly(_):
    return None


def test_a_name_that_only_bends_into_the_curve_goes(tmp_path):
    problem = engine.make_problem([recorded(tmp_path, "cable-friction-stretch", 602, SMALL_DEG)[1]])
    first, study = engine.with_homes(problem, quietly), engine.study(problem)
    assert {"clamp_slip", "friction_hysteresis"} in names(first)
    assert names(study)[0] == {"axial_elasticity", "friction_hysteresis"}
    assert not any("clamp_slip" in ids for ids in names(study)) and len(study.sets) < len(first.sets)
    assert [act.id for act in study.problem.beside] == ["x_transmission"]


@pytest.mark.parametrize("case", ["cable-friction", "cable-stretch", "cable-backlash", "cable-slip", "cable-creep"])
def test_a_drive_without_such_an_error_gets_none(tmp_path, case):
    assert engine.study(engine.make_problem([recorded(tmp_path, case, 312)[1]])).problem.beside == ()


def test_nothing_is_taken_of_what_is_unknown(tmp_path):
    study = engine.study(engine.make_problem([recorded(tmp_path, "cable-kink", 602)[1]]))
    assert study.verdict == "unknown" and study.problem.beside == ()


def test_it_names_no_more_than_before(tmp_path):
    problem = engine.make_problem([recorded(tmp_path, "cable-friction-stretch", 311, 0.15)[1]])
    first = engine.with_homes(problem, quietly)
    again = engine.with_homes(beside.with_stand_ins(first), quietly)
    assert len(again.sets) > len(first.sets) and not beside.clearer(again, first)
    assert names(engine.study(problem)) == [{"axial_elasticity", "friction_hysteresis"}]


@pytest.mark.long
def test_it_foretells_strokes_that_no_fit_has_seen(tmp_path):
    run = recorded(tmp_path, "cable-friction", 602, SMALL_DEG)[1]
    problem, fine = engine.make_problem([run]), own_rate.to_score([run])
    errors, study = heldout.held_out(problem, fine, own_rate.to_polish([run], fine))
    bare = replace(study.best, acts=tuple(act for act in study.best.acts if act not in study.problem.beside))
    unseen = fine.record.time_s >= errors["until_s"]
    residual = (fine.measured - fine.simulate(bare))[unseen]
    assert study.problem.beside and errors["chosen"] == ["friction_hysteresis"]
    assert errors["explained"] < 0.8 * float(np.std(residual))


def test_the_nominal_simulator_stays_that_of_run_yaml(tmp_path):
    problem = engine.make_problem([recorded(tmp_path, "cable-friction", 602, SMALL_DEG)[1]])
    study = engine.study(problem)
    assert study.problem.beside and study.nominal.acts == ()


@pytest.fixture(scope="module")
def diagnosed(tmp_path_factory):
    """The run, its page and its diagnosis, of the real program."""
    where = tmp_path_factory.mktemp("beside")
    folder, run = recorded(where, "cable-friction", 602, SMALL_DEG)
    path = next(path for path in folder.glob("recording.*"))
    table = run.samples
    if path.suffix == ".csv":
        table.to_csv(path, index=False)
    else:
        table.to_parquet(path)
    done = program("diagnose", folder, "--out", where / "out")
    return folder, done, where / "out" / folder.name / "diagnosis.json"


def program(name, *arguments):
    command = [sys.executable, "-m", f"pipeline.{name}", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=300).stdout


@pytest.mark.long
def test_the_page_says_that_it_is_no_name(diagnosed):
    _, page, path = diagnosed
    content = json.loads(path.read_text())
    assert [entry["id"] for entry in content["mechanisms"]] == ["friction_hysteresis"]
    assert [entry["id"] for entry in content["beside"]] == ["x_transmission"]
    assert [entry["id"] for entry in content["simulation"]] == ["friction_hysteresis", "x_transmission"]
    flowing = " ".join(page.split())
    assert "Also in the simulator, as a stand-in and no name, is x_transmission. The transmission errs" in flowing
    assert "same both ways: 0." in flowing and "adopted" not in flowing.partition("What to do")[0]


@pytest.mark.long
def test_adopted_it_leaves_nothing_to_name(diagnosed, tmp_path):
    folder, _, path = diagnosed
    assert "x_transmission: The transmission errs" in " ".join(program("adopt", path, folder).split())
    page = program("diagnose", folder, "--out", tmp_path)
    content = json.loads((tmp_path / folder.name / "diagnosis.json").read_text())
    assert content["verdict"] in ("consistent", "parameters") and "beside" not in content
    assert "a stand-in, no name" in page
