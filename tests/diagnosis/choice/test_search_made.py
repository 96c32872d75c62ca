"""What a search chooses among made explanations, whose costs and remainders a test knows."""

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import search as searching
from pipeline.diagnosis.choice.search import Search
from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.fit.problem import Act

FLOOR = 0.5  # of the noise, in mm
APART = (
    "creep",
    "wear",
    "thermal",
    "backlash",
    "slack",
    "stiffening",
    "sensor_drift",
    "jam",
    "sensor_lag",
    "load_swing",
)


class Known(Search):
    """A search whose explanations are told: by names their cost and, in noise floors, what they leave."""

    def __init__(self, explanations, bent=None, least=0.0, ids=None):
        self.told, self.bent, self.least, self.largest, self.asked = explanations, bent or {}, least, 3, []
        self.nothing = self.made("")
        ids = ids or sorted({id_ for names in explanations for id_ in names.split()})
        self.linear = SimpleNamespace(catalogue={id_: [{}] for id_ in ids}, acting=())

    def made(self, names):
        cost, left_floors = self.told.get(names, (1e6, self.told[""][1]))
        return SimpleNamespace(ids=tuple(names.split()), cost=cost, energy=FLOOR**2 * (1.0 + left_floors**2))

    def explained(self, sets):
        self.asked += sets
        return [self.made(" ".join(sorted(ids))) for ids in sets]

    def with_discrepancy(self, explanation):
        names = " ".join(explanation.ids)
        return SimpleNamespace(cost=self.bent.get(names, explanation.cost))


def names(explanations):
    """What explanations name, in their order."""
    return [" ".join(explanation.ids) for explanation in explanations]


NOTHING = {"": (10000.0, 3.0)}


def test_singles_are_all_mechanisms_with_candidates_the_cheapest_first():
    search = Known({**NOTHING, "creep": (7.0, 1.0), "wear": (3.0, 2.0), "jam": (5.0, 0.0)})
    assert names(search.all_of(1)) == ["wear", "jam", "creep"]
    search.linear.catalogue["jam"] = []
    assert names(search.all_of(1)) == ["wear", "creep"]


def test_a_pair_has_one_of_the_best_eight_and_two_drivers():
    singles = {id_: (float(place), 1.0) for place, id_ in enumerate(APART)}
    pairs = {
        frozenset(explanation.ids) for explanation in Known({**NOTHING, **singles}, ids=[*APART, "overtwist"]).all_of(2)
    }
    without = {frozenset(pair) for pair in combinations(("sensor_lag", "load_swing", "overtwist"), 2)}
    without.add(frozenset(("jam", "overtwist")))  # both follow high twist
    assert pairs == {frozenset(pair) for pair in combinations((*APART, "overtwist"), 2)} - without


def test_a_triple_has_one_of_the_best_two_pairs_and_is_asked_for_once():
    singles = {**NOTHING, "creep": (9.0, 1.0), "wear": (8.0, 1.0), "thermal": (7.0, 1.0), "backlash": (6.0, 1.0)}
    pairs = {"creep wear": (1.0, 1.0), "creep thermal": (2.0, 1.0), "backlash wear": (3.0, 1.0)}
    search = Known({**singles, **pairs})
    search.asked.clear()
    triples = {frozenset(explanation.ids) for explanation in search.all_of(3)}
    asked_triples = [ids for ids in search.asked if len(ids) == 3]
    every = [("creep", "wear"), ("creep", "thermal")]
    assert triples == {frozenset((*pair, id_)) for pair in every for id_ in APART[:4] if id_ not in pair}
    assert len(asked_triples) == len(set(asked_triples)) == 3 and all(
        ids == tuple(sorted(ids)) for ids in asked_triples
    )


def test_what_acts_at_the_state_is_among_the_pairs_and_triples_though_no_step_leads_to_it():
    """Friction, creep and wear had been refined, and the next search knew pairs of a slip alone: it named the slip."""
    singles = {id_: (float(place), 1.0) for place, id_ in enumerate(APART)}
    search = Known({**NOTHING, **singles, "creep wear": (0.5, 1.0), "creep thermal": (0.6, 1.0)})
    for acting in (("load_swing", "sensor_lag"), ("load_swing", "sensor_lag", "slack")):
        search.linear.acting = ()
        assert acting not in [explanation.ids for explanation in search.all_of(len(acting))]
        search.linear.acting = acting
        assert acting in [explanation.ids for explanation in search.all_of(len(acting))]


def test_what_acts_at_a_state_is_of_its_catalogue_and_not_of_run_yaml():
    wear, creep, adopted, jam = (Act(id_, ({},), (1.0,)) for id_ in ("wear", "creep", "slack", "jam"))
    linear = SimpleNamespace(
        state=SimpleNamespace(acts=(wear, adopted, creep, jam)),
        problem=SimpleNamespace(included=(adopted,)),
        catalogue={"creep": [{}], "slack": [{}], "wear": [{}]},
    )
    assert Linear.acting.fget(linear) == ("creep", "wear")


@pytest.mark.parametrize(
    ("left_floors", "cost", "least", "is_more"),
    [
        (2.9, 9989.0, 0.0, True),
        (2.9, 9990.0, 0.0, True),
        (2.9, 9991.0, 0.0, False),  # hardly likelier
        (np.sqrt(9.0 - 0.041), 9000.0, 0.0, True),  # a fifth of the noise
        (np.sqrt(9.0 - 0.039), 9000.0, 0.0, False),
        (2.0, 9000.0, 1.1, True),
        (2.0, 9000.0, 1.15, False),  # what moves at random takes as much
    ],
)
def test_a_first_mechanism_must_be_likelier_and_take_a_fifth_of_the_noise(left_floors, cost, least, is_more):
    search = Known({**NOTHING, "creep": (cost, left_floors)}, least=least)
    assert search.more(search.nothing, search.made("creep"), FLOOR) == is_more


@pytest.mark.parametrize(
    ("bent", "left_floors", "is_more"),
    [
        ({"creep": 300.0, "creep wear": 200.0}, 0.5, True),
        ({"creep": 300.0, "creep wear": 201.0}, 0.5, False),  # its formulas, bent a little, do as well
        ({"creep": 300.0, "creep wear": 100.0}, np.sqrt(1.0 - 0.35**2), False),
        ({"creep": 300.0, "creep wear": 100.0}, np.sqrt(1.0 - 0.37**2), True),
    ],
)
def test_a_further_mechanism_must_do_what_bent_formulas_do_not(bent, left_floors, is_more):
    search = Known({**NOTHING, "creep": (500.0, 1.0), "creep wear": (0.0, left_floors)}, bent)
    assert search.more(search.made("creep"), search.made("creep wear"), FLOOR) is is_more


@pytest.mark.parametrize(
    ("whole", "least", "needed"),
    [(1.0, 0.0, 0.2), (3.0, 0.0, 0.36), (5.0, 0.0, 0.4), (20.0, 0.0, 0.7), (20.0, 2.0, 2.0), (0.0, 0.0, 0.2)],
)
def test_how_much_a_further_mechanism_must_take(whole, least, needed):
    """All in noise floors."""
    search = Known({"": (0.0, whole)}, least=least * FLOOR)
    assert search.mismatch(FLOOR) == pytest.approx(whole * FLOOR) and search.mismatch(99.0) == 0.0
    assert search.least_energy(FLOOR) == pytest.approx((needed * FLOOR) ** 2)


GROWING = {
    **NOTHING, "creep": (900.0, 2.0), "wear": (950.0, 2.1), "thermal": (960.0, 2.2),
    "creep wear": (500.0, 1.0), "thermal wear": (510.0, 1.0), "creep thermal": (890.0, 1.9),
    "creep thermal wear": (100.0, 0.1),
}  # fmt: skip


def test_explanations_grow_while_each_further_mechanism_is_worth_it():
    search = Known(GROWING)
    assert names([search.forward(FLOOR, size) for size in (1, 2, 3)]) == ["creep", "creep wear", "creep thermal wear"]
    assert names([search.forward(FLOOR)]) == ["creep thermal wear"]
    search.largest = 2
    assert names([search.forward(FLOOR), search.forward(FLOOR, 1)]) == ["creep wear", "creep"]
    assert Known({**NOTHING, "creep": (9999.0, 2.9)}).forward(FLOOR).ids == ()


def test_a_size_that_is_not_worth_it_ends_the_growth():
    search = Known(GROWING | {"creep wear": (850.0, 1.0), "thermal wear": (860.0, 1.0)})
    assert names([search.forward(FLOOR)]) == ["creep"]


@pytest.mark.parametrize(("place", "chosen"), [(3, "thermal"), (4, "")])
def test_of_the_next_size_the_best_four_are_tried(place, chosen):
    """Each that is cheaper takes too little away."""
    ids = ("creep", "wear", "backlash", "slack")[:place]
    singles = {id_: (float(number), 2.999) for number, id_ in enumerate(ids)}
    search = Known({**NOTHING, **singles, "thermal": (50.0, 1.0)})
    assert names([search.forward(FLOOR, 1)]) == [chosen]


def test_what_turns_out_not_to_be_needed_goes():
    explanations = GROWING | {"creep thermal wear": (100.0, 0.1), "thermal wear": (150.0, 0.1)}
    search = Known(explanations, {"thermal wear": 150.0, "creep wear": 500.0})
    assert names([search.forward(FLOOR), search.select(FLOOR)]) == ["thermal wear", "thermal wear"]
    search.forward = lambda floor, largest: search.made("creep thermal wear" if largest == 3 else "creep")
    assert names([search.select(FLOOR, 3), search.select(FLOOR, 1)]) == ["thermal wear", "creep"]
    growing_search = Known(GROWING)
    growing_search.forward = lambda floor, largest: growing_search.made("creep thermal wear")
    assert names([growing_search.select(FLOOR)]) == ["creep thermal wear"]  # each of them is needed


def test_leaders_are_the_chosen_one_and_near_ones_of_its_size_that_take_half_as_much():
    """Three by cost and three by what they leave; an energy of 5.625 noises is half way from the chosen one to none."""
    singles = {
        "creep": (1.0, 0.5), "wear": (2.0, 2.2), "thermal": (3.0, 2.0), "backlash": (4.0, 1.9), "slack": (5.0, 0.4),
        "jam": (6.0, 0.3), "stiffening": (7.0, 0.2), "sensor_lag": (8.0, 2.1),
    }  # fmt: skip
    search = Known({**NOTHING, **singles})
    assert names(search.leaders(search.made("creep"))) == ["creep", "thermal", "stiffening", "jam", "slack"]
    assert names(search.leaders(search.made("slack"))) == ["slack", "creep", "thermal", "stiffening", "jam"]


class Scanned:
    """A linearisation whose misfits are told: `scan` by what was chosen before, `fit` by columns."""

    rows, calibration, deviations, acting = 1000, np.array([0]), {}, ()

    def __init__(self, misfits, coefficients=None, active=1):
        self.misfits, self.coefficients, self.number = misfits, coefficients or {}, active
        most = max(len(misfit_row) for misfit_row in misfits.values())
        self.catalogue = {id_: [{"at": float(n)} for n in range(most)] for id_, _ in misfits}
        self.index = {(id_, n): np.array([1 + n]) for id_ in self.catalogue for n in range(most)}
        self.problem = SimpleNamespace(drivers=SimpleNamespace(velocity=None))

    def columns_of(self, keys):
        return np.array([0, *(1 + number for _, number in keys)])

    def taken(self, id_, numbers):
        return np.isin(np.arange(len(self.catalogue[id_])), numbers)

    def scan(self, keys, id_):
        misfits = np.array(self.misfits[id_, tuple(number for _, number in keys)])
        return misfits, np.full(len(misfits), self.number)

    def fit(self, columns):
        signs = self.coefficients.get(tuple(int(column) for column in columns[1:]), [1.0] * (len(columns) - 1))
        return SimpleNamespace(coefficients=np.array([-9.0, *signs]), misfit=1e5, active=0, columns=columns)

    def plain(self, columns):
        return SimpleNamespace(energy=1.0)


PENALTY = float(np.log(1000.0))


def test_a_mechanism_that_acts_once_has_its_cheapest_candidate():
    assert Search(Scanned({("creep", ()): [30.0, 10.0, 20.0]}))._best("creep", ()) == (("creep", 1),)


def test_events_are_added_while_each_gains_ten_and_two_numbers():
    """One number that acts and one that was chosen cost ln n each, for each further event."""
    first, far = [1000.0, 500.0], 10.0 + PENALTY
    for gain, events in ((far + 0.1, 2), (far - 0.1, 1)):
        steps = {("clamp_slip", ()): first, ("clamp_slip", (1,)): [500.0 - gain, -99.0]}
        steps[("clamp_slip", (1, 0))] = [0.0, 0.0]
        chosen_keys = Search(Scanned(steps))._best("clamp_slip", ())
        assert chosen_keys == (("clamp_slip", 1), ("clamp_slip", 0))[:events], gain


def test_each_event_is_there_once_and_no_more_than_the_mechanism_has():
    steps = {
        ("clamp_slip", tuple(range(count))): [9000.0 - 900.0 * max(n, count) for n in range(7)] for count in range(5)
    }
    misfits = {key: [1e4 if n > len(key[1]) else misfit for n, misfit in enumerate(row)] for key, row in steps.items()}
    assert Search(Scanned(misfits))._best("clamp_slip", ()) == tuple(("clamp_slip", n) for n in range(4))


@pytest.mark.parametrize(
    ("signs", "events"), [([1.0, -1.0], [0, 2]), ([1.0, 1.0], [0, 1]), ([-1.0, -1.0], [0, 1]), ([0.0, 1.0], [0, 1])]
)
def test_events_all_go_one_way(signs, events):
    steps = {("clamp_slip", ()): [500.0, 600.0, 700.0], ("clamp_slip", (0,)): [0.0, 100.0, 200.0]}
    steps |= {("clamp_slip", (0, other)): [300.0] * 3 for other in (1, 2)}
    chosen_keys = Search(Scanned(steps, {(1, 2): signs}))._best("clamp_slip", ())
    assert [number for _, number in chosen_keys] == events


def test_one_sign_is_asked_of_the_events_alone_and_not_of_what_is_beside_them():
    linear = Scanned({("clamp_slip", ()): [1.0, 2.0, 3.0]}, {(3, 1, 2): [-1.0, 1.0, 1.0], (1, 2): [-1.0, 1.0]})
    search, beside = Search(linear), (("clamp_slip", 2),)
    assert search._one_sign(beside, (("clamp_slip", 0), ("clamp_slip", 1)))
    assert not search._one_sign((), (("clamp_slip", 0), ("clamp_slip", 1)))


def test_where_all_of_two_dozen_go_the_other_way_there_is_no_further_event():
    many = 30
    steps = {
        ("clamp_slip", ()): [float(n) for n in range(many)],
        ("clamp_slip", (0,)): [n - 900.0 for n in range(many)],
    }
    steps |= {("clamp_slip", (0, n)): [0.0] * many for n in range(many)}
    against = {(1, 1 + n): [1.0, -1.0] for n in range(1, 25)}
    assert [n for _, n in Search(Scanned(steps, against))._best("clamp_slip", ())] == [0]
    del against[(1, 25)]
    assert [n for _, n in Search(Scanned(steps, against))._best("clamp_slip", ())] == [0, 24]


class Paired(Scanned):
    """Two mechanisms of two candidates each: what both leave by the candidate of each, and what one alone leaves."""

    def __init__(self, alone, both):
        super().__init__({(id_, ()): misfits for id_, misfits in alone.items()})
        self.alone, self.both, self.asked = alone, np.array(both), []
        self.catalogue = {id_: [{"at": float(n)} for n in range(len(misfits))] for id_, misfits in alone.items()}

    def scan(self, keys, id_):
        self.asked.append(id_)
        by_creep = self.both if id_ == "creep" else self.both.T
        misfits = by_creep[:, keys[0][1]] if keys else np.array(self.alone[id_])
        return misfits, np.ones(len(misfits), int)

    def fit(self, columns):
        misfit = 1e4 if len(columns) < 2 else float(columns[1])
        return SimpleNamespace(coefficients=np.zeros(len(columns)), misfit=misfit, active=0, columns=columns)


def test_of_a_pair_the_best_candidates_beside_each_other_are_taken_in_turn():
    """From creep's second, which is best alone, by jam's second and creep's first to jam's first."""
    linear = Paired({"creep": [100.0, 90.0], "jam": [200.0, 210.0]}, [[10.0, 20.0], [50.0, 40.0]])
    search = Search(linear)
    search._cost = lambda keys, fit: {"creep": 90.0, "jam": 200.0}[keys[0][0]]
    assert search._fitted(("creep", "jam"))[0] == (("creep", 0), ("jam", 0))
    assert linear.asked == ["jam", "creep", "jam", "creep", "jam"]
    assert search._fitted(("creep", "jam")) and len(linear.asked) == 5, "it is remembered"
    assert set(search.fits) == {("creep",), ("jam",), ("creep", "jam")}


def test_a_mechanism_of_one_candidate_is_not_looked_for_again():
    linear = Paired({"creep": [90.0], "jam": [200.0, 210.0]}, [[30.0, 20.0]])
    search = Search(linear)
    search._cost = lambda keys, fit: {"creep": 90.0, "jam": 200.0}[keys[0][0]]
    assert search._fitted(("creep", "jam"))[0] == (("creep", 0), ("jam", 1))
    assert linear.asked == ["jam", "creep", "jam", "jam"]


def test_cost_counts_numbers_that_act_and_those_that_were_chosen_among_several():
    linear = Scanned({("creep", ()): [30.0, 10.0]})
    search = Search(linear)
    fit = SimpleNamespace(misfit=100.0, active=3, columns=None)
    assert search._cost((), fit) == pytest.approx(100.0 + 3 * PENALTY)
    assert search._cost((("creep", 0), ("creep", 1)), fit) == pytest.approx(100.0 + 5 * PENALTY)
    linear.deviations = {"creep": np.array([7, 8]), "jam": np.array([9])}
    explanation = searching.Explanation(("creep", "wear"), (("creep", 1),), fit, 0.0, 0.0)
    bent = search.with_discrepancy(explanation)
    assert bent.fit.columns.tolist() == [0, 2, 7, 8] and bent.ids == explanation.ids and bent.keys == explanation.keys
    assert bent.cost == pytest.approx(1e5 + 4 * PENALTY) and bent.energy == 1.0


def test_where_what_is_read_moves_a_mass_there_may_be_four():
    linear = Scanned({("creep", ()): [1.0]})
    assert Search(linear).largest == 3 and Search(linear).least == 0.0
    linear.problem.drivers.velocity = np.zeros(3)
    assert Search(linear, 0.4).largest == 4 and Search(linear, 0.4).least == 0.4
