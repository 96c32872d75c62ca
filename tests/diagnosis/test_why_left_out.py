"""Explanations that are likely enough to be kept and are no names: by which rule, and what the pages say of it."""

from types import SimpleNamespace

import pytest
from made_content import full, page, told, weighed

from pipeline.diagnosis.choice import kept
from pipeline.diagnosis.choice.judged import Judged, LeftOut
from pipeline.diagnosis.words.explanations.not_named import BECAUSE
from pipeline.diagnosis.words.explanations.probability import at_work

OUT = {
    "ids": ["friction_hysteresis", "sensor_drift"],
    "probability": 0.4,
    "because": "dimensions",
    "of": ["sensor_drift"],
}
SAID = "what sensor_drift would do here, moved dimensions do as well but for a thousandth of it"


@pytest.fixture
def three(monkeypatch):
    """A judgement of three explanations, each of an effect of its own, and a search in which none is a disguise."""
    names = [SimpleNamespace(ids=(id_,)) for id_ in ("creep", "wear", "jam")]
    monkeypatch.setattr(kept, "Linear", lambda *_: None)
    monkeypatch.setattr(kept, "in_disguise", lambda linear, explanation, dimensions: None)
    monkeypatch.setattr(kept, "no_name", lambda problem, state, dimensions: None)
    monkeypatch.setattr(kept, "cancels", lambda problem, state: False)
    monkeypatch.setattr(kept, "at_work", lambda search, explanation: explanation.ids)
    return SimpleNamespace(linear=SimpleNamespace(problem=None)), Judged(names, {}, 0.0)


def test_what_is_a_name_stays_and_nothing_is_left_out(three):
    best, judgement = kept.kept(*three, None)
    assert best == ("creep",) and len(judgement.sets) == 3 and judgement.left_out == ()


def test_each_explanation_that_is_no_name_is_left_out_with_the_rule_that_did_it(three, monkeypatch):
    why = {("wear",): ("dimensions", ("wear",))}
    monkeypatch.setattr(kept, "in_disguise", lambda linear, explanation, dimensions: why.get(explanation.ids))
    monkeypatch.setattr(
        kept, "no_name", lambda problem, state, dimensions: ("idle", ()) if state == ("creep",) else None
    )
    best, judgement = kept.kept(*three, None)
    assert best == ("jam",) and [each.ids for each in judgement.sets] == [("jam",)]
    assert judgement.left_out == (LeftOut(("wear",), "dimensions", ("wear",)), LeftOut(("creep",), "idle", ()))


def test_effects_that_cancel_are_left_out_only_where_another_explanation_stays(three, monkeypatch):
    monkeypatch.setattr(kept, "cancels", lambda problem, state: True)
    best, judgement = kept.kept(*three, None)
    assert best == ("jam",) and [each.because for each in judgement.left_out] == ["cancels", "cancels"]


def left_out(**changes):
    """A verdict of two explanations, of 30 and 20 %, that leaves out one of 40 %."""
    diagnosis = weighed(0.004, 0.4, 0.2, 0.02, 0.3)
    diagnosis["evidence"]["left_out"] = [OUT | changes]
    return diagnosis


def test_an_explanation_that_is_likelier_than_the_best_one_is_named_with_the_rule_that_leaves_it_out():
    text = " ".join(full(left_out()).split())
    assert (
        "3 friction_hysteresis + sensor_drift, left out 40 %" in text and "1 friction_hysteresis + creep 30 %" in text
    )
    assert f"Left out, however probable: friction_hysteresis + sensor_drift (40 %). The reason: {SAID}" in text
    short = " ".join(page(left_out()).split())
    assert "friction_hysteresis + sensor_drift 40 % left out: see below" in short and "30 % the best one" in short
    assert "of what it can tell from moved dimensions the recording agrees best with" in text
    assert "less likely" not in text.partition("How probable each")[2].partition("What is missing")[0]
    details = told(left_out())
    assert "Kept: 2 explanations, 50 % together" in details
    assert (
        "One likely explanation is left out (40 %), so less than 80 % is kept; the percentages of effects do not"
        in details
    )


def test_the_share_of_what_is_left_out_is_that_of_the_others():
    diagnosis = left_out()
    counted = 0.004 + 0.4 + 0.2 + 0.02 + 0.3
    with_creep = sum(entry["probability"] for entry in diagnosis["evidence"]["explanations"] if "creep" in entry["ids"])
    assert at_work(diagnosis, "creep") == pytest.approx(with_creep * (counted + 0.4) / counted)
    assert at_work(diagnosis, "jam") == 0.0
    for entry in diagnosis["mechanisms"]:
        entry["confidence"] = 0.7
    share = "are the share of explanations with each, of all that are not left out; the best one alone has 30 %."
    assert share in " ".join(page(diagnosis).split())


@pytest.mark.parametrize("because", BECAUSE)
def test_every_rule_has_words(because):
    reason = page(left_out(because=because)).partition("The reason: ")[2].partition("How far")[0]
    assert reason and "{" not in reason


def test_without_anything_left_out_the_pages_say_nothing_of_it():
    diagnosis = weighed(0.004, 0.06, 0.31, 0.02, 0.52)
    assert "left out" not in page(diagnosis) and "left out" not in told(diagnosis)
