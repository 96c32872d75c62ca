"""What a slow effect under one load could be instead."""

from dataclasses import replace

import pytest
from made_content import SYSTEMS

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named import certainty, slow_look_alikes


@pytest.mark.parametrize(
    ("loaded", "named", "looks_alike"), [(False, "creep", True), (True, "creep", False), (False, "jam", False)]
)
def test_under_one_load_a_slow_effect_is_said_to_look_like_the_others(loaded, named, looks_alike):
    evidence = {"loaded": loaded, "moved_sigma": {}, "explanations": []}
    evidence = {"loaded": loaded, "moved_sigma": {}, "explanations": []}
    diagnosis = {"mechanisms": [{"id": "slack"}, {"id": named}], "evidence": evidence, "alternatives": []}
    diagnosis["verdict"] = "explained"
    lines = slow_look_alikes.lines(diagnosis, Vocabulary.of(SYSTEMS["mm"]))
    assert slow_look_alikes.lines(diagnosis, replace(Vocabulary.of(SYSTEMS["mm"]), load=None)) == [], (
        "a rig without a load"
    )
    assert len(lines) == (5 if looks_alike else 0)
    if looks_alike:
        assert lines[0] == (
            "Under one load slow effects look alike. That something slow acts is likely; its name is not sure. "
            "What creep could be instead:"
        )
        assert [line.partition(":")[0] for line in lines[1:]] == [
            "- plastic_elongation", "- sensor_drift", "- stiffening", "- wear",
        ]  # fmt: skip
        slow = {"unit": "mm/10N", "value": 0.3}
        diagnosis["mechanisms"][1]["parameters"] = {"load_240_s_mm_per_10_n": slow, "rate": {"unit": "1", "value": 9.0}}
        request = certainty.asks(diagnosis, Vocabulary.of(SYSTEMS["mm"]))[0]
        assert request.startswith("What tells creep from what looks like it: a hold under load, then a rest under less")
        assert "Hold and rest for 8 min or longer each" in request and "The run below" not in request
        assert certainty.asks(diagnosis | {"next_run": {"legs": []}}, Vocabulary.of(SYSTEMS["mm"]))[0].endswith(
            "not this test."
        )
    else:
        assert certainty.asks(diagnosis, Vocabulary.of(SYSTEMS["mm"])) == []


def test_a_name_is_not_called_unsure_where_the_recording_excludes_every_look_alike():
    jumps = {"change": 0.5, "error": 0.01}
    names = ("plastic_elongation", "sensor_drift", "stiffening", "wear")
    kept = [{"id": "creep", "stands": {}}, *({"id": id_, "stands": {"hold": jumps}} for id_ in names)]
    evidence = {"loaded": False, "moved_sigma": {}, "explanations": [], "not_kept": kept, "floor_mm": 0.05}
    diagnosis = {"mechanisms": [{"id": "creep"}], "evidence": evidence, "alternatives": [], "verdict": "explained"}
    words = Vocabulary.of(SYSTEMS["mm"])
    (sentence,) = slow_look_alikes.lines(diagnosis, words)
    assert slow_look_alikes.still_open(diagnosis, words) == [] and slow_look_alikes.doubts(diagnosis, words) == []
    by = "(by 0.50 mm in a hold)"
    out = f"plastic_elongation {by}, sensor_drift {by}, stiffening {by} and wear {by}"
    assert sentence.startswith(
        "Under one load slow effects look alike. Measured: with one of these in the place of creep what is left "
        f"changes while the motor stands, by more than the noise: {out}. Each was tried by the library's formula, "
        "where it leaves least (Why it is none of the other effects says where)."
    )


def test_what_is_wrong_while_the_motor_stands_by_less_than_the_noise_is_not_excluded():
    """The load swung by 2 %: it bent the fit of creep, which was the truth, by a third of the noise in each hold."""
    kept = [
        {"id": "sensor_drift", "stands": {}},
        {"id": "creep", "left_mm": 0.06, "stands": {"hold": {"change": 0.02, "error": 0.004}}},
        {"id": "wear", "left_mm": 0.09, "stands": {"hold": {"change": 0.06, "error": 0.004}}},
    ]
    evidence = {"loaded": False, "moved_sigma": {}, "explanations": [], "not_kept": kept, "floor_mm": 0.05}
    diagnosis = {
        "mechanisms": [{"id": "sensor_drift"}],
        "evidence": evidence,
        "alternatives": [],
        "verdict": "explained",
    }
    words = Vocabulary.of(SYSTEMS["mm"])
    assert slow_look_alikes.excluded(diagnosis, words) == ["wear"] and "creep" in slow_look_alikes.still_open(
        diagnosis, words
    )
    lines = slow_look_alikes.lines(diagnosis, words)
    assert "wear (by 0.060 mm in a hold)" in lines[0] and not any("creep (by" in line for line in lines)
    assert any(
        line.startswith("- creep: the library's formula of it leaves 0.060 mm (1.2 times the noise)") for line in lines
    )
    assert "creep" in slow_look_alikes.doubts(diagnosis, words)[0]


@pytest.mark.parametrize(
    ("named", "covered", "is_doubted"),
    [
        ("thermal", {}, True),
        ("thermal", {"temperature_c": [20.0, 25.0]}, False),
        ("thermal", None, False),
        ("creep", {}, True),
    ],
)
def test_a_temperature_that_nobody_logged_is_one_slow_effect_among_others(named, covered, is_doubted):
    """`thermal (71 %)` stood on a page without a doubt; the string lengthened, and nobody had a thermometer."""
    evidence = {"loaded": False, "moved_sigma": {}, "explanations": []}
    evidence |= {} if covered is None else {"covered": covered}
    diagnosis = {"mechanisms": [{"id": named}], "evidence": evidence, "alternatives": [], "verdict": "explained"}
    doubts = slow_look_alikes.doubts(diagnosis, Vocabulary.of(SYSTEMS["mm"]))
    assert bool(doubts) is is_doubted
    if is_doubted:
        assert f"what is called {named} can be {'creep, ' if named == 'thermal' else ''}plastic_elong" in doubts[0]
        assert ("thermal or wear" in doubts[0]) is (named == "creep")
