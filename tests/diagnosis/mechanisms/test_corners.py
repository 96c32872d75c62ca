"""What begins past a corner near the end of the motion: a stop and a jam are tried where the grid has no candidate."""

from dataclasses import replace

import numpy as np
import pytest
from left_by_class import left_by_class

from pipeline.diagnosis.mechanisms.library import mechanisms


@pytest.mark.parametrize("held_share", [0.002, 0.006])
def test_a_stop_that_holds_a_few_thousandths_of_the_range_is_suggested(problem, held_share) -> None:
    reading = problem.drivers.contraction
    stop = reading.max() - held_share * np.ptp(reading)
    measured = np.minimum(reading, stop) + 1e-4 * np.random.default_rng(0).standard_normal(len(reading))
    stops = mechanisms()["end_stop"]
    suggested = stops.suggest(problem.drivers, measured - reading, reading)
    near = [abs(reading[0] + each["stop_mm"] - stop) / np.ptp(reading) for each in suggested]
    on_grid = [abs(reading[0] + each["stop_mm"] - stop) / np.ptp(reading) for each in stops.candidates(problem.drivers)]
    assert min(near) < 0.1 * held_share < min(on_grid)


def test_a_stop_is_suggested_only_where_a_string_is_wound(problem) -> None:
    reading = problem.drivers.contraction
    assert mechanisms()["end_stop"].suggest(replace(problem.drivers, levered=False), 0.0 * reading, reading) == []


@pytest.mark.parametrize("onset", [0.975, 0.985, 0.99])
def test_a_jam_may_begin_within_the_last_turn(problem, onset) -> None:
    turns = problem.drivers.motion
    lost_turns = -0.6 * np.maximum(turns - onset * np.percentile(turns, 99.9), 0.0)
    assert left_by_class(problem, "jam", lost_turns) < 0.05
