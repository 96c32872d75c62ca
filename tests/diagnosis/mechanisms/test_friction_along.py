"""A cable's friction is wider where it wraps further: a loop that changes along the travel is friction's own."""

import numpy as np
import pytest

from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.fit import calibrate
from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.mechanisms import friction_hysteresis
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.rig.others import cases, made
from pipeline.run.samples import read_samples

NOISE_DEG = 0.04  # what the engine finds of it


def dahl(angle_deg, stiffness):
    """Dahl's friction, -1 to 1: another law than the library's stops."""
    state = np.zeros(len(angle_deg))
    for place, step in enumerate(np.diff(angle_deg), start=1):
        before = state[place - 1]
        state[place] = np.clip(before + stiffness * step * (1.0 - np.sign(step) * before), -1.0, 1.0)
    return state


@pytest.fixture(scope="module")
def wrapped(tmp_path_factory):
    """A cable drive without effects, to whose jaw friction is added that grows exponentially with the angle."""
    clean = cases.make("cable-nothing", 21)
    folder = tmp_path_factory.mktemp("raw") / clean.run["run"]
    made.write_run(clean, folder)
    run, samples = read_samples(folder)
    angle = samples["motor_deg"].to_numpy()
    share = (angle - angle.min()) / np.ptp(angle)
    lost = 0.25 * np.exp(1.5 * share) * dahl(angle, 0.3)
    return run, samples.assign(jaw_deg=samples["jaw_deg"] - lost), lost


def test_it_is_named_and_foretold_to_the_noise(wrapped):
    run, samples, lost = wrapped
    problem = make_problem([RecordedRun.cut(run, samples)])
    outcome = study(problem)
    assert outcome.sets[0].ids == ("friction_hysteresis",)
    residual_rms = rms(problem.measured - problem.simulate(outcome.best))
    assert residual_rms < 1.2 * outcome.noise.floor < 0.2 * rms(lost)


def test_the_same_loop_without_its_travel_leaves_more_than_twice_the_noise(wrapped, monkeypatch):
    monkeypatch.setattr(friction_hysteresis, "travelled", lambda drivers: {})
    run, samples, _ = wrapped
    problem = make_problem([RecordedRun.cut(run, samples)])
    state, rms_values = calibrate.base(problem), []
    for nonlinear in friction_hysteresis.candidates(problem.drivers):
        nothing = (0.0,) * len(friction_hysteresis.terms(problem.drivers, nonlinear))
        act = Act("friction_hysteresis", (nonlinear,), nothing)
        fitted = calibrate.calibrate(problem, white(NOISE_DEG), state, (act,))
        rms_values.append(rms(problem.measured - problem.simulate(fitted)))
    assert min(rms_values) > 2.0 * NOISE_DEG
