"""What ties, what was beaten, and why."""

import re

from made_content import content, told


def test_what_all_ties_share_and_why_each_rival_was_beaten():
    text = told()
    section = text.partition("\nExplanations, the best one first\n")[2].partition("\n\n")[0]
    rows = [re.split(" {2,}", row.strip()) for row in section.splitlines()[:7]]
    assert rows == [
        ["no.", "explanation", "leaves (× noise)", "rms apart from no. 1"],
        ["1", "friction_hysteresis + creep", "0.030 mm (1.0)", "–"],
        ["2", "friction_hysteresis + thermal", "0.070 mm (2.3)", "0.070 mm"],
        ["3", "friction_hysteresis + sensor_drift", "0.030 mm (1.0)", "0.070 mm"],
        ["4", "creep", "0.060 mm (2.0)", "0.070 mm"],
        ["5", "friction_hysteresis + creep + wear", "0.030 mm (1.0)", "–"],
        ["–", "calibration alone", "0.45 mm (15)", "–"],
    ]
    assert text.count("If a true effect may differ from its formula by 10 % of its size, 2 leaves 1.0 times") == 1
    assert (
        "Where their readings are farthest from that of no. 1: at 0 to 12.2 turns, in strokes 2 to 4, at rest, "
        "following the" in section
    )
    assert "than 3 by 20 standard deviations." in section
    adds = "5 adds wear to 1, which takes away"
    assert f"{adds} nothing (less than 0.2 times the noise)." in section, "as the table of other effects says it"
    diagnosis = content()
    diagnosis["evidence"]["explanations"][4]["left_mm"] = 0.028
    assert f"{adds} 0.011 mm rms more: too little for one effect more." in told(diagnosis)


def test_what_is_nearly_as_good_as_the_best_is_put_beside_its_number():
    diagnosis = content()
    for left_mm, ratio in ((0.0308, "1.0"), (0.0292, "1.0")):
        diagnosis["evidence"]["explanations"][2]["left_mm"] = left_mm
        assert re.search(rf"3 +friction_hysteresis \+ sensor_drift +{left_mm:.3f} mm \({ratio}\)", told(diagnosis))
        assert "By the noise of the samples alone, explanation 1 fits better than 3 by 20 standard deviations." in told(
            diagnosis
        )
    diagnosis["evidence"]["explanations"][2]["worse"] = 0.0
    text = " ".join(told(diagnosis).split())
    unweighed = "Not weighed, since the recording lacks a mark of its effects, or cheaper ones of its size are many"
    assert f"{unweighed}: 3." in text


def test_explanations_without_a_common_mechanism_are_told_so_with_what_it_means():
    text = told(content(alternatives=[["thermal"]]))
    assert "The two explanations have no mechanism in common: any of these effects may be the missing one." in text


def test_what_most_explanations_share_is_said():
    others = [["creep"], ["creep", "wear"], ["slack"]]
    text = told(content(alternatives=others))
    assert "3 of the 4 explanations have creep; no mechanism is in all of them." in text
    text = told(content(alternatives=[["friction_hysteresis"], ["wear"], ["slack"]]))
    assert "The 4 explanations have no mechanism in common: any of these effects may be the missing one." in text


def test_of_no_explanation_is_said_that_it_leaves_more_than_no_effect_does():
    """`end_stop: leaves 26 N rms` stood above `calibration alone: leaves 15 N rms`."""
    diagnosis = content(evidence__calibrated_mm=0.4)
    diagnosis["evidence"]["explanations"][1]["left_mm"] = 0.7
    assert re.search(r"\n +4 +creep +as much as no effect +", told(diagnosis))
    diagnosis["evidence"]["explanations"][1]["left_mm"] = 0.3
    assert re.search(r"\n +4 +creep +0\.30 mm \(10\) +", told(diagnosis))
