"""A run that is built for a tie, on gaps that the test makes."""

from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.proposal import design
from pipeline.diagnosis.proposal.legs import AFTER_UNKNOWN, CANDIDATES, Leg, Rig, as_left

TIME_S = np.arange(0.0, 100.0, 0.1)
TURNS = 10.0 - np.abs(TIME_S % 20.0 - 10.0)
RIG = Rig(SimpleNamespace(time_s=TIME_S, motion=TURNS, load=np.full(len(TIME_S), 20.0)))  # type: ignore[arg-type]


def seconds(legs: list[Leg], holds: bool = False, heavy: bool = False) -> float:
    """Seconds of holding still above the lowest twist, or under twice the load."""
    at, total_s = RIG.low, 0.0
    for lasts_s, to, load in legs:
        total_s += lasts_s * ((holds and to == at > RIG.low) or (heavy and load > 30.0))
        at = to
    return total_s


def test_a_run_is_built_of_the_parts_that_its_tie_needs():
    name, legs = design.designed(RIG, lambda legs: seconds(legs, holds=True), 0.1, True, True)
    assert "with a hold" in name and sum(leg[0] for leg in legs[1:]) >= design.HELD_S
    name, legs = design.designed(RIG, lambda legs: seconds(legs, heavy=True), 0.1, True, True)
    assert "under twice the load" in name.split("; ")[0] and 40.0 in {leg[2] for leg in legs}


def test_nothing_is_added_to_a_run_that_decides():
    enough = design.designed(RIG, lambda legs: 30.0 * (len(legs) > 1), 0.1, True, True)
    assert len(enough[0].split("; ")) == 1
    as_much_before = design.designed(RIG, lambda legs: 30.0 + 0.1 * len(legs), 29.0, True, True)
    assert len(as_much_before[0].split("; ")) == design.MOST_PARTS


def test_no_part_comes_twice_and_the_dear_one_comes_last():
    name, _ = design.designed(RIG, lambda legs: 0.01 * len(legs), 0.1, True, True)
    parts = name.split("; ")
    assert len(set(parts)) == len(parts) == design.MOST_PARTS and "a rest of 120 s" not in parts


def test_a_run_that_would_only_rest_ends_with_a_stroke():
    name, legs = design.designed(RIG, lambda legs: 30.0 * any(leg[0] == 120.0 for leg in legs), 0.1, True, True)
    assert name == "a rest of 120 s, then one stroke as before" and legs[-4:] == RIG.stroke()
    moves = [RIG.home(), *RIG.stroke(top=0.25)]
    assert design.with_stroke("a quarter", moves, RIG) == ("a quarter", moves)
    assert design.with_stroke("", [RIG.home()], RIG)[0] == "one stroke as before", "not `, then one stroke as before`"


def test_rests_that_follow_each_other_are_called_one():
    """`A rest of 120 s; a rest of 30 s, then one stroke as before` was read as two runs."""

    def gap(legs: list[Leg]) -> float:
        return sum(lasts_s for lasts_s, to, _ in legs[1:] if to == RIG.low and lasts_s in (30.0, 120.0)) / 5.5

    name, legs = design.designed(RIG, gap, 0.1, True, True)
    assert name == "a rest of 150 s, then one stroke as before"
    assert [leg[0] for leg in legs[1:3]] in ([120.0, 30.0], [30.0, 120.0])


def strokes(legs: list[Leg]) -> int:
    """Legs that wind by a tenth of the range at least."""
    ends = [RIG.low, *(leg[1] for leg in legs)]
    return sum(after - before >= 0.1 * (RIG.high - RIG.low) for before, after in pairwise(ends))


@pytest.mark.parametrize("driver", AFTER_UNKNOWN)
def test_what_is_recorded_after_unknown_has_a_stroke(driver: str):
    assert strokes(AFTER_UNKNOWN[driver][1](RIG)) > 0


@pytest.mark.parametrize("name", CANDIDATES)
def test_every_candidate_has_a_stroke(name: str):
    assert strokes(CANDIDATES[name](RIG)) > 0


@pytest.mark.parametrize("faster", [True, False])
def test_a_rig_is_not_asked_for_what_it_cannot(faster: bool):
    parts = design.parts(RIG, loads=False, faster=faster)
    assert {leg[2] for legs in parts.values() for leg in legs} == {20.0}
    assert any("twice the speed" in name for name in parts) == faster


def test_what_a_part_costs_is_its_time_its_strokes_and_its_trouble():
    rest, stroke = design.cost_min(RIG.rest(60.0), RIG.low), design.cost_min(RIG.stroke(), RIG.low)
    assert rest == pytest.approx(1.0 + design.PART_MIN)
    lasts_min = sum(leg[0] for leg in RIG.stroke()) / 60.0
    assert stroke == pytest.approx(lasts_min + design.STROKE_MIN + design.PART_MIN)


@pytest.mark.parametrize(
    ("loads_n", "goes_on_n"),
    [((20.0, 20.0, 40.0), 40.0), ((40.0, 20.0, 20.0), 20.0), ((20.0, 40.0, 20.0), 20.0), ((20.0, 20.0, 20.0), 20.0)],
)
def test_what_is_foretold_of_later_strokes_hangs_under_the_last_load_where_loads_only_rose(loads_n, goes_on_n):
    """A hold under 20 N after 40 N was foretold as +0.454 mm, give or take 0.016; it read +0.235 mm."""
    part = [np.full(400, load_n) for load_n in loads_n]
    load = np.concatenate(part) + 0.05 * np.sin(np.arange(1200.0))
    time_s = 0.1 * np.arange(len(load))
    motion = 10.0 - np.abs(time_s % 20.0 - 10.0)
    rig = as_left(SimpleNamespace(time_s=time_s, motion=motion, load=load))  # type: ignore[arg-type]
    assert rig.load == pytest.approx(goes_on_n, abs=0.1) and rig.stroke()[1][2] == rig.load == rig.rest(1.0)[0][2]
