"""A stretch only shifts the reading with the load: a zero of each run takes it where the load is constant in each."""

from dataclasses import replace

import numpy as np
import pytest
from diagnosis.mechanisms.equation_motion import drivers

from pipeline.diagnosis.mechanisms.axial_elasticity import candidates
from pipeline.diagnosis.recording.drivers import Drivers


def two_runs(loads: tuple[float, float], free_zero: bool, swing: float = 0.0) -> Drivers:
    """Two runs of one motion, each under a load with the noise of its sensor, in 10 N; `swing` is within the second."""
    of = drivers("string")
    count = len(of.time_s)
    half = count // 2
    first = np.concatenate([np.arange(half), np.arange(count - half)])
    load = np.repeat(loads, [half, count - half]) + np.random.default_rng(0).normal(0.0, 0.005, count)
    load[half:] += swing * np.sin(of.time_s[half:])
    return replace(of, load=load, first=first, free_zero=free_zero, loaded=loads[0] != loads[1] or swing > 0.0)


@pytest.mark.parametrize(
    ("loads", "free_zero", "swing", "count"),
    [
        ((2.5, 4.5), True, 0.0, 0),  # two runs of one string under 25 and 45 N: 1.3 mm of stretch were said to be seen
        ((2.5, 4.5), False, 0.0, 1),  # a drive's reading has a zero of its own
        ((2.5, 4.5), True, 0.5, 1),
        ((2.5, 2.5), True, 0.0, 0),
    ],
)
def test_a_load_that_is_constant_in_each_run_shows_no_stretch(loads, free_zero, swing, count):
    assert len(candidates(two_runs(loads, free_zero, swing))) == count
