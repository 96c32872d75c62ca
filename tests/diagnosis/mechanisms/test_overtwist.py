"""The class of overtwist: coils that are born one by one, each with a loop of its own."""

import numpy as np
import pytest
from coils_made import coils
from left_by_class import left_by_class


@pytest.mark.parametrize(("loop", "most"), [(0.09, 0.16), (0.17, 0.12), (0.2, 0.11)])
def test_coils_come_and_go_one_by_one(problem, loop, most) -> None:
    turns, top = problem.drivers.motion, float(np.percentile(problem.drivers.motion, 99.9))
    coil_counts = coils(turns, 0.6 * top, top, 16, loop * top)
    assert left_by_class(problem, "overtwist", -coil_counts) < most
