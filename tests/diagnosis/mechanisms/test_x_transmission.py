"""An error of a drive's transmission follows the place both ways: a stand-in that leaves friction its name."""

import numpy as np
import pytest

from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.fit import calibrate
from pipeline.diagnosis.mechanisms import x_transmission
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.rig.others import cases, made
from pipeline.run.samples import read_samples


def recorded(tmp_path, case, seed, added=lambda share: 0.0 * share):
    """A case of the other hand, with an error added to the jaw that follows the share of the travel."""
    drawn = cases.make(case, seed)
    folder = tmp_path / drawn.run["run"]
    made.write_run(drawn, folder)
    run, samples = read_samples(folder)
    angle = samples["motor_deg"].to_numpy()
    wrong_deg = added((angle - angle.min()) / np.ptp(angle))
    return make_problem([RecordedRun.cut(run, samples.assign(jaw_deg=samples["jaw_deg"] + wrong_deg))])


def wavy(share):
    """Half a degree to and fro, one and a half times along the travel."""
    return 0.5 * np.sin(3.0 * np.pi * share + 0.4)


@pytest.mark.parametrize("seed", [311, 312, 602])
def test_alone_it_is_no_name_whatever_else_could_pass_for_a_bump_at_one_angle(tmp_path, seed):
    outcome = study(recorded(tmp_path, "cable-kink", seed))
    assert outcome.verdict == "unknown" and "x_transmission" in outcome.best_ids


def test_beside_stretch_it_takes_what_stretch_left_to_the_noise(tmp_path):
    problem = recorded(tmp_path, "cable-stretch", 21, wavy)
    outcome = study(problem)
    assert outcome.verdict == "explained"
    assert outcome.best_ids == ("axial_elasticity", "x_transmission")
    assert rms(problem.measured - problem.simulate(outcome.best)) < 1.2 * outcome.floor


@pytest.mark.parametrize("case", ["cable-friction", "cable-backlash", "cable-lag", "cable-creep", "cable-slip"])
def test_no_recording_without_it_suggests_it(tmp_path, case):
    problem = recorded(tmp_path, case, 311)
    residual = problem.measured - problem.simulate(calibrate.base(problem))
    assert x_transmission.suggest(problem.drivers, residual, problem.measured - residual) == []


def test_its_curve_is_neither_a_zero_nor_a_gear(tmp_path):
    problem = recorded(tmp_path, "cable-nothing", 311)
    residual = problem.measured - problem.simulate(calibrate.base(problem))
    begin, span = problem.drivers.motion.min(), problem.drivers.span
    knots = begin + span * np.linspace(0.0, 1.0, x_transmission.KNOTS)
    assert len(residual) and x_transmission.suggest(problem.drivers, residual, problem.measured - residual) == []
    places = np.argmin(np.abs(problem.drivers.motion[:, None] - knots), axis=0)
    curves = np.array(x_transmission.curve(problem.drivers, {"from_turns": begin, "span_turns": span}))[:, places]
    straight = np.vstack([np.ones(len(knots)), np.linspace(0.0, 1.0, len(knots))])
    assert np.abs(curves @ straight.T).max() < 0.1 * np.abs(curves).max()
