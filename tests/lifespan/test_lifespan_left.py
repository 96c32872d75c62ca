import numpy as np
import pytest
from made_life import worn

from pipeline.lifespan.forecast.futures_margin import later
from pipeline.lifespan.forecast.strokes_left import LEAST_STROKES, Left, first_passed, passages, strokes_left

N = np.arange(1.0, 61.0)


def noisy(values, size=1e-3, seed=0):
    return values + size * np.random.default_rng(seed).standard_normal(len(values))


def test_a_straight_life_ends_where_its_line_does():
    span = strokes_left(N, noisy(0.001 * N), 0.1).span(0.9)
    assert span.state in ("interval", "one-sided")
    assert span.low < 40 < span.high and span.median == pytest.approx(40, rel=0.2)


def test_levels_nest():
    forecast = strokes_left(N, noisy(0.001 * N), 0.1)
    wide, narrow = forecast.span(0.9), forecast.span(0.5)
    assert wide.low < narrow.low < narrow.median < narrow.high < wide.high


def test_few_strokes_give_no_claim():
    forecast = strokes_left(N[: LEAST_STROKES - 1], 0.001 * N[: LEAST_STROKES - 1], 0.1)
    assert forecast.span(0.9).state == "no claim" and str(LEAST_STROKES) in forecast.reason
    few = LEAST_STROKES - 3
    assert strokes_left(N[:few], noisy(0.001 * N[:few], 1e-4), 0.1, before=3).span(0.9).state != "no claim"


def test_noise_gives_a_lower_bound_and_is_named():
    for seed in range(10):
        forecast = strokes_left(N, noisy(0.0 * N, seed=seed), 0.1)
        assert (
            forecast.span(0.9).state in ("one-sided", "censored")
            and forecast.span(0.9).low > 100
            and not forecast.drifts
        )


def test_a_claim_begins_with_no_step_where_a_drift_leaves_the_noise():
    """A drift of 2.9 standard errors got no claim and one of 3.1 got one: the zero's last digits decided."""
    slopes = np.linspace(0.5e-5, 3e-5, 12)
    lefts = [strokes_left(N, noisy(slope * N, seed=3), 0.1) for slope in slopes]
    assert {forecast.drifts for forecast in lefts} == {False, True}
    lows = np.array([forecast.span(0.9).low for forecast in lefts])
    assert (lows > 0).all() and np.abs(np.diff(np.log(lows))).max() < 0.3


def test_the_later_futures_are_put_later_and_the_others_stay():
    when = np.array([1.0, 2.0, 4.0, 8.0, np.inf])
    assert later(when, 100.0, 2.0) == pytest.approx([1.0, 2.0, 4.0, 16.0, np.inf])
    assert later(when, 15.0, 2.0) == pytest.approx([1.0, 2.0, 4.0, np.inf, np.inf])
    never = np.array([1.0, np.inf, np.inf])
    assert (later(never, 10.0, 2.0) == never).all() and not len(later(np.zeros(0), 10.0, 2.0))
    own, wide = (strokes_left(N, noisy(0.001 * N), 0.1, power=power).span(0.9) for power in (1.0, 4.0))
    assert own.low == wide.low and own.median == wide.median and own.high < wide.high


def test_a_drift_that_settles_is_censored_at_the_horizon():
    forecast = strokes_left(N, noisy(-0.02 * np.expm1(-N / 5.0), 1e-4), 0.5)
    assert forecast.horizon == 10 * len(N)
    assert forecast.span(0.9).state == "censored" and forecast.span(0.9).low == forecast.horizon
    sure = forecast.span(0.98)  # which leaves no room for a sudden end
    assert sure.state == "one-sided" and sure.low < forecast.horizon and np.isinf(sure.high)


def test_a_limit_that_was_passed_is_told_with_its_stroke():
    forecast = strokes_left(N, noisy(0.004 * N), 0.1)
    assert forecast.span(0.9).state == "passed" and forecast.passed_at == pytest.approx(25, abs=1)


def test_one_wild_stroke_passes_no_limit():
    values = 0.001 * N
    values[30] = 1.0
    assert np.isnan(first_passed(N, values, 0.1))


def test_passages_are_where_paths_cross():
    ahead = np.array([0.0, 1.0, 2.0, 4.0])
    paths = np.array([[0.0, 1.0, 2.0, 4.0], [0.0, 0.0, 0.0, 0.0], [5.0, 5.0, 5.0, 5.0], [0.0, 3.0, 0.0, 0.0]])
    assert passages(paths, np.array([3.0, 3.0, 3.0, 1.5]), ahead) == pytest.approx([3.0, np.inf, 0.0, 0.5])


def test_the_same_strokes_give_the_same_answer():
    first, two = (strokes_left(N, noisy(0.001 * N), 0.1) for _ in "ab")
    assert (first.when == two.when).all()


def test_strokes_before_the_recording_do_not_change_the_answer():
    fresh_span, two = (strokes_left(N + before, noisy(0.001 * N), 0.1).span(0.9) for before in (0, 5000))
    assert fresh_span == two


def test_no_futures_no_claim():
    assert Left("why").span(0.9).state == "no claim"


@pytest.fixture(scope="module")
def lives():
    """Strokes left, true and as foretold, of strings whose wear follows none of the laws."""
    generator, pairs = np.random.default_rng(7), []
    while len(pairs) < 75:
        n, loss = worn(generator)
        past = np.flatnonzero(loss >= 0.1)
        if not len(past) or past[0] < 40:
            continue
        for share in (0.3, 0.6, 0.85):
            seen = int(share * past[0])
            if seen >= LEAST_STROKES:
                values = noisy(loss[:seen], seed=len(pairs))
                pairs.append((float(n[past[0]] - n[seen - 1]), strokes_left(n[:seen], values, 0.1, 5e-4)))
    return [(true, forecast) for true, forecast in pairs if len(forecast.when)]


def coverage(lives, level, narrowed=1.0):
    """Share of the lives whose end lies in the interval, its ends pulled towards the median by a factor."""
    covered = []
    for true, forecast in lives:
        span = forecast.span(level)
        low = span.median - narrowed * (span.median - span.low) if np.isfinite(span.median) else span.low / narrowed
        high = span.median + narrowed * (span.high - span.median) if np.isfinite(span.high) else forecast.horizon
        covered.append(low <= true <= high)
    return float(np.mean(covered))


@pytest.mark.long
def test_intervals_hold_as_often_as_they_say(lives):
    assert len(lives) > 50
    assert coverage(lives, 0.9) >= 0.8
    assert 0.35 <= coverage(lives, 0.5) <= 0.65


@pytest.mark.long
def test_half_as_wide_they_would_not(lives):
    assert coverage(lives, 0.9, 0.5) < 0.8 and coverage(lives, 0.5, 0.5) < 0.35
