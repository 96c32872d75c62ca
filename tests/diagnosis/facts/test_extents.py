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
    course, run = np.linspace(0.0, 1.0, 2001), SimpleNamespace(run_index=np.zeros(2001, int))
    effects = {"sensor_drift": 1.2 * course, "creep": -course, "friction_hysteresis": -1.1 * course}
    assert list(sums(effects, run)) == ["sensor_drift + creep"], "a loop is not slow"
    assert np.isclose(sums(effects, run)["sensor_drift + creep"], 0.2, rtol=0.01)
    assert sums(effects | {"creep": -0.55 * course}, run) == {}, "more than half is left"
    assert sums(effects | {"creep": course}, run) == {}, "they add up"
    assert list(sums(effects | {"creep": 0.3 - course}, run)) == ["sensor_drift + creep"], "wherever its zero is"


def test_what_lies_between_two_runs_hides_no_effects_that_cancel_in_each():
    """A drift goes on in the break, from which creep has recovered; each run has a zero of its own."""
    run_index = np.repeat([0, 1], 1000)
    course = np.tile(np.linspace(0.0, 1.0, 1000), 2)
    effects = {"sensor_drift": course + 5.0 * run_index, "creep": -0.9 * course}
    together = sums(effects, SimpleNamespace(run_index=run_index))
    assert np.isclose(together["sensor_drift + creep"], 0.1, rtol=0.01)
    assert sums(effects, SimpleNamespace(run_index=np.zeros(2000, int))) == {}


def test_the_facts_of_a_study_have_the_sum_of_slow_effects_only_where_they_nearly_cancel(studied, monkeypatch):
    study, _, _ = studied("creep")
    crept = mechanism_entries.named_effects(study)["creep"]
    assert "sums_mm" not in evidence(study)
    monkeypatch.setattr(mechanism_entries, "named_effects", lambda _: {"creep": crept, "sensor_drift": -0.9 * crept})
    facts = evidence(study)
    assert np.isclose(facts["sums_mm"]["creep + sensor_drift"], 0.1 * facts["spans_mm"]["creep"])  # of one run
