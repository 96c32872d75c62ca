"""A regression without physics says how much of unseen strokes could be foretold, and the verdict says it."""

import json
from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnose import Options, diagnose
from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.fit.calibrate import base
from pipeline.diagnosis.fit.flexible import foretold
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem
from pipeline.diagnosis.study.heldout import first_held_out, quick
from pipeline.run.samples import read_samples

DIRECTED = ("friction_hysteresis", "backlash", "viscous_loss", "sensor_lag", "stick_slip", "x_clock", "load_swing")


@pytest.fixture
def rig(conceal):
    """The problem of a run, its calibrated state, and the rows that are held out."""
    run, samples = read_samples(conceal("friction_hysteresis")[0])
    problem = make_problem([RecordedRun.cut(run, samples)])
    row = first_held_out(problem)
    return problem, base(problem.until(row)), problem.record.time_s >= problem.record.time_s[row]


def test_what_the_regression_adds_lowers_the_error_of_unseen_strokes_and_follows_what_it_should(rig):
    problem, state, unseen = rig
    regression = foretold(problem, problem, state, unseen)
    residual = problem.measured - problem.simulate(state)
    assert rms((residual - regression.added)[unseen]) < 0.6 * rms(residual[unseen])
    assert regression.driver == "direction"
    first, last = regression.location["strokes"]
    assert problem.record.stroke[unseen].min() <= first <= last <= problem.record.stroke.max()


def test_the_regression_sees_nothing_of_the_strokes_that_are_held_out(rig):
    problem, state, unseen = rig
    spoiled = replace(problem, measured=np.where(unseen, 1e3, problem.measured))
    unspoiled, spoiled_ = (foretold(each, problem, state, unseen).added for each in (problem, spoiled))
    np.testing.assert_array_equal(unspoiled, spoiled_)


def test_noise_from_sample_to_sample_counts_no_slower_structure(rig):
    problem, state, unseen = rig
    rng = np.random.default_rng(3)
    noise = 0.01 * rng.standard_normal(len(problem.measured))
    slow = 0.5 * np.sin(problem.record.time_s)
    noisy_problem = replace(problem, measured=problem.simulate(state) + slow + noise)
    assert quick(noisy_problem, state, unseen) == pytest.approx(0.01, rel=0.15)


@pytest.mark.long
def test_a_mismatch_that_no_mechanism_explains_is_said_with_the_level_that_physics_has_to_reach(
    conceal, remembered, tmp_path
):
    with remembered():
        words = diagnose([conceal("friction_hysteresis")[0]], tmp_path / "out", Options(without=frozenset(DIRECTED)))
    content = json.loads((tmp_path / "out" / "diagnosis.json").read_text())
    heldout = content["fit"]["heldout"]
    assert heldout["without_physics_mm"] < 0.95 * heldout["explained_mm"]
    assert content["evidence"]["left_of_unseen"]["driver"] == "direction"
    text = " ".join(words.split())
    assert "A regression without physics (boosted trees over all that was recorded)" in text
    level = (
        "That is the level which physics still has to reach" if content["verdict"] == "unknown" else "better than the"
    )
    assert level in text and "it follows the direction of motion" in text


@pytest.mark.long
def test_a_recording_that_is_explained_to_its_noise_asks_no_regression(conceal, remembered, tmp_path):
    with remembered():
        diagnose([conceal("creep")[0]], tmp_path / "out")
    content = json.loads((tmp_path / "out" / "diagnosis.json").read_text())
    assert "without_physics_mm" not in content["fit"]["heldout"] and "left_of_unseen" not in content["evidence"]
