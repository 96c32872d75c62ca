"""What ties, what was beaten, and why."""

from made_content import SYSTEMS, content, told

from pipeline.diagnosis.words.explanations import rivals
from pipeline.diagnosis.words.language.vocabulary import Vocabulary

WORDS = Vocabulary.of(SYSTEMS["mm"])


def test_what_all_ties_share_and_why_each_rival_was_beaten():
    text = told()
    assert "friction_hysteresis + creep leaves 0.030 mm rms (1.0 times the noise)." in text
    assert "Both explanations have friction_hysteresis. The other one is:" in text
    assert "friction_hysteresis + thermal: leaves 0.070 mm rms (2.3 times the noise)." in text
    allowed = (
        "If a true effect may differ from its formula by 10 % of its size, friction_hysteresis + thermal leaves 1.0"
    )
    assert text.count(allowed) == 1
    beaten = text[text.index("Why no other explanation") :]
    assert "creep: leaves 0.060 mm rms (2.0 times the noise). Its prediction differs from the best one by" in beaten
    assert "at 0 to 12.2 turns, in strokes 2 to 4, at rest. This difference follows the time." in beaten
    same = "friction_hysteresis + sensor_drift: leaves 0.030 mm rms (1.0 times the noise), the same as the best one."
    assert f"{same} Weighed sample by sample, the best one is nearer to the recording by 20 standard deviations." in (
        beaten
    )
    assert (
        "wear, added to friction_hysteresis + creep: takes away 0.0024 mm rms more and leaves 0.030 mm rms (1.0 times "
        "the noise). That is too little for one mechanism more."
    ) in beaten
    assert "calibration alone" in beaten
    assert "calibration alone: leaves 0.45 mm rms (15 times the noise)." in beaten


def test_what_is_nearly_as_good_as_the_best_is_put_beside_its_number():
    made = content()
    for left, said in ((0.0308, "hardly more than the best one (0.030 mm)"), (0.0292, "even less than the best one")):
        made["evidence"]["explanations"][2]["left_mm"] = left
        assert f"friction_hysteresis + sensor_drift: leaves {left:.3f} mm rms" in told(made)
        assert said in told(made) and "no more than the best" not in told(made)
    made["evidence"]["explanations"][2]["worse"] = 0.0
    assert "It was not weighed: the recording lacks a mark of its effects, or" in " ".join(told(made).split())


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
    made = content(evidence__calibrated_mm=0.4)
    worst = {"ids": ["end_stop"], "left_mm": 0.7}
    assert rivals.told(worst, made, WORDS) == "end_stop: leaves as much as no effect does"
    assert "0.30 mm rms" in rivals.told(worst | {"left_mm": 0.3}, made, WORDS)
