"""What held-out strokes went to beyond the strokes before them."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.facts.beyond_seen import beyond_seen

TIME_S = np.arange(0.0, 100.0, 0.1)


@pytest.mark.parametrize(
    ("load", "top", "wider"),
    [(10.0, 20.0, set()), (30.0, 20.0, {"load"}), (10.5, 30.0, {"motion"}), (2.0, 15.0, {"load"})],
)
def test_only_what_lies_outside_of_the_strokes_before_is_beyond_them(load, top, wider):
    later = TIME_S >= 70.0
    turns = np.abs(np.sin(TIME_S)) * np.where(later, top, 20.0)
    record = SimpleNamespace(time_s=TIME_S, load=np.where(later, load, 10.0), motion=turns)
    ranges = beyond_seen(record, 70.0)
    assert set(ranges) == wider
    if "load" in wider:
        assert ranges["load"] == [[10.0, 10.0], [load, load]]
