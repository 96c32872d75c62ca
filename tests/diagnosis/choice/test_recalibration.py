"""No name for a corner outside the recording, for what dimensions do as well, or for a strength of nothing."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import recalibration
from pipeline.diagnosis.fit import calibrate
from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.mechanisms.interface import Term
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.mechanisms.shared_laws import hinge
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study import engine
from pipeline.run.samples import read_samples

SLACK = {"take_up_turns": 14.5, "stop": 0.0, "softness": 0.05}


def never_below(problem, lowest):
    """The problem, its motion shifted to where it never comes below `lowest`."""
    drivers = problem.drivers
    return replace(problem, drivers=replace(drivers, motion=drivers.motion - drivers.motion.min() + lowest), _terms={})


@pytest.mark.parametrize(("lowest", "is_outside"), [(26.0, True), (0.0, False)])
def test_slack_that_is_taken_up_below_the_lowest_twist_is_no_name(problem, lowest, is_outside):
    moved = never_below(problem, lowest)
    terms = moved.terms(mechanisms()["slack"], SLACK)
    assert recalibration.outside(moved, terms) == is_outside
    state = replace(moved.nominal(), acts=(Act("slack", (SLACK,), (1.0,)),))
    dimensions = Linear(moved, moved.nominal(), white(1.0), {})
    assert recalibration.no_name(moved, state, dimensions) == (("outside", ("slack",)) if is_outside else None)


@pytest.mark.parametrize(("share", "is_outside"), [(-0.5, True), (0.5, False), (1.5, True)])
@pytest.mark.parametrize("port", ["twist", "length"])
def test_a_corner_of_ones_own_counts_inside_the_recording_alone(problem, port, share, is_outside):
    motion = problem.drivers.motion
    corner = motion.min() + share * np.ptp(motion)
    signal = hinge(motion, corner, 1e-3) if port == "twist" else (motion > corner).astype(float)
    assert recalibration.outside(problem, [Term("own", port, signal)]) == is_outside


def test_what_dimensions_do_as_well_is_no_name_and_what_they_may_not_is(problem):
    dimensions = Linear(problem, problem.nominal(), white(1.0), {})
    radius = dimensions.table[1] * dimensions.high[1]
    bump = 0.02 * np.std(radius) * np.sin(3.0 * problem.drivers.time_s)
    assert recalibration.only_calibration(radius, dimensions)
    assert not recalibration.only_calibration(9.0 * radius, dimensions)  # further than it may move
    assert not recalibration.only_calibration(radius + bump, dimensions)


@pytest.mark.parametrize(("times", "is_calibration"), [(400.0, False), (2500.0, True)])
def test_a_true_compaction_that_dimensions_take_back_but_for_a_400th_keeps_its_name(problem, times, is_calibration):
    dimensions = Linear(problem, problem.nominal(), white(1.0), {})
    columns = dimensions.table[dimensions.calibration].T
    wave = np.sin(3.0 * problem.drivers.time_s)
    own = wave - columns @ np.linalg.lstsq(columns, wave, rcond=1e-8)[0]  # what no dimension does
    radius = dimensions.table[1] * dimensions.high[1]
    size = np.sqrt(np.mean(radius**2) / np.mean(own**2)) / times
    assert recalibration.only_calibration(radius + size * own, dimensions) == is_calibration


@pytest.mark.long
def test_a_mechanism_that_refining_took_back_is_no_verdict(conceal, monkeypatch):
    run, samples = read_samples(conceal("creep")[0])
    refine = calibrate.refine
    silent = {"now": False}

    def to_nothing(problem, noise, state):
        state = refine(problem, noise, state)
        acts = tuple(replace(act, coefficients=(0.0,) * len(act.coefficients)) for act in state.acts)
        return replace(state, acts=acts) if silent["now"] else state

    def judged(*arguments):
        silent["now"] = True
        monkeypatch.setattr(calibrate, "calibrate", lambda problem, noise, state=None, acts=(): state)
        return real(*arguments)

    real = engine.judged
    monkeypatch.setattr(engine, "judged", judged)
    monkeypatch.setattr(calibrate, "refine", to_nothing)
    study = engine.study(engine.make_problem([RecordedRun.cut(run, samples)]))
    assert study.verdict == "unknown" and not study.best_ids and not study.sets


@pytest.mark.parametrize(
    ("port", "degree", "is_outside"),
    [
        ("twist", 0, True),
        ("twist", 1, True),
        ("twist", 2, False),
        ("radius", 0, True),
        ("radius", 1, False),
        ("length", 0, True),
        ("length", 1, False),
        ("sensor", 0, False),
    ],
)
def test_a_constant_or_on_the_twist_a_line_is_what_a_dimension_could_be(problem, port, degree, is_outside):
    term = Term("made", port, 1.0 + problem.drivers.motion**degree)
    assert recalibration.outside(problem, [term]) is is_outside
    assert not recalibration.outside(problem, [term, replace(term, signal=problem.drivers.motion**3)])
    assert not recalibration.outside(problem, [])


@pytest.mark.parametrize(("outside", "back"), [(True, False), (False, True), (False, False)])
def test_an_explanation_is_calibration_in_disguise_by_its_corner_or_by_its_whole_effect(monkeypatch, outside, back):
    """The effect of a mechanism that acts twice is the sum of both."""
    nonlinear = ("creep", 0), ("creep", 1)
    linear = SimpleNamespace(
        calibration=np.array([0]),
        catalogue={"creep": [{}, {}]},
        index={nonlinear[0]: np.array([1]), nonlinear[1]: np.array([2])},
        table=np.array([[9.0, 9.0], [1.0, 2.0], [10.0, 20.0]]),
        problem=SimpleNamespace(terms=lambda mechanism, nonlinear: []),
    )
    explanation = SimpleNamespace(keys=nonlinear, fit=SimpleNamespace(coefficients=np.array([7.0, 2.0, 3.0])))
    effects = []
    monkeypatch.setattr(recalibration, "outside", lambda problem, terms: outside)
    monkeypatch.setattr(recalibration, "only_calibration", lambda effect, dimensions: effects.append(effect) or back)
    why = "outside" if outside else "dimensions"
    assert recalibration.in_disguise(linear, explanation, None) == ((why, ("creep",)) if outside or back else None)
    assert outside or [effect.tolist() for effect in effects] == [[32.0, 64.0]]
