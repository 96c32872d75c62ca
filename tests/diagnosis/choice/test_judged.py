"""What a verdict holds of what was weighed, and what is not weighed at all."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import cross_validation, judged, weigh
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.numerics.judge import Weighed, signature_table
from pipeline.diagnosis.numerics.noise import white


def explanation(*ids, left_floors=0.0, cost=0.0):
    """An explanation that names these, with one column each; beyond the noise it leaves so many floors of 0.01 mm."""
    energy = 1e-4 * (1.0 + left_floors**2)
    return SimpleNamespace(ids=ids, fit=SimpleNamespace(columns=np.arange(len(ids))), energy=energy, cost=cost)


@pytest.mark.parametrize(("jerks", "weighed"), [(1.9, ["creep"]), (2.1, ["stick_slip", "creep"])])
def test_stick_slip_is_weighed_only_where_its_jerks_are_seen(monkeypatch, jerks, weighed):
    monkeypatch.setattr(weigh, "candidates", lambda search: [explanation("stick_slip"), explanation("creep")])
    monkeypatch.setattr(weigh, "marked", lambda problem, base: {"stick_slip": jerks})
    monkeypatch.setattr(weigh, "signs", lambda search, candidate, rivals, floor: {})
    search = SimpleNamespace(
        linear=SimpleNamespace(
            problem=SimpleNamespace(library=mechanisms(), judge=SimpleNamespace(recogniser=None), runs=1)
        )
    )
    assert [weighed_set.ids[0] for weighed_set in weigh.weighed(search, None, 0.01)] == weighed


def judge_of(shares):
    """A search of a string whose judge gives these probabilities, the last that of none."""
    judge = SimpleNamespace(probabilities=lambda weighed_sets: np.array(shares))
    problem = SimpleNamespace(drivers=SimpleNamespace(levered=True), judge=judge)
    return SimpleNamespace(linear=SimpleNamespace(problem=problem), explain=lambda ids: explanation(*ids))


@pytest.mark.parametrize(
    ("weighed_names", "shares", "expected_names", "likely"),
    [
        (["creep", "creep jam wear"], [0.7, 0.2, 0.1], "creep jam wear", 0.9),  # worth a third effect
        (["creep", "jam"], [0.85, 0.05, 0.1], "creep", 0.85),  # no set of three was weighed
    ],
)
def test_a_third_effect_is_taken_where_one_was_weighed(monkeypatch, weighed_names, shares, expected_names, likely):
    monkeypatch.setattr(judged, "weighed", lambda *_: [Weighed(tuple(name.split()), {}) for name in weighed_names])
    judgement = judged.judged(judge_of(shares), None, explanation("creep", "jam", "wear"), 0.01)
    ids = tuple(expected_names.split())
    assert [candidate.ids for candidate in judgement.sets] == [ids] and judgement.likely[ids] == pytest.approx(likely)


@pytest.mark.parametrize(
    ("pair_floors", "left_floors", "cost", "is_bent", "expected"),
    [
        (2.5, 0.9, 500.0, False, "creep jam wear"),
        (2.5, 1.1, 500.0, False, "creep count_slip"),  # leaves more than 0.4 of what the pair leaves
        (2.5, 0.9, 950.0, False, "creep count_slip"),  # hardly cheaper
        (2.5, 0.9, 500.0, True, "creep count_slip"),  # the pair's formulas, bent a little, do as well
        (0.2, 0.0, 500.0, False, "creep count_slip"),  # the pair leaves the noise alone
    ],
)
def test_three_that_lack_one_of_the_likeliest_pair_are_taken_where_they_are_far_better(
    monkeypatch, pair_floors, left_floors, cost, is_bent, expected
):
    """A slip stood first that left 2.7 times the noise, before the three that acted and left the noise alone."""
    pair = ("creep", "count_slip")
    three = explanation("creep", "jam", "wear", left_floors=left_floors, cost=cost)
    monkeypatch.setattr(judged, "weighed", lambda *_: [Weighed(ids, {}) for ids in (pair, three.ids)])
    monkeypatch.setattr(judged, "three_instead", lambda *_: [])
    search = judge_of([0.7, 0.2, 0.1])
    search.more = lambda small, large, floor: not is_bent
    search.explain = lambda ids: three if ids == three.ids else explanation(*ids, left_floors=pair_floors, cost=1000.0)
    judgement = judged.judged(search, None, three, 0.01)
    assert " ".join(judgement.sets[0].ids) == expected


def test_a_set_without_physics_of_the_library_counts_as_none_of_them(monkeypatch):
    sets = [("x_clock",), ("sensor_lag",), ("sensor_lag", "x_clock")]
    monkeypatch.setattr(judged, "weighed", lambda *_: [Weighed(ids, {}) for ids in sets])
    judgement = judged.judged(judge_of([0.5, 0.3, 0.1, 0.1]), None, explanation("sensor_lag"), 0.01)
    assert judgement.none == pytest.approx(0.6) and [candidate.ids for candidate in judgement.sets] == [
        ("x_clock",),
        ("sensor_lag",),
    ]
    assert judgement.confidence("sensor_lag") == pytest.approx(0.4)


def test_an_explanation_that_is_left_out_says_nothing_of_its_effects():
    """What was left out made an effect likely that every kept explanation but one lacked."""
    likely = {("jam",): 0.3, ("creep", "jam"): 0.1, ("thermal", "wear"): 0.5}
    judgement = judged.Judged([], likely, 0.1, left_out=(judged.LeftOut(("thermal", "wear"), "cancels", ()),))
    shares = {id_: judgement.confidence(id_) for id_ in ("jam", "creep", "wear")}
    assert shares == pytest.approx({"jam": 0.9, "creep": 0.225, "wear": 0.0})


def test_a_number_that_the_other_stretches_hardly_show_stays_nothing():
    """A column acts in the last stretch; what little there is of it before would tell a number of any size."""
    rows, draw = 1000, np.random.default_rng(0)
    target = draw.standard_normal(rows)
    late = np.where(np.arange(rows) >= 900, 1.0, 1e-5) * draw.standard_normal(rows)
    free = np.full(1, np.inf)
    linear = SimpleNamespace(
        table=np.vstack([late, target]), rows=rows, noise=white(1.0), gram=np.array([[late @ late]]), low=-free,
        high=free, begin=np.zeros(1), problem=SimpleNamespace(drivers=SimpleNamespace(first=np.arange(rows))),
    )  # fmt: skip
    (error,) = cross_validation.left_out_errors(linear, [explanation("late")])
    assert error == pytest.approx(1.0, abs=0.2)


@pytest.mark.parametrize(("shares", "places"), [([0.8, 0.2], [0]), ([0.2, 0.79], [1, 0]), ([0.3, 0.3, 0.4], [2, 0, 1])])
def test_sets_are_held_until_they_have_four_fifths_of_the_probability(shares, places):
    assert judged.held(np.array(shares)) == places


def test_where_nothing_is_wound_the_sets_that_foretell_alike_are_equally_likely(monkeypatch):
    sets = [explanation("backlash"), explanation("stick_slip"), explanation("creep")]
    monkeypatch.setattr(judged.compare, "unbeaten", lambda *_: sets)
    monkeypatch.setattr(judged.cross_validation, "by_prediction", lambda linear, tied_sets: tied_sets[:2])
    search = SimpleNamespace(linear=SimpleNamespace(problem=SimpleNamespace(drivers=SimpleNamespace(levered=False))))
    judgement = judged.judged(search, None, sets[0], 0.01)
    assert judgement.sets == sets[:2] and judgement.none == 0.0
    assert judgement.likely == {("backlash",): 0.5, ("stick_slip",): 0.5}


def test_a_single_effect_is_no_reason_to_take_a_set_of_three(monkeypatch):
    sets = [(), ("creep", "jam", "wear")]
    monkeypatch.setattr(judged, "weighed", lambda *_: [Weighed(ids, {}) for ids in sets])
    judgement = judged.judged(judge_of([0.85, 0.05, 0.1]), None, explanation("creep"), 0.01)
    assert [candidate.ids for candidate in judgement.sets] == [()] and judgement.likely[sets[1]] == pytest.approx(0.05)


def test_where_nothing_was_found_that_it_is_none_of_them_is_certain():
    assert judged.NOTHING.none == 1.0 and not judged.NOTHING.sets and judged.NOTHING.confidence("creep") == 0.0


@pytest.mark.parametrize(("runs", "is_asked"), [(1, True), (2, False)])
def test_the_recogniser_is_asked_about_single_recordings_alone(monkeypatch, runs, is_asked):
    monkeypatch.setattr(weigh, "candidates", lambda search: [explanation("creep"), explanation("creep", "jam")])
    monkeypatch.setattr(weigh, "marked", lambda problem, base: {})
    monkeypatch.setattr(weigh, "signs", lambda search, candidate, rivals, floor: {})
    monkeypatch.setattr(weigh, "signature_of", lambda problem, base: {})
    recogniser = SimpleNamespace(likenesses=lambda signature: {"creep": 0.7, "jam": 0.2, "outside": 0.1})
    problem = SimpleNamespace(library=mechanisms(), judge=SimpleNamespace(recogniser=recogniser), runs=runs)
    single, pair = weigh.weighed(SimpleNamespace(linear=SimpleNamespace(problem=problem)), None, 0.01)
    assert ("alike" in single.signs) == ("alike_outside" in pair.signs) == is_asked
    table = signature_table([single, pair])
    assert table.shape == (3, 5) and bool(table[0].any()) == bool(table[2].any()) == is_asked and not table[1].any()
