"""How far effects move the reading."""

from types import SimpleNamespace

import numpy as np

from pipeline.diagnosis.facts import mechanism_entries
from pipeline.diagnosis.facts.evidence import evidence
from pipeline.diagnosis.facts.extents import sums, tops


def test_the_change_at_the_top_is_between_strokes_under_the_same_load():
    stroke = np.repeat([1, 2, 3], 10)
    motion = np.tile(np.linspace(0.0, 20.0, 10), 3)
    load = np.repeat([20.0, 20.4, 30.0], 10)
    record = SimpleNamespace(motion=motion, stroke=stroke, load=load)
    crept = np.repeat([0.0, 0.1, 0.5], 10)  # the last stroke creeps more, since its load is more
    assert tops({"creep": crept}, record) == {"creep": 0.1}
    assert tops({"creep": crept}, SimpleNamespace(**{**vars(record), "load": np.zeros(30)})) == {"creep": 0.5}


def test_two_slow_effects_nearly_cancel_where_their_sum_spans_less_than_half_of_the_larger():
    course = np.linspace(0.0, 1.0, 2001)
    effects = {"sensor_drift": 1.2 * course, "creep": -course, "friction_hysteresis": -1.1 * course}
    assert list(sums(effects)) == ["sensor_drift + creep"], "a loop is not slow"
    assert np.isclose(sums(effects)["sensor_drift + creep"], 0.2, rtol=0.01)
    assert sums(effects | {"creep": -0.55 * course}) == {}, "more than half is left"
    assert sums(effects | {"creep": course}) == {}, "they add up"
    assert list(sums(effects | {"creep": 0.3 - course})) == ["sensor_drift + creep"], "wherever its zero is"


def test_the_facts_of_a_study_have_the_sum_of_slow_effects_only_where_they_nearly_cancel(studied, monkeypatch):
    study, _, _ = studied("creep")
    crept = mechanism_entries.named_effects(study)["creep"]
    assert "sums_mm" not in evidence(study)
    monkeypatch.setattr(mechanism_entries, "named_effects", lambda _: {"creep": crept, "sensor_drift": -0.9 * crept})
    facts = evidence(study)
    assert np.isclose(facts["sums_mm"]["creep + sensor_drift"], 0.1 * facts["spans_mm"]["creep"])
