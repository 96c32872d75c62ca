"""Explanations that come to the noise only if formulas err: page, details and figure say that they are left out."""

import copy

from made_content import content, explanation, full

from pipeline.diagnosis.words.named.effect_table import AT_A_STAND

ALONE = {"verdict": "explained", "alternatives": [], "next_run": None, "evidence__moved_sigma": {"radius_mm": 0.4}}
BEST = explanation(["creep", "friction_hysteresis"], "named", 0.03)


def joined(text):
    return " ".join(text.split())


def shown(*others):
    diagnosis = content(**ALONE)
    diagnosis["evidence"]["explanations"] = [explanation([], "nothing", 0.44), *others, BEST]
    return diagnosis


def test_what_comes_to_the_noise_only_if_formulas_err_is_left_out_and_said_to_be():
    near, far = explanation(["wear"], "beaten", 0.3, 0.03), explanation(["slack"], "beaten", 0.3, 0.2)
    text = joined(full(shown(far, near)))
    assert "of its size, 2 leaves no more than about the noise: it is left out all the same." in text
    assert "no other explanation fits as well. Only if formulas err by 10 %, no. 2 would." in text
    assert "Only if formulas err" not in joined(full(shown(far)))


def test_a_difference_in_the_last_digits_of_a_float_is_nothing():
    """`3.4 × 10^-17 mm` stood there."""
    diagnosis = shown(explanation(["wear"], "beaten", 0.03) | {"gap_mm": 3.4e-17})
    row = next(line for line in full(diagnosis).splitlines() if line.startswith("  2    wear"))
    assert row.endswith("nothing")


def test_no_page_says_what_goes_on_at_a_stand_where_the_motor_never_stood():
    """`is gone as soon as the motor stands`, and below it that the motor never stood long enough to say that."""
    diagnosis = shown()
    diagnosis["mechanisms"].append({"id": "viscous_loss", "rms_mm": {"value": 0.1, "low": 0.09, "high": 0.11},
                               "parameters": {}})  # fmt: skip
    diagnosis["evidence"]["spans_mm"]["viscous_loss"] = 0.2
    assert AT_A_STAND in joined(full(copy.deepcopy(diagnosis)))
    diagnosis["evidence"]["not_kept"] = [{"id": None, "left_mm": 0.03, "stands": {}, "tied": []}]
    assert AT_A_STAND not in joined(full(diagnosis))


def test_a_part_of_the_best_is_kept_for_a_reason():
    diagnosis = shown(explanation(["creep"], "tied", 0.2))
    diagnosis |= {"verdict": "ambiguous", "alternatives": [["creep"]]}
    text = joined(full(copy.deepcopy(diagnosis)))
    assert "Kept: 1 and 2. 2 is kept though 1 leaves less: what 1 adds to it may only mend a formula." in text
    diagnosis["evidence"]["explanations"][1]["ids"] = ["wear"]
    assert "Kept: 1 and 2. 2 is kept" not in joined(full(diagnosis))
