"""Holes of a text recording: lost samples are counted, and a clock that jitters loses none."""

import numpy as np
import pytest
from first_few import first_few

from pipeline.capture.printed import holes as judged
from pipeline.capture.printed.holes import PIECE, Steps, find

STEP_MS, COUNT = 20.0, 6000


def holes_of(times):
    steps = Steps()
    for each in times:
        steps.take(float(each))
    return find(map(float, times), steps.usual)


def clock(kind: str, count: int, seed: int):
    """Stamps in ms of samples of which none is lost."""
    random, even = np.random.default_rng(seed), STEP_MS * np.arange(count)
    if kind == "stamps jitter":
        return even + STEP_MS * random.uniform(-0.4, 0.4, count)
    if kind == "steps jitter":
        return np.cumsum(STEP_MS * (1.0 + random.uniform(-0.4, 0.4, count)))
    if kind == "stamps vary":
        return even + STEP_MS * random.normal(0.0, 0.2, count)
    if kind == "some stamps are late":
        return even + 0.7 * STEP_MS * (random.random(count) < 0.01)
    if kind == "stamps are late":
        return even + STEP_MS * random.exponential(0.15, count)
    if kind == "whole ms of 1.5 ms":
        return np.floor(1.5 * np.arange(count))
    if kind == "stamps jitter, and the loop gets slower":
        slower = np.cumsum(np.where(np.arange(count) < 0.6 * count, STEP_MS, 1.05 * STEP_MS))
        return slower + STEP_MS * random.uniform(-0.4, 0.4, count)
    return even


@pytest.mark.parametrize("count", first_few([300, COUNT, 3 * PIECE], 2))
@pytest.mark.parametrize(
    "kind",
    [
        "steady",
        "stamps jitter",
        "steps jitter",
        "stamps vary",
        "some stamps are late",
        "stamps are late",
        "whole ms of 1.5 ms",
        "stamps jitter, and the loop gets slower",
    ],
)
def test_a_clock_that_jitters_loses_no_sample(kind, count):
    for seed in range(3):
        assert holes_of(clock(kind, count, seed)) == (0, []), seed


@pytest.mark.parametrize(
    ("kind", "share", "hit_share"),
    [
        ("steady", 0.01, 0.999),
        ("steady", 0.05, 0.999),
        ("stamps jitter", 0.01, 0.95),
        ("stamps jitter", 0.05, 0.95),
        ("steps jitter", 0.01, 0.8),
        ("steps jitter", 0.05, 0.8),
        ("stamps vary", 0.01, 0.95),
        ("some stamps are late", 0.01, 0.95),
        ("whole ms of 1.5 ms", 0.01, 0.95),
    ],
)
def test_lost_samples_are_counted_in_a_clock_that_jitters_too(kind, share, hit_share):
    """The place of a hole is known to a few samples, where its own step is as long as others."""
    hits, lost, wrong = 0, 0, 0
    for seed in range(4):
        keep = np.random.default_rng(100 + seed).random(COUNT) > share
        keep[[0, -1]] = True
        after = np.flatnonzero(np.diff(np.flatnonzero(keep)) > 1) + 1
        _, holes = holes_of(clock(kind, COUNT, seed)[keep])
        apart = np.abs(after[:, None] - np.array([hole["after_samples"] for hole in holes])[None, :])
        hits, lost = hits + int((apart.min(axis=1) <= 4).sum()), lost + len(after)
        wrong += int((apart.min(axis=0) > 8).sum())
    assert hits >= hit_share * lost and wrong <= 0.01 * lost, (hits, lost, wrong)


def test_a_hole_is_as_long_as_it_was_and_hides_none_beside_it():
    for kind in ("steady", "stamps jitter"):
        keep = np.ones(COUNT, bool)
        keep[1000:1500] = keep[1600] = keep[1520:1522] = keep[3000] = False
        count, holes = holes_of(clock(kind, COUNT, 4)[keep])
        sizes = sorted(hole["samples_about"] for hole in holes)
        assert count == 4 and sizes[:3] == [1, 1, 2] and sizes[3] in (499, 500), (kind, holes)
        assert kind != "steady" or sizes[3] == 500


@pytest.mark.parametrize("piece", [PIECE // 8, pytest.param(PIECE, marks=pytest.mark.long)])
def test_the_pieces_that_are_judged_together_leave_no_seam(piece, monkeypatch):
    monkeypatch.setattr(judged, "PIECE", piece)
    for number in range(piece - 70, piece + 5, 3):
        for kind in ("steady", "stamps jitter"):
            keep = np.ones(2 * piece, bool)
            keep[number] = False
            count, holes = holes_of(clock(kind, 2 * piece, 2)[keep])
            assert count == 1 and abs(holes[0]["after_samples"] - number) <= 4, (kind, number, holes)
