"""Intervals hold what they say, on made strings with known noise; what they cannot know they flag."""

import numpy as np
import pandas as pd
import pytest
from made_strings import NOISE_MM, made_string

from pipeline.models.interface import make_model
from pipeline.models.parts.questions.prediction_intervals import Intervals, TooFew
from pipeline.models.parts.questions.unanswered import reasons
from pipeline.models.parts.rolling_origin import AHEAD, parts_of

STRINGS, KNOWN, LEVEL = 48, 7, 0.9
MAPS = {"forward": "displacement_mm", "inverse": "motor_turns"}


def fitted(points):
    intervals = Intervals(lambda: make_model("polynomial"))
    intervals.fit(points[points["stroke"] <= KNOWN].reset_index(drop=True), 0)
    return intervals


@pytest.fixture(scope="module")
def string_fit():
    """One string, its intervals fitted without its last two strokes."""
    points = made_string(0)
    return points, fitted(points)


@pytest.fixture(scope="module")
def forecasts():
    """Every string's points of the strokes to come, with their intervals, of both maps."""
    rows = []
    for number in range(STRINGS):
        points = made_string(number, seed=5)
        intervals, ahead = fitted(points), points[points["stroke"] > KNOWN]
        for map_, column in MAPS.items():
            bounds = getattr(intervals, map_)(ahead.assign(**{column: np.nan}), LEVEL)
            rows.append(bounds.assign(map=map_, truth=ahead[column].to_numpy(), string=number))
    return pd.concat(rows, ignore_index=True)


def held(bounds, factor=1.0):
    """Share of the points inside the box within the interval, its half width taken times a factor."""
    inside_rows = bounds[bounds["inside"]]
    half = factor * (inside_rows["high"] - inside_rows["value"])
    return float(((inside_rows["truth"] - inside_rows["value"]).abs() <= half).mean())


@pytest.mark.long  # 48 strings; test_more_strokes_ahead_... looks at eight
@pytest.mark.parametrize("map_", MAPS)
def test_of_strokes_to_come_nine_in_ten_are_held(forecasts, map_):
    map_forecasts = forecasts[forecasts["map"] == map_]
    assert map_forecasts["inside"].mean() > 0.9
    assert held(map_forecasts) == pytest.approx(LEVEL, abs=0.02)
    assert held(map_forecasts, 0.8) < LEVEL - 0.02  # so intervals a fifth too narrow would be seen
    assert held(map_forecasts, 1.25) > LEVEL + 0.02


def test_more_strokes_ahead_and_higher_levels_are_wider():
    widths = []
    for number in range(8):
        points = made_string(number, walk_mm=0.05)
        intervals = fitted(points)
        last = points[points["stroke"] == KNOWN].assign(displacement_mm=np.nan)
        bounds_ahead = [intervals.forward(last.assign(stroke=KNOWN + ahead), LEVEL) for ahead in range(AHEAD + 1)]
        beyond = intervals.forward(last.assign(stroke=KNOWN + AHEAD + 1), LEVEL)
        assert np.isinf(beyond["high"]).all() and not beyond["inside"].any() and np.isfinite(beyond["value"]).all()
        widths.append([float((bounds["high"] - bounds["low"]).median()) for bounds in bounds_ahead])
        assert np.isfinite(widths[-1]).all() and (np.diff(widths[-1]) >= -1e-12).all()  # a sum is rounded
        narrow, wide = (intervals.inverse(points[points["stroke"] == 8], level) for level in (0.5, 0.95))
        inside = wide["inside"] & narrow["inside"]
        wide_only = wide["inside"] & ~narrow["inside"]  # contractions beyond both ends by more than the narrower width
        assert wide_only.sum() < 5 and set(narrow["value"][wide_only]) <= set(np.ravel(intervals.turns(points[:1])))
        assert inside.sum() > 50 and (wide["high"] > narrow["high"])[inside].all()
        assert (wide["low"] < narrow["low"])[inside].all()
    middle = np.median(widths, axis=0)
    assert middle[AHEAD] > 1.3 * middle[0]


def test_among_seen_strokes_the_width_is_that_of_the_noise(string_fit):
    points, intervals = string_fit
    bounds = intervals.forward(points[points["stroke"] == 4], LEVEL)
    assert float((bounds["high"] - bounds["value"]).median()) == pytest.approx(1.645 * NOISE_MM, rel=0.2)


@pytest.mark.parametrize(
    "strange",
    [{"motor_turns": 30.0}, {"load_n": 25.0}, {"radius_mm": 0.5}, {"stroke": 0}, {"motor_turns": np.nan}],
    ids=lambda strange: f"{next(iter(strange))} {next(iter(strange.values()))}",
)
def test_what_lies_outside_the_box_is_flagged_and_gets_no_interval(string_fit, strange):
    points, intervals = string_fit
    questions = points[points["stroke"] == 3].reset_index(drop=True)
    for name, value in strange.items():
        questions[name] = questions[name].mask(questions.index < 5, value)
    bounds = intervals.forward(questions, LEVEL)
    assert not bounds["inside"][:5].any() and bounds["inside"][5:].all()
    if not np.isnan(next(iter(strange.values()))):
        assert np.isneginf(bounds["low"][:5]).all() and np.isposinf(bounds["high"][:5]).all()
    assert np.isfinite(bounds[5:][["low", "high"]]).all().all()


def test_a_contraction_never_reached_and_one_that_is_missing_are_flagged(string_fit):
    points, intervals = string_fit
    questions = points[points["stroke"] == 3].assign(motor_turns=np.nan).reset_index(drop=True)
    questions.loc[:4, "displacement_mm"] = [500.0, -500.0, np.inf, -np.inf, np.nan]
    bounds = intervals.inverse(questions, LEVEL)
    assert not bounds["inside"][:5].any() and bounds["inside"][5:].all()
    assert np.isneginf(bounds["low"][:2]).all() and np.isposinf(bounds["high"][:2]).all()


def test_the_same_points_give_the_same_intervals(string_fit):
    points, intervals = string_fit
    again, ahead = fitted(points), points[points["stroke"] > KNOWN]
    for map_ in MAPS:
        pd.testing.assert_frame_equal(getattr(intervals, map_)(ahead, LEVEL), getattr(again, map_)(ahead, LEVEL))


def test_of_too_few_strokes_nothing_is_said_about_those_to_come():
    points = made_string(1)
    few = points[points["stroke"] <= 3].reset_index(drop=True)
    intervals = Intervals(lambda: make_model("polynomial"))
    intervals.fit(few, 0)
    bounds = intervals.forward(points[points["stroke"] == 4], LEVEL)
    assert np.isposinf(bounds["high"]).all() and np.isneginf(bounds["low"]).all()
    assert np.isfinite(intervals.forward(few, LEVEL)[["low", "high"]]).all().all()


def test_strokes_are_counted_for_each_string_and_an_unseen_string_gets_no_interval():
    long, short = made_string(2, walk_mm=0.05), made_string(3, walk_mm=0.05)
    points = pd.concat([long[long["stroke"] <= 8], short[short["stroke"] <= 5]], ignore_index=True)
    intervals = Intervals(lambda: make_model("polynomial"))
    intervals.fit(points, 0)
    questions = long[long["stroke"] == 8].assign(displacement_mm=np.nan)
    seen, ahead, unseen = (
        intervals.forward(questions.assign(string=string), LEVEL) for string in ("made-002", "made-003", "other")
    )
    half = [float((bounds["high"] - bounds["value"]).median()) for bounds in (seen, ahead)]
    assert half[1] == pytest.approx(
        half[0] * intervals.quantile("displacement_mm", 3, LEVEL) / intervals.quantile("displacement_mm", 0, LEVEL)
    )
    assert half[1] > half[0] and not unseen["inside"].any() and np.isposinf(unseen["high"]).all()


def test_each_strings_own_last_strokes_are_foreseen():
    points = pd.concat([made_string(2), made_string(3, strokes=5), made_string(4, strokes=3)], ignore_index=True)
    ahead = parts_of(points)[-AHEAD:]
    for number, (seen, rest) in enumerate(ahead, start=1):
        assert set(rest["string"]) == ({"made-002", "made-003"} if number == 1 else {"made-002"})
        for string, rows in rest.groupby("string"):
            last = points.loc[points["string"] == string, "stroke"].max()
            assert (rows["stroke"] == last).all()
            assert seen.loc[seen["string"] == string, "stroke"].max() == last - number
        assert (seen["string"] == "made-004").sum() == (points["string"] == "made-004").sum()


def test_points_of_one_block_are_refused():
    points = made_string(1)
    with pytest.raises(TooFew):
        Intervals(lambda: make_model("polynomial")).fit(points[points["stroke"] == 2].assign(block=1), 0)


def test_where_no_error_could_be_learnt_there_is_no_interval() -> None:
    points = made_string(0)
    intervals = fitted(points)
    assert intervals.forward(points[:5], 0.9)["inside"].all()
    intervals.scatter["displacement_mm"].size[:] = np.nan
    answered = intervals.forward(points[:5], 0.9)
    assert not answered["inside"].any() and np.isinf(answered["high"]).all()
    (why,) = reasons(intervals, points[:1], "displacement_mm", np.zeros(1, bool), 0.9)
    assert str(why) == "how large an error is here could not be learnt"
