"""Dimensions that a recording does not tell stay near to where they were measured, where what is left is no noise."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnosis.choice.judged import NOTHING
from pipeline.diagnosis.choice.outcome import Study, rms
from pipeline.diagnosis.fit import calibrate, intervals
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.study import polish, tempered

NOISE_MM = 0.005


def unknown(problem):
    """A study that calibrated and named nothing."""
    base, noise = calibrate.base(problem), white(NOISE_MM)
    return Study(
        problem, problem.nominal(), base, noise, "unknown", base, base, [], None, 0.0, 0.0, NOISE_MM, {}, 0.0, NOTHING
    )  # fmt: skip


def recorded(problem, structure_mm=0.0):
    """The problem as its nominal simulator would be recorded: with noise, and with what no dimension can explain."""
    draw, share = np.random.default_rng(3), problem.drivers.motion / np.ptp(problem.drivers.motion)
    wave = np.sin(3.0 * np.pi * share)  # alike in both directions, as what dimensions do is
    measured = problem.simulate(problem.nominal()) + draw.normal(0.0, NOISE_MM, len(problem.record))
    return replace(problem, measured=measured + structure_mm * wave)


def moved(study):
    """The farthest that a dimension was moved, in sigma."""
    problem = study.problem
    return max(
        abs(study.state.values[i] - problem.parameters[i].nominal) / problem.parameters[i].sigma
        for i in problem.movable
    )


def left(study):
    """What the simulator leaves of its own recording, rms, in mm."""
    return rms(study.problem.measured - study.problem.simulate(study.state))


def test_a_mean_of_correlated_samples_errs_by_more_than_their_variance_says():
    draw = np.random.default_rng(1).normal(0.0, 2.0, 40_000)
    assert tempered.long_run_variance(draw) == pytest.approx(4.0, rel=0.1)
    repeated = np.repeat(draw[:4000], 10)  # each says the same ten times
    assert tempered.long_run_variance(repeated) == pytest.approx(40.0, rel=0.15)
    assert tempered.long_run_variance(np.tile([1.0, -1.0], 50)) > 0.0


def test_where_what_is_left_is_noise_the_study_stays_as_it_is(one_load):
    problem = recorded(one_load[0])
    study = unknown(problem)
    assert tempered.too_sure(problem, study.noise, study.state) < 1.5
    assert tempered.tempered(study, problem) is study


def test_what_no_dimension_explains_moves_dimensions_less_and_hardly_shows(one_load):
    problem = recorded(one_load[0], structure_mm=0.1)
    study = unknown(problem)
    assert moved(study) > 1.0, "a fit that takes each sample for a witness goes far"
    after = tempered.tempered(study, problem)
    assert moved(after) < 0.5 * moved(study) and left(after) < 1.02 * left(study)
    assert after.state is after.base is after.best and after.verdict == study.verdict
    nominal = rms(problem.measured - problem.simulate(problem.nominal()))
    assert left(after) <= nominal * (1.0 + 1e-9), "calibration never makes it worse"


def test_its_intervals_are_no_narrower_than_the_fit_knows(one_load):
    problem = recorded(one_load[0], structure_mm=0.1)
    after = tempered.tempered(unknown(problem), problem)
    fit_intervals = intervals.intervals(problem, after.state, after.noise)
    wide = fit_intervals.at_least(after.spreads).parameters
    for index in problem.movable:
        parameter = problem.parameters[index]
        widened, before = wide[parameter.name], fit_intervals.parameters[parameter.name]
        assert widened.low <= before.low and widened.high >= before.high
        reach = intervals.Z90 * after.spreads[parameter.name]
        assert widened.low <= widened.value - reach and widened.high >= widened.value + reach, parameter.name
        assert 0.0 < after.spreads[parameter.name] <= parameter.sigma * (1.0 + 1e-9), "no farther than it was measured"


def test_an_explanation_stays_at_work_and_dimensions_give_way_to_nothing_else(studied, monkeypatch):
    study, *_ = studied("creep")
    monkeypatch.setattr(tempered, "TOO_SURE", 0.0)
    after = tempered.tempered(study, study.problem)
    assert [act.id for act in after.state.acts] == [act.id for act in study.state.acts]
    assert [act.nonlinear for act in after.state.acts] == [act.nonlinear for act in study.state.acts]
    assert after.base is study.base and after.best is after.state
    both = [rms(study.problem.measured - study.problem.simulate(each.state)) for each in (study, after)]
    assert both[1] == pytest.approx(both[0], rel=0.02)


def test_what_the_study_held_is_held_in_the_last_fit_too(one_load):
    free = recorded(one_load[0], structure_mm=0.1)
    first, *others = free.parameters
    study = unknown(replace(free, parameters=(replace(first, sigma=0.0), *others)))
    after = polish.polished(study, free)
    assert after is not study and after.state.values[0] == first.nominal
    assert tempered.tempered(study, free).state.values[0] != first.nominal, "which it would not be otherwise"
