"""What is weighed of each explanation, on made searches whose signs a person can reckon."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import weigh

FLOOR = 0.5  # of the noise; squared it is a quarter


def explanation(names, cost, left_mm, active=1):
    """An explanation: its names, cost, what it leaves beyond the noise in mm, and how many numbers act."""
    keys = tuple((id_, 0) for id_ in names.split())
    fit = SimpleNamespace(active=active)
    return SimpleNamespace(ids=tuple(names.split()), keys=keys, cost=cost, energy=FLOOR**2 + left_mm**2, fit=fit)


def searched(*explanations):
    """A search that knows these explanations and nothing else; the first names nothing."""
    by_ids = {candidate.ids: candidate for candidate in explanations}
    return SimpleNamespace(nothing=explanations[0], known=list(explanations[1:]), explain=by_ids.__getitem__)


def names(explanations):
    """What explanations name, sorted."""
    return sorted(" ".join(candidate.ids) for candidate in explanations)


@pytest.mark.parametrize(("size", "cheapest"), [(1, 10), (2, 12), (3, 6)])
def test_the_cheapest_of_each_size_are_weighed_and_four_that_leave_least(size, cheapest):
    every = [
        explanation(" ".join(f"{part}{number:02}" for part in "abc"[:size]), number, 40.0 - number)
        for number in range(30)
    ]
    weighed = weigh.candidates(searched(explanation("", 99.0, 9.0), *reversed(every)))
    assert names(weighed) == names([*every[:cheapest], *every[-4:]])
    few = searched(explanation("", 99.0, 9.0), *every[:3])
    assert len(weigh.candidates(few)) == 3  # each once, though it is cheap and leaves little


def test_a_set_of_four_is_not_weighed():
    four = explanation("a b c d", 1.0, 1.0)
    assert weigh.candidates(searched(explanation("", 99.0, 9.0), four)) == []


def test_marks_are_read_off_the_residual_of_the_rows_that_may_be_seen():
    calls = []
    with_mark = SimpleNamespace(mark=lambda *arguments: calls.append(arguments) or 3.0)
    problem = SimpleNamespace(
        simulate=lambda base: np.array([1.0, 2.0, 3.0]), measured=np.array([1.5, 2.0, 9.0]), rows=2, drivers="drivers",
        library={"creep": with_mark, "jam": SimpleNamespace(mark=None)},
    )  # fmt: skip
    assert weigh.marked(problem, "base") == {"creep": 3.0}
    ((drivers, residual, predicted),) = calls
    assert drivers == "drivers" and residual.tolist() == [0.5, 0.0] and predicted.tolist() == [1.0, 2.0]


def test_a_mark_counts_for_a_set_that_names_it_and_for_one_that_does_not():
    expected = {"with_jam": 2.0, "with_wear": 0.0, "without_jam": 0.0, "without_wear": 7.0}
    assert weigh.own({"jam": 2.0, "wear": 7.0}, ("creep", "jam")) == expected


@pytest.mark.parametrize(("mark", "weighed"), [(1.9, ["creep"]), (2.0, ["jam", "creep"])])
def test_a_mark_that_is_just_enough_is_enough(monkeypatch, mark, weighed):
    library = {"jam": SimpleNamespace(least_mark=2.0), "creep": SimpleNamespace(least_mark=0.0)}
    problem = SimpleNamespace(library=library, judge=SimpleNamespace(recogniser=None), runs=1)
    monkeypatch.setattr(weigh, "marked", lambda problem, base: {"jam": mark})
    monkeypatch.setattr(
        weigh, "signs", lambda search, candidate, rivals, floor: {"rivals": len(rivals), "floor": floor}
    )
    search = searched(explanation("", 99.0, 9.0), explanation("jam", 1.0, 1.0), explanation("creep", 2.0, 2.0))
    search.linear = SimpleNamespace(problem=problem)
    weighed_sets = weigh.weighed(search, None, FLOOR)
    assert [weighed_set.ids[0] for weighed_set in weighed_sets] == weighed
    own = {"with_jam": 0.0, "without_jam": mark}
    assert weighed_sets[-1].signs == {"rivals": 2, "floor": FLOOR, **own}


def test_sizes_beyond_the_noise_and_what_one_takes_beyond_another():
    nothing, some_of_it, all_of_it = (explanation("", 0.0, left_mm) for left_mm in (5.0, 3.0, 0.0))
    assert weigh.amplitude(nothing.energy, FLOOR) == 5.0 and weigh.amplitude(0.1, FLOOR) == 0.0
    assert weigh.worth(nothing, some_of_it) == 4.0 and weigh.worth(some_of_it, nothing) == 0.0
    assert weigh.completes(nothing, some_of_it, FLOOR) == pytest.approx(16.0 / 25.0)
    assert weigh.completes(some_of_it, nothing, FLOOR) == -1.0  # -16 of 9, which counts as -1
    assert weigh.completes(all_of_it, all_of_it, FLOOR) == 0.0
    below = SimpleNamespace(energy=FLOOR**2 - 1.5e-4 * FLOOR**2)
    assert weigh.completes(all_of_it, below, FLOOR) == pytest.approx(1.5)  # of a ten thousandth of the noise
    below.energy = FLOOR**2 - 9e-4 * FLOOR**2
    assert weigh.completes(all_of_it, below, FLOOR) == 2.0


def test_costs_are_compressed():
    assert weigh.cost(10.0 * np.sinh(2.0)) == pytest.approx(2.0) and weigh.cost(0.0) == 0.0


@pytest.fixture
def search_of_three(monkeypatch):
    """A search of three effects, alone and by twos; all three together, too."""
    monkeypatch.setattr(weigh, "sizes", lambda search, candidate: (4.0, 2.0))
    return searched(
        explanation("", 900.0, 10.0),
        explanation("creep", 500.0, 6.0),
        explanation("jam", 600.0, 8.0),
        explanation("wear", 650.0, 9.0),
        explanation("creep jam", 250.0, 3.0, active=5),
        explanation("creep wear", 280.0, 4.0),
        explanation("jam wear", 400.0, 7.0),
        explanation("creep jam wear", 200.0, 1.0),
    )


def signs_of(search, names):
    """The signs of an explanation among all of a search."""
    return weigh.signs(search, search.explain(tuple(names.split())), search.known, FLOOR)


def test_the_signs_of_a_pair(search_of_three):
    """Ten mm are missing, three are left of them; the noise has half a millimetre."""
    expected = {
        "mismatch_floors": np.log(20.01),
        "left_share": np.log(0.303),
        "left_floors": np.log(6.02),
        "numbers": 5.0,
        "gain": np.arcsinh(65.0),
        "behind_1": np.arcsinh(-25.0),
        "left_behind_1": np.arcsinh(30.0 * (3.0 - 6.0) / 10.0),
        "behind_2": 0.0,
        "left_behind_2": 0.0,
        "behind_3": np.arcsinh(5.0),
        "left_behind_3": np.arcsinh(30.0 * (3.0 - 1.0) / 10.0),
        # without jam, which is worth least, creep alone leaves 6 mm at a cost of 500; wear in its place would cost 280
        "weakest_share": np.log(np.sqrt(27.0) / 10.0 + 0.003),
        "weakest_floors": np.log(np.sqrt(27.0) / FLOOR + 0.01),
        "weakest_gain": np.arcsinh(25.0),
        "weakest_completes": 27.0 / 36.0,
        "instead": 220.0 / 250.0,
        "more_gain": np.arcsinh(5.0),
        "more_share": np.log(np.sqrt(8.0) / 10.0 + 0.003),
        "more_floors": np.log(np.sqrt(8.0) / FLOOR + 0.01),
        "more_completes": 8.0 / 9.0,
        "left_of_own": np.log(3.0 / 4.0 + 0.003),
        "cancels": np.log(2.0),
    }
    assert signs_of(search_of_three, "creep jam") == pytest.approx(expected)


def test_the_signs_of_a_single_effect_are_beside_nothing_and_beside_its_pairs(search_of_three):
    signs = signs_of(search_of_three, "jam")
    assert signs["weakest_gain"] == signs["gain"] == pytest.approx(np.arcsinh(30.0))
    assert signs["weakest_share"] == pytest.approx(np.log(0.603)) and signs["weakest_completes"] == 0.36
    assert signs["instead"] == pytest.approx(400.0 / 300.0)  # creep would gain more in its place
    assert signs["more_gain"] == pytest.approx(np.arcsinh(35.0))  # by creep, which is the better partner
    assert signs["more_completes"] == pytest.approx(55.0 / 64.0)


def test_where_nothing_larger_was_weighed_nothing_more_is_gained(search_of_three):
    signs = signs_of(search_of_three, "creep jam wear")
    more = {name: signs[name] for name in ("more_gain", "more_share", "more_floors", "more_completes")}
    assert more == {
        "more_gain": 0.0, "more_share": pytest.approx(np.log(0.003)), "more_floors": pytest.approx(np.log(0.01)),
        "more_completes": 0.0,
    }  # fmt: skip


def test_the_weakest_is_judged_by_what_it_takes_and_by_the_cheapest_without_it(search_of_three):
    """Without wear least energy comes back; the cheapest that leaves one out may be another."""
    search_of_three.explain(("creep", "wear")).cost = 240.0
    signs = signs_of(search_of_three, "creep jam wear")
    assert signs["weakest_share"] == pytest.approx(np.log(np.sqrt(8.0) / 10.0 + 0.003))
    assert signs["weakest_gain"] == pytest.approx(np.arcsinh(4.0))
    assert signs["instead"] == 0.0  # no other triple was weighed


@pytest.mark.parametrize(
    ("cost", "of_another", "instead"),
    [(498.0, 499.0, 0.5), (499.8, 499.5, 0.5), (498.0, -9000.0, 3.0), (498.0, 9000.0, -3.0)],
)
def test_what_another_would_give_in_place_of_the_weakest_is_of_its_gain_within_bounds(
    search_of_three, cost, of_another, instead
):
    """Creep alone costs 500; a gain of less than one counts as one."""
    search_of_three.explain(("creep", "jam")).cost, search_of_three.explain(("creep", "wear")).cost = cost, of_another
    assert signs_of(search_of_three, "creep jam")["instead"] == pytest.approx(instead)


def test_a_size_of_which_none_was_weighed_is_measured_against_nothing(search_of_three):
    few = [candidate for candidate in search_of_three.known if len(candidate.ids) != 3]
    signs = weigh.signs(search_of_three, search_of_three.explain(("creep", "jam")), few, FLOOR)
    assert signs["behind_3"] == pytest.approx(np.arcsinh(-65.0))
    assert signs["left_behind_3"] == pytest.approx(np.arcsinh(30.0 * (3.0 - 10.0) / 10.0))


def test_a_mismatch_of_nothing_has_signs(search_of_three):
    search_of_three.nothing.energy = 0.0
    signs = signs_of(search_of_three, "creep jam")
    assert signs["mismatch_floors"] == pytest.approx(np.log(0.01))
    assert signs["left_share"] == pytest.approx(np.log(3e12))


@pytest.mark.parametrize(
    ("own", "together", "cancelled"),
    [
        (4.0, 2.0, np.log(2.0)),
        (2.0, 4.0, 0.0),
        (1e6, 1.0, 5.0),
        (4.0, 0.0, 0.0),
        (0.0, 4.0, 0.0),
        (1e-3, 5e-4, np.log(2.0)),
    ],
)
def test_effects_that_balance_each_other_say_so(own, together, cancelled):
    assert weigh.cancelled(own, together) == pytest.approx(cancelled)


def test_what_is_left_of_the_effects_themselves_needs_an_effect(search_of_three, monkeypatch):
    monkeypatch.setattr(weigh, "sizes", lambda search, candidate: (0.0, 0.0))
    assert (
        signs_of(search_of_three, "creep jam")["left_of_own"]
        == signs_of(search_of_three, "creep jam")["cancels"]
        == 0.0
    )
    monkeypatch.setattr(weigh, "sizes", lambda search, candidate: (0.5, 0.5))
    assert signs_of(search_of_three, "creep jam")["left_of_own"] == pytest.approx(np.log(6.003))


def test_the_sizes_of_effects_one_by_one_and_together():
    """One column of calibration, two of creep, one of each of the two events of jam, which balance the first."""
    wave = np.array([1.0, -1.0, 1.0, -1.0])
    columns = {(): [0], ("creep", 3): [1, 2], ("jam", 0): [3], ("jam", 7): [4]}
    fit = SimpleNamespace(columns=np.arange(5), coefficients=np.array([9.0, 1.0, 2.0, -1.0, -1.0]))
    linear = SimpleNamespace(
        calibration=np.array([0]), rows=4, index=columns, table=np.array([wave, wave, wave, wave, wave]),
        columns_of=lambda keys: keys, plain=lambda keys: fit,
    )  # fmt: skip
    keys = (("creep", 3), ("jam", 0), ("jam", 7))
    pair = SimpleNamespace(ids=("creep", "jam"), keys=keys)
    assert weigh.sizes(SimpleNamespace(linear=linear), pair) == pytest.approx((5.0, 1.0))
