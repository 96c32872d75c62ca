"""What a page says of a second load that only a few strokes had."""

import pytest
from made_content import SYSTEMS, confident, content, full, page

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured import other_load
from pipeline.diagnosis.words.next_run import recorded_so_far, second_load

WORDS = Vocabulary.of(SYSTEMS["mm"])
COVERED = {"load": [19.9, 40.0], "speed_per_s": [2.0, 4.0], "longest_hold_s": 3.0, "longest_rest_s": 60.0}
FEW = {"usual": 20.0, "load": [40.0, 40.0], "strokes": [12]}
EVIDENCE = {"evidence__loaded": False, "evidence__covered": COVERED, "evidence__moved_sigma": {}}
ALONE = {"verdict": "explained", "alternatives": [], "next_run": None}


def test_a_second_load_of_one_stroke_is_recorded_so_far_and_the_page_says_in_which():
    diagnosis = confident(0.95, 0.9, **EVIDENCE, **ALONE, evidence__other_load=FEW)
    whole = " ".join(full(diagnosis).split())
    assert "Recorded so far: one load but for stroke 12 (40 N), speeds of 2 to 4 turns/s" in whole
    assert "It has a second load, 40 N, only in stroke 12: more strokes under it would do." in whole
    assert "creep has 90 %, but both are only probable: a second load was recorded only in stroke 12." in whole
    assert "With a second load only in stroke 12 slow effects look alike." in whole
    assert "a second load only in stroke 12 cannot settle its name" in " ".join(page(diagnosis).split())
    both = whole + " ".join(page(diagnosis).split())
    wrong = ("no second load", "second load was not recorded", "under one load", "Under one load", "half or twice")
    assert not any(words in both for words in wrong)
    assert "but under 40 N in place of 20 N" in whole and "Better " not in both, "the run has another load already"
    assert "or longer each, twice its longest time constant, under 20 to 40 N as recorded here" in whole
    before = " ".join(full(confident(0.95, 0.9, **EVIDENCE, **ALONE)).split())
    assert "Recorded so far: one load, " in before and "only probable: a second load was not" in before


def test_a_slow_effect_alone_asks_for_more_strokes_under_the_load_that_few_had():
    stands = {"load": 20.0, "speed_per_s": 4.0, "strokes": 12, "stand_s": 60.0, "recorded": {}}
    foretold = {"ids": ["creep"], "hold_mm": -0.3, "rest_mm": 0.3, "plus_minus": {"hold_mm": 0.05, "rest_mm": 0.05}}
    creep = {
        **EVIDENCE,
        **ALONE,
        "mechanisms": content()["mechanisms"][1:],
        "evidence__expected": stands | {"explanations": [foretold]},
    }
    text = page(content(**creep, evidence__other_load=FEW))
    better = (
        "Better with more strokes under 40 N: a second load that only stroke 12 had makes no slow effect's name sure."
    )
    assert better in " ".join(text.split())
    alone = " ".join(page(content(**creep)).split())
    assert "under 10 or 40 N in place of 20 N if the rig bears it, at 2 to 4 turns/s, and in the first" in alone
    assert "Under one load alone no slow effect's name is sure." in alone


def test_a_second_speed_that_was_not_recorded_is_told_beside_it():
    slow = {**EVIDENCE, "evidence__covered": COVERED | {"speed_per_s": [2.0, 2.1]}}
    text = " ".join(full(confident(0.95, 0.46, **slow, **ALONE, evidence__other_load=FEW)).split())
    why = "a second load was recorded only in stroke 12 and a second speed was not recorded"
    assert f"friction_hysteresis has 95 %, but is only probable: {why}." in text


@pytest.mark.parametrize(
    ("strokes", "only"), [([3], "stroke 3"), ([3, 9], "strokes 3 and 9"), ([1, 2, 3, 4, 5], "5 strokes")]
)
def test_few_strokes_are_named_and_many_are_counted(strokes, only):
    assert other_load.only_in(content(evidence__other_load=FEW | {"strokes": strokes})) == only


def test_the_usual_load_is_the_base_of_the_next_one_and_more_strokes_of_the_other_are_what_lacks():
    diagnosis = content(**EVIDENCE, evidence__other_load=FEW)
    assert second_load.base(diagnosis) == 20.0 and second_load.base(content(**EVIDENCE)) == 40.0
    assert recorded_so_far.not_yet(diagnosis, WORDS) == "with more strokes under 40 N"


def test_the_change_from_stroke_to_stroke_is_said_to_be_under_one_load():
    """The last stroke had twice the load, and was not the one that was compared with the first."""
    tops = {"evidence__tops_mm": {"creep": -0.4}}
    text = " ".join(full(content(**EVIDENCE, **tops, evidence__other_load=FEW)).split())
    assert "in the last stroke that goes there under the same load than in the first" in text
