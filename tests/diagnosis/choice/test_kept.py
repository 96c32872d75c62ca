"""How an explanation is fitted again, and which of the likely ones is looked at first."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import kept
from pipeline.diagnosis.choice.judged import Judged, LeftOut

FLOOR = 0.1


def at_work(monkeypatch, apart, differentiates=False, beyond=0.0):
    """What `at_work` gives where two ways to weigh samples are `apart` in what is seen, and what it asked for."""
    adopted, new, calls = SimpleNamespace(id="creep"), SimpleNamespace(id="jam"), []
    refined = SimpleNamespace(acts=(adopted, new))
    simulated = {"refined": np.zeros(4), "alike": np.array([apart, -apart, beyond, beyond])}

    def calibrate(problem, noise, state, acts):
        calls.append((noise, state, acts))
        return "alike"

    monkeypatch.setattr(kept.calibrate, "refine", lambda problem, noise, state: calls.append((noise, state)) or refined)
    monkeypatch.setattr(kept.calibrate, "calibrate", calibrate)
    problem = SimpleNamespace(
        included=(adopted,), rows=2, system=SimpleNamespace(differentiates=differentiates),
        simulate=lambda state: simulated["alike" if state == "alike" else "refined"],
    )  # fmt: skip
    noise = SimpleNamespace(floor=FLOOR)
    linear = SimpleNamespace(problem=problem, noise=noise, state_of=lambda fit, keys: (fit, keys))
    state = kept.at_work(SimpleNamespace(linear=linear), SimpleNamespace(fit="fit", keys="keys"))
    (first_noise, linearised), (plain, start, acts) = calls
    assert first_noise is noise and linearised == ("fit", "keys")
    assert start is refined and acts == (new,), "what is adopted stays as it is"
    assert plain.floor == FLOOR and len(plain.ar) == 0, "samples that are weighed alike"
    return "alike" if state == "alike" else "by its noise"


@pytest.mark.parametrize(
    ("floors", "beyond", "weighed"),
    [(0.19, 0.0, "by its noise"), (0.21, 0.0, "alike"), (0.0, 9.0, "by its noise")],
)
def test_where_two_ways_to_weigh_samples_part_the_plain_one_is_taken(monkeypatch, floors, beyond, weighed):
    """What counts is how far they part in the rows that a fit sees."""
    assert at_work(monkeypatch, floors * FLOOR, beyond=beyond) == weighed


def test_a_reading_that_follows_derivatives_has_samples_weighed_alike(monkeypatch):
    assert at_work(monkeypatch, 0.0, differentiates=True) == "alike"


@pytest.fixture
def looked_at(monkeypatch):
    """Three likely explanations, a search and what was asked of each; none is a disguise, none cancels."""
    calls = []
    monkeypatch.setattr(kept, "Linear", lambda *arguments: calls.append(arguments) or "dimensions")
    monkeypatch.setattr(kept, "in_disguise", lambda linear, explanation, dimensions: None)
    monkeypatch.setattr(kept, "no_name", lambda problem, state, dimensions: calls.append((state, dimensions)))
    monkeypatch.setattr(kept, "cancels", lambda problem, state: False)
    monkeypatch.setattr(kept, "at_work", lambda search, explanation: explanation.ids)
    linear = SimpleNamespace(problem="problem", noise=SimpleNamespace(floor=FLOOR))
    sets = [SimpleNamespace(ids=(id_,)) for id_ in ("creep", "jam")]
    before = LeftOut(("wear",), "idle", ())
    return SimpleNamespace(linear=linear), Judged(sets, {("creep",): 0.7}, 0.1, (), (before,)), calls


def test_dimensions_alone_are_what_a_name_is_held_against_and_the_judgement_stays(looked_at):
    search, judgement, calls = looked_at
    best, after = kept.kept(search, judgement, "base")
    assert best == ("creep",) and after == judgement
    (problem, base, noise, catalogue), (state, dimensions) = calls
    assert (problem, base, catalogue) == ("problem", "base", {}) and noise.floor == 1.0 and len(noise.ar) == 0
    assert (state, dimensions) == (("creep",), "dimensions")


def test_where_no_explanation_is_a_name_the_calibrated_simulator_is_left(looked_at, monkeypatch):
    search, judgement, _ = looked_at
    monkeypatch.setattr(kept, "in_disguise", lambda linear, explanation, dimensions: ("dimensions", explanation.ids))
    best, after = kept.kept(search, judgement, "base")
    assert best == "base" and after.sets == [] and after.likely == judgement.likely
    assert [each.ids for each in after.left_out] == [("wear",), ("creep",), ("jam",)]
    monkeypatch.setattr(kept, "in_disguise", lambda linear, explanation, dimensions: None)
    monkeypatch.setattr(kept, "no_name", lambda problem, state, dimensions: ("idle", ("jam",)))
    best, after = kept.kept(search, judgement, "base")
    assert best == "base" and after.sets == []
    assert [(each.because, each.of) for each in after.left_out[1:]] == [("idle", ("jam",))] * 2


def test_of_two_that_cancel_the_last_stays(looked_at, monkeypatch):
    search, judgement, _ = looked_at
    monkeypatch.setattr(kept, "cancels", lambda problem, state: True)
    best, after = kept.kept(search, judgement, "base")
    assert best == ("jam",) and after.left_out[1:] == (LeftOut(("creep",), "cancels", ()),)
