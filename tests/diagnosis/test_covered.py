"""What a recording covers: loads, speeds, holds and rests, as they were made."""

import numpy as np
import pytest

from pipeline.diagnosis.covered import covered
from pipeline.diagnosis.record import PHASES, Record


def record(run_index=None) -> Record:
    """Two strokes at 2 and 4 turns a second under 10 and 20 N, with a hold of 3 s and rests of 5 and 1 s."""
    legs = [("rest", 0, 5.0, 0.0, 10.0), ("winding", 1, 4.0, 2.0, 10.0), ("hold", 1, 3.0, 0.0, 10.0),
            ("unwinding", 1, 4.0, -2.0, 10.0), ("rest", 1, 1.0, 0.0, 20.0), ("winding", 2, 2.0, 4.0, 20.0),
            ("unwinding", 2, 2.0, -4.0, 20.0)]  # fmt: skip
    counts = [round(100 * seconds) for _, _, seconds, _, _ in legs]

    def each(column: int):
        return np.repeat([leg[column] for leg in legs], counts)

    time_s, velocity = 0.01 * np.arange(sum(counts)), each(3).astype(float)
    motion = np.cumsum(velocity) * 0.01
    phase = np.array([PHASES.index(name) for name in each(0)])
    index = np.zeros(len(time_s), int) if run_index is None else run_index(time_s)
    return Record(
        time_s, motion, velocity, 0.0 * motion, motion, each(4).astype(float), None, None, each(1), phase, index
    )


def test_loads_speeds_holds_and_rests_are_those_that_were_made():
    found = covered(record())
    assert found["load"] == [10.0, 20.0] and found["speed_per_s"] == pytest.approx([2.0, 4.0])
    assert found["longest_hold_s"] == pytest.approx(3.0, abs=0.02)
    assert found["longest_rest_s"] == pytest.approx(5.0, abs=0.02)


def test_a_rest_does_not_go_on_from_one_run_to_the_next():
    found = covered(record(lambda time_s: (time_s >= 3.0).astype(int)))
    assert found["longest_rest_s"] == pytest.approx(3.0, abs=0.02)
