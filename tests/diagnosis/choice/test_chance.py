"""What is known of effects that move at random: that they are there, how large, and when."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import chance

STEP_S, ROWS = 0.05, 2000


def made(residual, rate=None, library=None, rows=ROWS):
    """A problem whose simulator says nothing, so that what is measured is left; it moves throughout unless told."""
    drivers = SimpleNamespace(rate=np.ones(len(residual)) if rate is None else rate, step_s=STEP_S)
    return SimpleNamespace(
        measured=np.asarray(residual), simulate=lambda state: np.full(len(residual), float(state or 0.0)), rows=rows,
        drivers=drivers, library=library or {}, terms=lambda mechanism, nonlinear: [mechanism] * nonlinear["terms"],
    )  # fmt: skip


def test_what_a_residual_shows_is_asked_of_each_mechanism_of_the_library():
    calls = []
    library = {
        "stick_slip": SimpleNamespace(random=lambda *arguments: calls.append(arguments) or {"terms": 2}),
        "creep": SimpleNamespace(random=lambda *arguments: None),
    }
    problem = made([3.0, 4.0, 9.0], library=library, rows=2)
    assert chance.seen(problem, 1.0) == {"stick_slip": {"terms": 2}}
    ((drivers, residual, predicted),) = calls
    assert drivers is problem.drivers and residual.tolist() == [2.0, 3.0] and predicted.tolist() == [1.0, 1.0]


def test_a_random_effect_adds_nothing_to_the_simulator():
    act = chance.act(made([0.0]), "stick_slip", {"terms": 2})
    assert (act.id, act.nonlinear, act.coefficients) == ("stick_slip", ({"terms": 2},), (0.0, 0.0))


def resting(rests, noise=0.1, moving=1.0, of_rest=0.0):
    """A residual of noise, louder where it moves, and the rate; each rest stands elsewhere by 3 mm and more."""
    draw = np.random.default_rng(3)
    rate, residual = np.full(ROWS, -2.0), moving * draw.standard_normal(ROWS)
    for number, (start, end) in enumerate(rests):
        rate[start:end] = of_rest
        residual[start:end] = 3.0 * number + noise * draw.standard_normal(end - start)
        residual[[start, start + 1, end - 2, end - 1]] = 50.0  # it comes to rest, and leaves
    return residual, rate


def expected(residual, rests):
    """The spread within rests, each about its mean, but for two samples at either end."""
    parts = [residual[start + 2 : end - 2] for start, end in rests]
    return np.sqrt(sum(np.sum((part - part.mean()) ** 2) for part in parts) / sum(len(part) - 1 for part in parts))


@pytest.mark.parametrize("of_rest", [0.0, 0.019, -0.019])
def test_the_floor_at_rest_is_the_spread_about_the_mean_of_each_rest(of_rest):
    rests = [(100, 140), (500, 560), (900, 930)]
    residual, rate = resting(rests, of_rest=of_rest)
    assert chance.floor_at_rest(made(residual, rate), 0.0, 9.0) == pytest.approx(expected(residual, rests))
    assert chance.floor_at_rest(made(residual, rate), 0.0, 0.05) == 0.05  # never louder than is known


def test_a_slow_motion_is_no_rest():
    residual, rate = resting([(100, 200)], of_rest=0.021)
    assert chance.floor_at_rest(made(residual, rate), 0.0, 9.0) == 9.0


@pytest.mark.parametrize(
    ("rests", "counted"),
    [
        ([(100, 120), (300, 360)], [(100, 120), (300, 360)]),  # a second is just a rest
        ([(100, 119), (300, 360)], [(300, 360)]),  # less is none
        ([(300, 356)], [(300, 356)]),  # 51 samples beside the mean
        ([(300, 355)], []),
    ],
)
def test_short_rests_and_few_samples_tell_no_floor(rests, counted):
    residual, rate = resting(rests)
    wanted = expected(residual, counted) if counted else 9.0
    assert chance.floor_at_rest(made(residual, rate), 0.0, 9.0) == pytest.approx(wanted)


@pytest.mark.parametrize(("length", "is_rest"), [(10, False), (11, True)])
def test_of_slow_samples_a_rest_needs_more_than_ten(length, is_rest):
    rests = [(100 * number, 100 * number + length) for number in range(1, 15)]
    residual, rate = resting(rests)
    problem = made(residual, rate)
    problem.drivers.step_s = 1.0
    wanted = expected(residual, rests) if is_rest else 9.0
    assert chance.floor_at_rest(problem, 0.0, 9.0) == pytest.approx(wanted)


def test_a_rate_beyond_the_rows_that_are_seen_counts_nothing():
    residual, rate = resting([(100, 200)], of_rest=0.015)
    rate[1500:] = -0.1
    assert chance.floor_at_rest(made(residual, rate, rows=1400), 0.0, 9.0) < 0.2
    rate[1500:] = 900.0
    assert chance.floor_at_rest(made(residual, rate, rows=1400), 0.0, 9.0) < 0.2


def test_the_size_of_a_residual_is_what_it_has_beyond_its_rests():
    rests = [(100, 400)]
    residual, rate = resting(rests)
    wanted = np.sqrt(np.var(residual) - expected(residual, rests) ** 2)
    large = {"stick_slip": {"reach_mm": 1.0}}
    assert chance.size(made(residual, rate), 0.0, large) == pytest.approx(wanted)
    assert chance.size(made(residual, np.ones(ROWS)), 0.0, large) == 0.0  # nobody saw it at rest
    assert chance.size(made(residual, rate), 0.0, {}) == 0.0
    small = {"stick_slip": {"reach_mm": 0.01}}
    assert chance.size(made(residual, rate), 0.0, small) == pytest.approx(0.1), "no more than jerks so small make"


@pytest.mark.parametrize(("step_s", "width"), [(0.05, 20), (0.5, 5)])
def test_when_a_random_effect_was_at_work_is_told_from_second_to_second(step_s, width):
    problem = made(np.where(np.arange(ROWS) == 1000, 5.0, 0.0))
    problem.drivers.step_s = step_s
    trace = chance.trace(problem, 0.0, 1.0)
    at = np.flatnonzero(trace)
    assert trace.shape == (ROWS,) and len(at) == width and abs(at.mean() - 1000) <= 1
    assert trace[at] == pytest.approx(np.sqrt(25.0 / width - 1.0) if width == 20 else 2.0)
