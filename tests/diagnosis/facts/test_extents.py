"""How far effects move the reading."""

from types import SimpleNamespace

import numpy as np

from pipeline.diagnosis.facts.extents import tops


def test_the_change_at_the_top_is_between_strokes_under_the_same_load():
    stroke = np.repeat([1, 2, 3], 10)
    motion = np.tile(np.linspace(0.0, 20.0, 10), 3)
    load = np.repeat([20.0, 20.4, 30.0], 10)
    record = SimpleNamespace(motion=motion, stroke=stroke, load=load)
    crept = np.repeat([0.0, 0.1, 0.5], 10)  # the last stroke creeps more, since its load is more
    assert tops({"creep": crept}, record) == {"creep": 0.1}
    assert tops({"creep": crept}, SimpleNamespace(**{**vars(record), "load": np.zeros(30)})) == {"creep": 0.5}
