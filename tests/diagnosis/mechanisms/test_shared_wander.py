"""A zero that wanders without a law: it follows no stroke, and nothing leaps away behind the last sample seen."""

from dataclasses import replace

import numpy as np

from pipeline.diagnosis.fit.calibrate import calibrate
from pipeline.diagnosis.fit.problem import Act, Problem
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.mechanisms.shared_wander import half_waves, passed, wandering
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.study.heldout import first_held_out


def wander_mm(problem: Problem, seed: int) -> np.ndarray:
    """A random walk of half a millimetre over the whole recording, smoothed."""
    steps = np.random.default_rng(seed).standard_normal(len(problem.record))
    walk = problem.drivers.smooth(np.cumsum(steps)) / np.sqrt(len(steps))
    return 0.5 * (walk - walk[0])


def test_a_wander_makes_no_more_half_waves_than_a_fit_sees_strokes(problem: Problem) -> None:
    law = {"whole_s": 1.0}
    strokes = int(problem.record.stroke.max())
    assert strokes > 4 and wandering(problem.drivers, law) == [{**law, "half_waves": min(8.0, strokes)}]
    second, third = (int(np.argmax(problem.record.stroke == stroke)) for stroke in (2, 3))
    assert wandering(problem.until(second).drivers, law) == []
    assert wandering(problem.until(third).drivers, law) == [{**law, "half_waves": 2.0}]


def test_a_law_goes_on_behind_what_was_seen_and_a_wander_stays(problem: Problem) -> None:
    rows = len(problem.record) // 2
    seen = problem.until(rows).drivers
    law = {"whole_s": seen.seen_s}
    assert abs(seen.seen_s - seen.elapsed_s[rows - 1]) < 1e-4 * seen.seen_s and passed(seen, law)[-1] > 1.5
    share_passed = passed(seen, {**law, "half_waves": 4.0})
    assert np.all(share_passed[rows:] == 1.0) and np.allclose(share_passed[:rows], passed(seen, law)[:rows])
    waves = half_waves(share_passed, {**law, "half_waves": 4.0}, 2)
    assert list(waves) == [2, 3, 4] and all(np.ptp(wave[rows:]) == 0.0 < np.ptp(wave[:rows]) for wave in waves.values())


def test_a_drift_without_a_law_errs_behind_what_was_seen_by_no_more_than_it_moves(problem: Problem) -> None:
    """Fitted to waves over all that was recorded, most of which it never saw, it went hundreds of millimetres away."""
    row = first_held_out(problem)
    assert row is not None
    for seed in range(5):
        wander = wander_mm(problem, seed)
        drifting = replace(problem, measured=problem.simulate(problem.nominal()) + wander).until(row)
        (waves,) = (each for each in mechanisms()["sensor_drift"].candidates(drifting.drivers) if "half_waves" in each)
        count = len(drifting.terms(mechanisms()["sensor_drift"], waves))
        drift = Act("sensor_drift", (waves,), (0.0,) * count)
        state = calibrate(drifting, white(0.01), drifting.nominal(), (drift,))
        error = drifting.measured - drifting.simulate(state)
        assert np.std(error[:row]) < 0.1, seed
        assert np.abs(error[row:]).max() < 2.0 * np.ptp(wander), seed
