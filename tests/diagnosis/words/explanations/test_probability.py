"""How probable each explanation is, and which are kept."""

import re

import pytest
from made_content import content, parameter, told, weighed

from pipeline.diagnosis.facts.zero_effects import without_zero_effects


def test_each_explanation_comes_with_its_probability_and_the_rule_that_rules_out():
    text = " ".join(told(weighed(0.004, 0.06, 0.31, 0.02, 0.52)).split())
    assert text.startswith(
        "nylon-3: friction_hysteresis is in both likely explanations; it is not known which of creep and thermal acts "
        "beside it (ambiguous). "
    )
    assert "2 friction_hysteresis + thermal 31 % 0.070 mm (2.3)" in text
    assert "friction_hysteresis + sensor_drift 6 % 0.030 mm (1.0)" in text
    assert "4 friction_hysteresis + creep + wear 2 %" in text and "4 adds wear to 1, which takes away" in text
    assert text.index("+ sensor_drift 6 %") < text.index(" creep less than 1 % 0.060 mm (2.0)")
    rule = "the likeliest, until they have 80 % of what the library's have together. None of the others is impossible."
    assert f"Kept: 2 explanations, 83 % together: {rule}" in text
    assert "all others of the library 4 % – – – physics that the library lacks 4 %" in text
    assert "ruled out" not in text
    alone = {"verdict": "explained", "alternatives": [], "next_run": None}
    text = " ".join(told(weighed(0.0, 0.0, 0.0, 0.01, 0.99, none=0.001, **alone)).split())
    assert "Kept: 1 explanation, 99 %. None of the others is impossible." in text and "the likeliest, until" not in text
    none = (
        "Why less likely than no. 1: since the same effects with one more leave less of the recording (no. 2, 4 and 5)."
    )
    assert " creep less than 1 % 0.060 mm (2.0) " in text and none in text


def test_where_no_probability_is_known_the_rule_is_another_and_an_old_file_has_none():
    text = told(content(evidence__probability_of_none=None))
    assert "No probabilities are known on this rig: they were learnt on strings." in text and "probability" not in (
        text.replace("No probabilities", "").lower()
    )
    assert "left out where" not in told()
    unknown = {"verdict": "unknown", "mechanisms": [], "alternatives": [], "next_run": None}
    text = " ".join(told(weighed(0.3, 0.1, 0.0, 0.1, 0.02, none=0.48, **unknown)).split())
    assert re.search(r" creep 9\d % 0\.\d+ mm \([0-9.]+\) 30 % not likely enough ", text)
    assert "no explanation of the library is good enough; physics that it lacks has a probability of 48 %." in text
    assert "To be named, an explanation must take away 90 % of what is missing (of its energy" in text
    for shares in ((0.3, 0.1, 0.0, 0.1, 0.02), (0.02, 0.1, 0.0, 0.1, 0.3)):
        details = " ".join(told(weighed(*shares, none=0.48, **unknown)).split())
        ordered = [int(share) for share in re.findall(r" mm \([0-9.]+\) ([0-9]+) %", details)]
        assert ordered == sorted(ordered, reverse=True) and len(set(ordered)) > 1
    assert "and be likely. Where physics that the library lacks has 40 % or more, nothing is named." in text


def test_two_explanations_that_an_idle_effect_made_different_share_one_probability():
    diagnosis = weighed(0.1, 0.1, 0.1, 0.1, 0.5)
    diagnosis["evidence"]["explanations"][3] |= {"ids": ["friction_hysteresis"]}
    diagnosis["alternatives"] = [["friction_hysteresis"]]
    diagnosis["mechanisms"][1]["rms_mm"] = parameter(0.0, "mm")
    diagnosis["simulation"] = [{"id": id_, "parameters": {}} for id_ in ("friction_hysteresis", "creep")]
    (best,) = [
        explanation
        for explanation in without_zero_effects(diagnosis, "mm")["evidence"]["explanations"]
        if explanation["standing"] == "named"
    ]
    assert best["ids"] == ["friction_hysteresis"] and best["probability"] == pytest.approx(0.6)
