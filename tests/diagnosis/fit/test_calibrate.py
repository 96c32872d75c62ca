"""Calibration takes no step that makes it worse, on a rig whose roots lead whole steps astray."""

import numpy as np
import pytest
import tanks
from first_few import first_few

from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.fit import calibrate, gauss_newton
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem


def left(problem, state):
    """What a simulator leaves, rms."""
    return rms(problem.measured - problem.simulate(state))


@pytest.mark.parametrize("seed", first_few([2, 5, 6]))
def test_calibration_reaches_the_noise_where_whole_steps_diverge(seed):
    """Whole steps leave .50, .89 and .89 V; the second is more than the nominal simulator leaves."""
    guess = np.exp(np.random.default_rng(seed).normal(0.0, 0.25, 6))
    run, samples = tanks.recorded(guess, seed)
    problem = make_problem([RecordedRun.cut(run, samples)])
    base = calibrate.base(problem)
    assert left(problem, base) < 1.1 * tanks.NOISE_V < left(problem, problem.nominal())
    for parameter, value in zip(problem.parameters, base.values, strict=True):
        assert abs(value - parameter.nominal) <= 3.0 * parameter.sigma * (1.0 + 1e-9), parameter.name


def test_a_step_that_raises_the_misfit_is_made_shorter_and_one_that_cannot_be_is_not_made(monkeypatch):
    guess = np.exp(np.random.default_rng(5).normal(0.0, 0.25, 6))
    run, samples = tanks.recorded(guess, 5)
    problem = make_problem([RecordedRun.cut(run, samples)])
    noise = white(1.0)
    good = calibrate.calibrate(problem, noise)
    assert gauss_newton.misfit_of(problem, noise, good) < gauss_newton.misfit_of(problem, noise, problem.nominal())
    own, real = problem.nominal().values, gauss_newton.misfit_of
    monkeypatch.setattr(
        gauss_newton, "misfit_of", lambda *arguments: real(*arguments) if (arguments[2].values == own).all() else np.inf
    )
    assert (calibrate.calibrate(problem, noise).values == own).all()
