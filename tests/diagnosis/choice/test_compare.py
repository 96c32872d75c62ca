"""When a larger explanation stands beside the chosen one."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import compare
from pipeline.diagnosis.choice.compare import that_take_away, to_the_noise
from pipeline.diagnosis.numerics.noise import estimate

FLOOR = 1.0


def explanation(ids, left_floors, cost):
    """What an explanation leaves in noise floors, and its cost."""
    return SimpleNamespace(ids=tuple(ids.split()), energy=FLOOR**2 + left_floors**2, cost=cost)


@pytest.mark.parametrize(
    ("ids", "left_floors", "cost", "stands"),
    [
        ("creep jam", 0.05, -400.0, True),  # to the noise, and likelier by far
        ("creep jam", 0.25, -400.0, False),  # leaves most of what was left
        ("creep jam", 0.05, -20.0, False),  # hardly likelier
    ],
)
def test_a_larger_explanation_stands_where_it_alone_explains_to_the_noise(ids, left_floors, cost, stands):
    larger = explanation(ids, left_floors, cost)
    search = SimpleNamespace(all_of=lambda size: [larger] if size == 2 else [], mismatch=lambda floor: 3.0)
    assert to_the_noise(search, explanation("creep", 0.33, 0.0), FLOOR) == [larger] * stands
    assert to_the_noise(search, explanation("x_wave", 0.33, 0.0), FLOOR) == []  # no physics: it may leave something


def test_what_takes_nothing_away_is_no_explanation_beside_one_that_does():
    search = SimpleNamespace(nothing=explanation("", 10.0, 0.0))
    works, idle = explanation("friction_hysteresis sensor_lag", 0.2, 0.0), explanation("sensor_lag", 9.9, -50.0)
    assert that_take_away(search, [works, idle]) == [works]
    assert that_take_away(search, [idle]) == [idle]


def test_the_noise_of_a_recording_of_a_few_hundred_samples():
    target = np.random.default_rng(0).normal(size=400)
    columns = np.array([np.ones(400), np.linspace(-1.0, 1.0, 400)])
    noise = estimate(target, columns, np.arange(400), step_s=0.05, trim=0.3)
    assert noise.floor == pytest.approx(1.0, rel=0.15)


class Told:
    """A search of which every explanation is known: by names, what it costs and leaves, as it is and where it bends.

    `known` and `bent` have the misfit and, in noise floors, what is left; the gap that a truth implies is `gaps`.
    """

    def __init__(self, explanations, bent=None, gaps=None, events=None):
        self.penalty, self.events, self.gaps = 5.0, events or {}, gaps or {}
        self.known = {names: self.made(names, *each) for names, each in explanations.items()}
        self.bent = {names: self.made(names, *each) for names, each in {**explanations, **(bent or {})}.items()}
        self.nothing, self.linear = self.known[""], self

    def made(self, names, misfit, left_floors):
        """An explanation; its columns tell the linear fit which one it is, and its cost is its misfit."""
        ids = tuple(names.split())
        fit = SimpleNamespace(misfit=misfit, columns=names)
        keys = ids + ids[:1] * self.events.get(names, 0)
        return SimpleNamespace(ids=ids, keys=keys, fit=fit, cost=misfit, energy=FLOOR**2 + left_floors**2)

    def explain(self, ids):
        return self.known[" ".join(sorted(ids))]

    def all_of(self, size):
        return sorted(
            (candidate for candidate in self.known.values() if len(candidate.ids) == size),
            key=lambda candidate: candidate.cost,
        )

    def with_discrepancy(self, candidate):
        return self.bent[" ".join(candidate.ids)]

    def mismatch(self, floor):
        return float(np.sqrt(max(self.nothing.energy - floor**2, 0.0)))

    def gap(self, truth, rival):
        return self.gaps.get((truth.columns, rival), 1000.0)

    def forward(self, floor):
        return self.known[self.grown] if hasattr(self, "grown") else self.known[""]


def names(sets):
    """What sets of explanations name."""
    return [" ".join(candidate.ids) for candidate in sets]


NOTHING = {"": (10000.0, 3.0)}


def test_every_further_event_costs_two_numbers():
    search = Told({**NOTHING, "jam": (100.0, 0.1)}, events={"jam": 3})
    assert compare.price(search, search.known["jam"]) == 100.0 + 3 * 2 * 5.0
    assert compare.price(search, search.nothing) == 10000.0


@pytest.mark.parametrize(
    ("seen", "expected", "bent", "beats"),
    [
        (10.0, 11.0, 2000.0, False),  # too little to tell
        (10.1, 11.0, 2000.0, True),
        (900.0, 1000.0, 0.0, True),  # nearly all that is expected if it is true: its discrepancy does not count
        (840.0, 1000.0, 0.0, False),  # less: then the other one, bent, must be worse too
        (840.0, 1000.0, 500.0, True),
        (840.0, 1000.0, 399.0, False),
        (400.0, 1000.0, 2000.0, False),  # if it were true, far more would be expected
        (401.0, 1000.0, 2000.0, True),
        (900.0, 10.0, 2000.0, False),  # nothing was to be seen
    ],
)
def test_an_explanation_beats_another_by_the_gap_that_its_truth_implies(seen, expected, bent, beats):
    explanations = {**NOTHING, "creep": (100.0, 0.1), "jam": (100.0 + seen, 0.1)}
    search = Told(explanations, {"creep": (90.0, 0.1), "jam": (90.0 + bent, 0.1)}, {("creep", "jam"): expected})
    assert compare.beats(search, search.known["creep"], search.known["jam"]) == beats
    assert not compare.beats(search, search.known["jam"], search.known["creep"])


@pytest.mark.parametrize(("left_floors", "holds"), [(0.94, True), (0.95, False)])
def test_nine_tenths_of_the_energy_above_the_noise_are_an_explanation(left_floors, holds):
    search = Told({**NOTHING, "creep": (100.0, left_floors)})
    assert compare.explains(search, search.known["creep"], FLOOR) == holds


def test_contenders_that_the_best_does_not_beat_stand_beside_it():
    explanations = {
        **NOTHING, "creep": (100.0, 0.1), "jam": (105.0, 0.1), "wear": (3000.0, 0.1), "slack": (2000.0, 0.1),
        "thermal": (2500.0, 0.1),
    }  # fmt: skip
    search = Told(explanations, gaps={("creep", "wear"): 1e5, ("creep", "thermal"): 1e5})
    unbeaten = compare.unbeaten(search, search.known["creep"], FLOOR)
    assert names(unbeaten) == ["creep", "jam", "thermal"]  # wear has less than three quarters of the gain
    assert compare.unbeaten(search, search.nothing, FLOOR) == []
    beaten = Told({**NOTHING, "creep": (100.0, 0.1), "jam": (900.0, 0.1)})
    assert names(compare.unbeaten(beaten, beaten.known["jam"], FLOOR)) == ["creep"]


def test_the_cheapest_stands_first_though_events_have_their_price():
    search = Told({**NOTHING, "jam": (100.0, 0.1), "creep": (105.0, 0.1)}, events={"jam": 1})
    assert names(compare.unbeaten(search, search.known["jam"], FLOOR)) == ["jam", "creep"]
    two = {**NOTHING, "jam": (100.0, 0.1), "creep": (105.0, 0.1)}
    dear = Told(two, gaps={("creep", "jam"): 11.0}, events={"jam": 2})
    assert names(compare.unbeaten(dear, dear.known["jam"], FLOOR)) == ["creep"]  # 20 more for two further events


@pytest.mark.parametrize(("left_floors", "stand"), [(0.9, ["creep", "creep jam"]), (1.0, ["creep jam"])])
def test_a_smaller_one_stands_beside_the_larger_that_bent_formulas_do_without_if_it_explains(left_floors, stand):
    search = Told({**NOTHING, "creep": (500.0, left_floors), "creep jam": (100.0, 0.1)})
    search.grown = "creep jam"
    assert names(compare.unbeaten(search, search.known["creep"], FLOOR)) == stand


def test_what_all_that_tie_have_in_common_may_be_enough():
    pairs = {"creep jam": (100.0, 0.1), "creep wear": (102.0, 0.1), "jam wear": (5000.0, 1.0)}
    singles = {"creep": (400.0, 0.5), "jam": (6000.0, 2.0), "wear": (6000.0, 2.0)}
    search = Told({**NOTHING, **singles, **pairs})
    bent = {"creep": (390.0, 0.5), "creep jam": (380.0, 0.1), "creep wear": (389.0, 0.1)}
    search.bent.update({key: search.made(key, *each) for key, each in bent.items()})
    assert names(compare.unbeaten(search, search.known["creep jam"], FLOOR)) == ["creep jam", "creep wear", "creep"]
    weak = Told({**NOTHING, **singles, **pairs, "creep": (400.0, 1.2)}, bent)
    assert names(compare.unbeaten(weak, weak.known["creep jam"], FLOOR)) == ["creep jam", "creep wear"]


@pytest.mark.parametrize(
    ("bent", "other", "small"),
    [
        (0.44, 130.0, True),  # takes away an energy of 0.15² of the whole, and another takes as much
        (0.48, 130.0, False),  # takes more than a flaw
        (0.44, 128.0, True),  # seven tenths of its gain
        (0.44, 132.0, False),
    ],
)
def test_a_last_mechanism_that_another_may_replace_may_be_no_more_than_a_flaw(bent, other, small):
    explanations = {
        **NOTHING, "creep": (400.0, 0.5), "jam": (6000.0, 2.0), "creep jam": (100.0, 0.1), "creep wear": (103.0, 0.1),
        "jam wear": (90.0, 0.1),
    }  # fmt: skip
    folded = {"creep": (200.0, bent), "creep jam": (100.0, 0.0), "creep wear": (other, 0.0), "jam wear": (0.0, 0.0)}
    search = Told(explanations, folded)
    rivals = search.all_of(2)
    simpler = compare.without_flaw(search, search.known["creep jam"], rivals, FLOOR)
    assert simpler is (search.known["creep"] if small else None)
    assert compare.without_flaw(search, search.known["creep"], rivals, FLOOR) is None  # one alone is no flaw


def test_a_smaller_one_that_does_not_explain_stands_for_nothing():
    explanations = {
        **NOTHING,
        "creep": (400.0, 1.0),
        "jam": (6000.0, 2.0),
        "creep jam": (100.0, 0.1),
        "creep wear": (1, 0.1),
    }
    search = Told(explanations, {"creep": (200.0, 0.3)})
    assert compare.without_flaw(search, search.known["creep jam"], search.all_of(2), FLOOR) is None


def test_a_flaw_and_what_explains_to_the_noise_stand_before_what_ties():
    explanations = {
        **NOTHING,
        "creep": (400.0, 0.5),
        "jam": (6000.0, 2.0),
        "creep jam": (100.0, 0.3),
        "creep wear": (103.0, 0.3),
    }
    folded = {"creep": (200.0, 0.4), "creep jam": (100.0, 0.0), "creep wear": (101.0, 0.0)}
    search = Told({**explanations, "creep jam wear": (-100.0, 0.05), "wear": (7000.0, 2.0)}, folded)
    unbeaten = compare.unbeaten(search, search.known["creep jam"], FLOOR)
    assert names(unbeaten) == ["creep jam wear", "creep", "creep jam", "creep wear"]


@pytest.mark.parametrize(
    ("whole", "chosen", "larger", "stands"),
    [
        (3.0, 0.33, 0.14, True),  # takes 0.8 of what was left
        (3.0, 0.33, 0.16, False),
        (3.0, 0.19, 0.0, False),  # less than a fifth of the noise
        (3.0, 0.21, 0.0, True),
        (9.0, 0.31, 0.0, False),  # less than no formula gets right of so large a mismatch
        (9.0, 0.33, 0.0, True),
    ],
)
def test_a_larger_explanation_must_take_what_is_worth_it(whole, chosen, larger, stands):
    explanations = {
        "": (10000.0, whole),
        "creep": (500.0, chosen),
        "creep jam": (400.0, larger),
        "creep wear": (401.0, 0.9),
    }
    search = Told(explanations)
    assert names(to_the_noise(search, search.known["creep"], FLOOR)) == ["creep jam"] * stands
    near = Told({**explanations, "creep jam": (400.5, larger)})
    assert to_the_noise(near, near.known["creep"], FLOOR) == []  # its gain is less than 100


def test_larger_explanations_that_the_first_beats_do_not_stand():
    explanations = {**NOTHING, "creep": (500.0, 0.33), "creep jam": (300.0, 0.0), "creep wear": (305.0, 0.0)}
    search = Told({**explanations, "creep slack": (399.0, 0.0)}, gaps={("creep jam", "creep slack"): 50.0})
    assert names(to_the_noise(search, search.known["creep"], FLOOR)) == ["creep jam", "creep wear"]
    five = {f"creep {name}": (300.0 + number, 0.0) for number, name in enumerate(("a", "b", "c", "d", "e"))}
    many = Told({**NOTHING, "creep": (500.0, 0.33), **five})
    assert len(to_the_noise(many, many.known["creep"], FLOOR)) == 4
