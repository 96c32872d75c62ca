"""The first stroke after a break is held by its interval, wider than usual, and it is said."""

import numpy as np
import pandas as pd
import pytest
from made_strings import made_string

from pipeline.models.interface import make_model
from pipeline.models.parts.questions.beside_questions import with_intervals
from pipeline.models.parts.questions.foreseen import GIVEN, MAPS
from pipeline.models.parts.questions.prediction_intervals import Intervals
from pipeline.models.parts.questions.stroke_errors import after_break

LEVEL, FIRST = 0.9, 10  # the stroke with which the second run begins
RECOVERED_MM = 0.35  # what a string that crept takes back in a break, and loses again in one stroke


def two_runs() -> pd.DataFrame:
    """A string of 18 strokes, the second nine after a break: the first of them begins in another state."""
    points = made_string(0, strokes=18)
    back_mm = RECOVERED_MM * np.where(points["direction"] > 0, 1.0, 0.5) * (points["stroke"] == FIRST)
    run = np.where(points["stroke"] < FIRST, "made-000-1", "made-000-2")
    return points.assign(run=run, displacement_mm=points["displacement_mm"] + back_mm)


def fitted(points: pd.DataFrame) -> Intervals:
    intervals = Intervals(lambda: make_model("spline"))
    intervals.fit(points, 0)
    return intervals


@pytest.fixture(scope="module")
def recovered() -> Intervals:
    return fitted(two_runs())


@pytest.mark.long
@pytest.mark.parametrize("wanted", GIVEN)
def test_the_first_stroke_after_a_break_is_held_by_a_wider_interval_that_says_so(
    recovered: Intervals, wanted: str
) -> None:
    points = two_runs()
    answers = with_intervals(recovered, points.assign(**{wanted: np.nan}), GIVEN[wanted], LEVEL)
    answers["why"] = answers["why"].map(str)
    low, high = answers[f"{wanted}_low"], answers[f"{wanted}_high"]
    covered = points[wanted].between(low, high)[answers["inside"]]
    first = points["stroke"] == FIRST
    assert answers["inside"].mean() > 0.98 and covered[first].mean() >= LEVEL - 0.03 and covered[~first].mean() >= LEVEL
    winding = first & (points["direction"] > 0)
    (why,) = set(answers["why"][winding & answers["inside"]])
    before, factor = why.split("its interval is ")
    assert before == f"stroke {FIRST}, the first after a break, errs more winding than others: "
    assert factor.endswith(" times as wide") and float(factor.split()[0]) > 1.3
    assert set(answers["why"][points["stroke"].isin([FIRST - 2, FIRST + 2]) & answers["inside"]]) == {""}
    usual = getattr(recovered, MAPS[wanted])(points[winding].assign(stroke=FIRST + 2), LEVEL)
    times = np.nanmedian((high - low)[winding].to_numpy() / (usual["high"] - usual["low"]).to_numpy())
    assert times == pytest.approx(float(factor.split()[0]), rel=0.06)


@pytest.mark.long
def test_strokes_that_the_model_fits_have_the_usual_interval() -> None:
    for number in range(3):  # left out in part, the first stroke is missed; seen whole, it is fitted
        points = made_string(number)
        intervals = fitted(points)
        for wanted in GIVEN:
            assert set(intervals.why_wider(points, wanted, LEVEL)) == {""}


@pytest.mark.long
def test_of_too_few_points_nothing_is_said(recovered: Intervals) -> None:
    points = two_runs()
    assert set(recovered.why_wider(points, "displacement_mm", 0.999)) == {""}  # no quantile of 40 points
    thin = fitted(points[points["block"] == points["stroke"] % 8].reset_index(drop=True))
    assert set(thin.why_wider(points, "displacement_mm", LEVEL)) == {""}


@pytest.mark.long
def test_a_break_lies_before_each_later_run_of_a_string() -> None:
    points = pd.concat([two_runs(), made_string(1)], ignore_index=True)
    assert after_break(points) == {("made-000", float(FIRST))}
    beyond = fitted(two_runs()).why_wider(points[:1].assign(stroke=19), "displacement_mm", LEVEL)
    assert beyond == [""]
