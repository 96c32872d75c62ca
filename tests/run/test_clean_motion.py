"""A part of a motion is what it is within the whole, and is told from no more samples than it needs."""

from itertools import pairwise

import numpy as np
import pandas as pd
import pytest

from pipeline.ground.stored import schemas
from pipeline.ground.stored.rows import Held
from pipeline.run.clean_motion import Motion

SAMPLES, RATE_HZ = 63, 20.0
REACH = 2  # samples: a tenth of a second
PARTS = [(first, stop) for first in range(SAMPLES) for stop in range(first + 1, SAMPLES + 1)]


class Watched(Held):
    """Rows that note what is read of them."""

    def __init__(self, table):
        super().__init__(table)
        self.taken = []

    def read(self, name, first, stop):
        self.taken.append((name, first, stop))
        return super().read(name, first, stop)


def rows(count=SAMPLES, spike=None, seed=0):
    rng = np.random.default_rng(seed)
    time_s = (np.arange(count) + rng.uniform(-0.1, 0.1, count)) / RATE_HZ
    turns = np.cumsum(rng.standard_normal(count))
    if spike is not None:
        turns[spike] += 1000.0
    return Watched(pd.DataFrame({"time_s": time_s, "motor_turns": turns}))


@pytest.fixture
def motion(monkeypatch):
    monkeypatch.setattr(schemas, "ROW_GROUP", 10)
    return Motion(rows(spike=30), "motor_turns")


def test_the_median_about_a_sample_is_the_same_whatever_part_is_asked_for(motion):
    whole = motion.smooth(0, SAMPLES)
    readings = motion.rows.read("motor_turns", 0, SAMPLES).copy()
    readings[30] = np.median(readings[28:33])  # a spike is the median about it before any other is taken
    padded = np.pad(readings, 2, mode="edge")
    assert whole.tolist() == [float(np.median(padded[at : at + 5])) for at in range(SAMPLES)]
    assert all(np.array_equal(motion.smooth(*part), whole[slice(*part)]) for part in PARTS)


def test_the_motion_at_some_samples_is_the_one_of_the_whole_in_any_order(motion):
    whole, places = motion.smooth(0, SAMPLES), np.random.default_rng(1).permutation(SAMPLES)
    assert np.array_equal(motion.smooth_at(places), whole[places])
    assert np.array_equal(np.concatenate(list(motion.pieces())), whole)


def test_the_speed_is_the_way_between_a_tenth_of_a_second_before_and_after_by_its_time(motion):
    smooth, time_s = motion.smooth(0, SAMPLES), motion.time_s(0, SAMPLES)
    ends = [(max(at - REACH, 0), min(at + REACH, SAMPLES - 1)) for at in range(SAMPLES)]
    whole = np.array([abs(smooth[b] - smooth[a]) / (time_s[b] - time_s[a]) for a, b in ends])
    assert motion.reach == REACH
    assert all(np.array_equal(motion.speed(*part), whole[slice(*part)]) for part in PARTS)


def test_the_step_of_a_sample_is_the_time_to_the_next_and_of_the_last_one_0(motion):
    time_s = motion.time_s(0, SAMPLES)
    whole = [*(float(after - before) for before, after in pairwise(time_s)), 0.0]
    assert all(motion.steps_s(*part).tolist() == whole[slice(*part)] for part in PARTS)


@pytest.mark.parametrize(("rate_hz", "reach"), [(1.0, 1), (4.0, 1), (10.0, 1), (24.0, 2), (26.0, 3), (1000.0, 100)])
def test_the_speed_reaches_a_tenth_of_a_second_and_one_sample_at_least(rate_hz, reach):
    """At a slow logger's rate a tenth of a second holds no sample, and the speed would be 0 by 0."""
    table = pd.DataFrame({"time_s": np.arange(300) / rate_hz, "motor_turns": np.zeros(300)})
    assert Motion(Held(table), "motor_turns").reach == reach


@pytest.mark.parametrize("group", [1, 2, 3, 4, 5, 100])
@pytest.mark.parametrize(("time_s", "step_s"), [([0.0, 1.0, 2.0, 4.0, 6.0], 1.5), ([0.0, 1.0, 3.0, 5.0], 2.0)])
def test_the_usual_step_is_the_median_of_the_steps_between_samples(monkeypatch, group, time_s, step_s):
    """The last sample has no step: a 0 for it would make the usual step too short."""
    monkeypatch.setattr(schemas, "ROW_GROUP", group)
    table = pd.DataFrame({"time_s": time_s, "motor_turns": np.zeros(len(time_s))})
    assert Motion(Held(table), "motor_turns").step_s == step_s


@pytest.mark.parametrize("first", [1001, 1003, 1022, 1024, 1029])
def test_a_part_of_a_long_recording_is_told_from_the_samples_beside_it(first):
    """Or memory would go by the length of a recording: of hours, only a part may be held."""
    long = rows(3000)
    motion = Motion(long, "motor_turns")
    assert motion.reach == REACH and motion.smooth(0, 10).size == 10
    for part, beside in ((motion.smooth, 2), (motion.speed, REACH + 2), (motion.steps_s, 1), (motion.time_s, 0)):
        long.taken.clear()
        assert len(part(first, first + 50)) == 50
        assert min(begin for _, begin, _ in long.taken) >= first - beside
        assert max(stop for _, _, stop in long.taken) <= first + 50 + beside
