"""The baselines: what each names, that none looks at the strokes held out, and what is written."""

import json
import re
import sys
from dataclasses import replace

import numpy as np
import pytest
from first_few import first_few

from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, rms
from pipeline.diagnosis.study.heldout import first_held_out
from pipeline.diagnosis.study.own_rate import at_own_rate
from pipeline.proof.baselines import __main__ as command
from pipeline.proof.baselines.driver_columns import products, stands_for
from pipeline.proof.baselines.frozen import frozen
from pipeline.proof.baselines.learnt import Calibrated, Learnt, calibrated, held_out_mm
from pipeline.proof.case import draw_case, performed
from pipeline.proof.conceal import write_run
from pipeline.run.samples import read_samples


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A recording in which friction hides, three noise floors of it."""
    path = tmp_path_factory.mktemp("raw") / "friction"
    case = draw_case(5, "single", "rich", ["friction_hysteresis"], [3.0])
    write_run(case.bench.described("friction", not case.load_cell), performed(case).table, path)
    return path


@pytest.fixture(scope="module")
def problem(folder):
    run, samples = read_samples(folder)
    return make_problem([RecordedRun.cut(run, samples, folder=folder)])


@pytest.fixture(scope="module")
def seen(problem):
    return calibrated(problem)


def leaving(seen, residual_mm):
    """The same calibration of a recording that leaves this residual."""
    measured = seen.problem.simulate(seen.state) + residual_mm
    return Calibrated(replace(seen.problem, measured=measured), seen.state)


def test_every_term_of_the_sparse_regression_stands_for_a_mechanism(problem):
    warm = replace(problem.drivers, temperature_c=problem.drivers.elapsed_s)
    columns = {**products(replace(problem.drivers, temperature_c=None)), **products(warm)}
    for name in columns:
        for sign in (-1.0, 1.0):
            assert len(stands_for(name, sign)) == 1, f"{name}: two mechanisms' files ask for it, or none does"
    wanted = {re.sub(", (more|less)$", "", name) for mechanism in mechanisms().values() for name in mechanism.columns}
    assert wanted == set(columns), "a column of no driver"


def test_a_mechanism_that_is_added_has_its_columns_by_its_own_file_alone(seen, monkeypatch):
    """They were listed, by mechanism, in a file of the methods."""
    noise = 0.02 * np.random.default_rng(0).standard_normal(len(seen.problem.record))
    added = {
        id_: replace(mechanisms()["wear"], id=id_, columns=(f"rate x time, {sign}",))
        for id_, sign in (("x_up", "more"), ("x_down", "less"))
    }
    library = {**mechanisms(), **added}
    monkeypatch.setattr("pipeline.proof.baselines.driver_columns.mechanisms", lambda: library)
    drivers = seen.problem.drivers
    follows = drivers.rate * drivers.elapsed_s / np.std(drivers.rate * drivers.elapsed_s)
    for weight, name in ((0.5, "x_up"), (-0.5, "x_down")):
        assert command.method("residual_sindy")(leaving(seen, weight * follows + noise)).named == [name]


@pytest.mark.parametrize(
    ("term", "weight", "name"),
    [
        ("direction x load", 0.05, "friction_hysteresis"),
        ("high twist", 0.05, "overtwist"),
        ("high twist", -0.05, "jam"),
        ("cosine of the turn", 0.1, "eccentricity"),
    ],
)
def test_sparse_regression_names_the_driver_that_a_residual_follows(seen, term, weight, name):
    noise = 0.02 * np.random.default_rng(0).standard_normal(len(seen.problem.record))
    learnt = command.method("residual_sindy")(leaving(seen, weight * products(seen.problem.drivers)[term] + noise))
    assert learnt.named == [name]


@pytest.mark.parametrize("name", ["residual_sindy", "frozen_fit"])
def test_white_noise_has_no_name(seen, name):
    noise = 0.02 * np.random.default_rng(0).standard_normal(len(seen.problem.record))
    assert command.method(name)(leaving(seen, noise)).named == []


def test_a_frozen_fit_moves_no_dimension_and_names_what_is_left(seen):
    drivers = seen.problem.drivers
    slip_mm = np.where(drivers.elapsed_s > 0.4 * drivers.elapsed_s[-1], 0.5, 0.0)
    noise = 0.02 * np.random.default_rng(0).standard_normal(len(slip_mm))
    slipped = leaving(seen, slip_mm + noise)
    learnt = command.method("frozen_fit")(slipped)
    assert learnt.named == ["clamp_slip"]
    adds_mm = learnt.adds_mm(seen.problem)
    assert rms(adds_mm - slip_mm) < 0.05 * rms(slip_mm)
    assert frozen(seen.problem, seen.state).movable == []


def test_the_methods_are_the_files_that_learn():
    """Every one that was ever compared is found, and what they share is none."""
    ever = {"residual_sindy", "frozen_fit", "gradient_boosting", "gaussian_process"}
    assert ever <= set(command.names()) and not {"features", "frozen", "learnt", "__main__"} & set(command.names())


@pytest.mark.parametrize("name", first_few(command.names(), 2))
def test_no_method_looks_at_the_strokes_held_out(problem, name):
    row = first_held_out(problem)
    part = calibrated(problem.until(row))
    later = np.arange(len(problem.record)) >= row
    other = replace(part.problem, measured=part.problem.measured + 5.0 * later)
    learn = command.method(name)
    same, changed = (learn(variant).adds_mm(problem) for variant in (part, replace(part, problem=other)))
    assert same.shape == (len(problem.record),)
    np.testing.assert_array_equal(same, changed)


def test_trees_interpolate_what_a_calibration_leaves(seen):
    learnt = command.method("gradient_boosting")(seen)
    assert learnt.named is None
    assert rms(seen.residual_mm - learnt.adds_mm(seen.problem)) < 0.5 * rms(seen.residual_mm)


def test_without_a_correction_the_error_is_the_calibrated_simulators(folder, problem):
    run, samples = read_samples(folder)
    fine = at_own_rate([RecordedRun.cut(run, samples)])
    nothing = Learnt(None, lambda other: np.zeros(len(other.record)))
    base_mm = held_out_mm(lambda seen: nothing, problem, fine)
    off_mm = held_out_mm(lambda seen: replace(nothing, adds_mm=lambda other: np.ones(len(other.record))), problem, fine)
    assert 0.0 < base_mm < 0.5 < off_mm


@pytest.mark.long
def test_the_command_writes_what_each_method_says(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["baselines", str(folder), "--out", str(tmp_path)])
    with pytest.raises(SystemExit) as exit_info:
        command.main()
    assert not exit_info.value.code
    saved = json.loads((tmp_path / "friction" / "baselines.json").read_text())
    assert saved.pop("run") == "friction"
    assert set(saved) == set(command.names())
    for name, entry in saved.items():
        assert set(entry) == {"named", "heldout_mm", "seconds"}
        assert entry["heldout_mm"] > 0.0
        assert (entry["named"] is None) == (name in ("gradient_boosting", "gaussian_process"))
