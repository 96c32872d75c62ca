"""The pattern that the best explanation leaves."""

import copy

import pytest
from made_content import content, told


def test_a_pattern_that_is_left_without_a_name_is_told_with_its_size_and_place():
    verdict_fields = {
        "verdict": "parameters",
        "mechanisms": [],
        "alternatives": [],
        "next_run": None,
        "mismatch__rms_mm": 0.012,
    }
    box = {"motor_turns": [0.0, 6.0], "strokes": [1, 12], "phase": "hold", "share": 0.81}
    pattern = {"location": box, "driver": ["time under load"]}
    text = " ".join(told(content(**verdict_fields, evidence__pattern=pattern)).split())
    opening = (
        "Of the calibrated error in the table below, 0.012 mm rms is more than noise (0.4 times the noise), and no"
    )
    smaller = (
        "Some effects would have been seen even if they were smaller (listed below): what is left looks like none "
    )
    smaller += "of them."
    assert f"What is missing {opening} effect is named for it. {smaller}" in text
    share = "81 % of the energy of what is systematic in it lies at 0 to 6 turns, in holds. It follows time under load."
    assert share in text
    assert "What is missing" not in told(
        content(**verdict_fields | {"mismatch__rms_mm": 0.0}, evidence__pattern=pattern)
    )
    assert "if they were smaller" not in told(
        content(**verdict_fields | {"mismatch__rms_mm": 0.003}, evidence__pattern=pattern)
    )
    much = {"evidence__calibrated_mm": 0.06, "evidence__explanations": []}
    text = told(content(**verdict_fields, **much, evidence__pattern=pattern))
    assert "A pattern is left that no effect is named for." in text and text.count("is more than noise") == 1


def test_a_place_that_is_nearly_the_whole_range_is_told_as_that():
    somewhere = "80 % of its energy lies"
    for start, last, sentence in (
        (2.8, 12, "It is spread over the whole range."),
        (2.8, 11, "It is spread over the whole range."),
        (8.0, 12, f"{somewhere} at 8 to 30.7 turns."),
        (2.8, 6, f"{somewhere} in strokes 1 to 6."),
    ):
        box = {"motor_turns": [start, 30.7], "strokes": [1, last], "phase": "all", "share": 0.8}
        assert sentence in told(content(mismatch__location=box))


@pytest.mark.parametrize(("low", "is_stated"), [(0.02, True), (0.0305, False)])
def test_what_wrong_formulas_may_take_away_is_left_out_where_it_takes_all_away(low, is_stated):
    diagnosis = content()
    for explanation in diagnosis["evidence"]["explanations"]:
        explanation["with_discrepancy_mm"] = low if explanation["ids"] else 0.45
    alone = copy.deepcopy(diagnosis) | {"verdict": "explained", "alternatives": [], "next_run": None}
    for each in (diagnosis, alone):
        each["evidence"]["explanations"][-1]["left_mm"] = 0.05
        assert ("If a true effect may differ from its formula by 10 % of its size, " in told(each)) is not is_stated


@pytest.mark.parametrize(("left_mm", "is_stated"), [(0.04, True), (0.031, False)])
def test_the_pattern_that_the_best_explanation_leaves_is_told_with_place_and_driver(left_mm, is_stated):
    box = {"motor_turns": [20.0, 26.0], "strokes": [1, 2], "phase": "winding", "share": 0.8}
    diagnosis = content(evidence__pattern={"location": box, "driver": ["time"], "rms_mm": 0.021})
    diagnosis["evidence"]["explanations"][-1]["left_mm"] = left_mm
    who = "What friction_hysteresis + creep leaves"
    line = f"{who} holds a pattern of 0.021 mm rms beside the noise. It lies mostly at 20 to 26 turns, in strokes 1 "
    assert (f"{line}to 2, while winding, and follows the time." in " ".join(told(diagnosis).split())) is is_stated


def test_a_range_that_holds_the_pattern_and_half_of_it_is_said_once():
    box = {"motor_turns": [0.0, 20.0], "strokes": [1, 12], "phase": "all", "share": 0.8}
    diagnosis = content(evidence__pattern={"location": box, "driver": ["time"], "rms_mm": 0.021})
    diagnosis["evidence"]["pattern"]["half"] = {**box, "strokes": [7, 12], "share": 0.5}
    diagnosis["evidence"]["explanations"][-1]["left_mm"] = 0.04
    text = " ".join(told(diagnosis).split())
    assert (
        "beside the noise. Half of its energy lies at 0 to 20 turns, in strokes 7 to 12; it follows the time." in text
    )
    assert text.count("at 0 to 20 turns") == 1
