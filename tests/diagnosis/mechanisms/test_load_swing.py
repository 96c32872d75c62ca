"""A load that swings slowly and for long: its frequency must be known to the beat of the whole recording."""

import numpy as np
import pytest

from pipeline.diagnosis.mechanisms.library import mechanisms


@pytest.mark.parametrize("hz", [0.53, 0.778, 1.32])
def test_a_slow_swing_is_suggested_to_half_a_hundredth(problem, hz) -> None:
    time_s = problem.record.time_s
    noise = 0.05 * np.random.default_rng(2).standard_normal(len(time_s))
    suggested = mechanisms()["load_swing"].suggest(
        problem.drivers, np.sin(2.0 * np.pi * hz * time_s) + noise, problem.measured
    )
    assert min(abs(each["frequency_hz"] / hz - 1.0) for each in suggested) < 0.005
    assert not any("second_hz" in each for each in suggested)  # the line leaks into its neighbours, which are none
