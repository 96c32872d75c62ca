"""The band of futures that is drawn."""

import numpy as np
import pytest

from pipeline.lifespan.forecast.band import until


def test_a_band_ends_where_the_limit_is_surely_passed():
    """Stretched times of passing were drawn far beyond the limit: an error that rose by 0.05 a stroke looked flat."""
    ahead, edge = np.array([0.0, 1.0, 20.0]), np.array([1.0, 2.0, 2.1])
    kept, (cut,) = until(1.5, ahead, [edge])
    assert kept.tolist() == [0.0, 1.0, 1.5] and cut == pytest.approx([1.0, 2.0, 2.0 + 0.1 * 0.5 / 19.0])
    kept, (whole,) = until(np.inf, ahead, [edge])
    assert kept is ahead and whole is edge
