"""One page says one time constant: the test's length follows the constants that carry the effect."""

from made_content import content, page, parameter

from pipeline.diagnosis.document.time_constants import time_constants_s
from pipeline.diagnosis.words.named.effect_sentence import time_constants

CREEP = {
    "fresh": parameter(1.0, "1"), "fastest_s": parameter(1.0, "s"), "slowest_s": parameter(240.0, "s"),
    "load_60_s_mm_per_10_n": parameter(0.016, "mm/10N"), "twist_4_s_mm_per_10_n": parameter(0.44, "mm/10N"),
    "twist_60_s_mm_per_10_n": parameter(0.21, "mm/10N"), "twist_240_s_mm_per_10_n": parameter(0.01, "mm/10N"),
}  # fmt: skip
COVERED = {"load": [20.0, 20.0], "speed_per_s": [1.9, 2.1], "longest_hold_s": 3.0, "longest_rest_s": 60.0}


def test_the_longest_constant_is_one_that_carries_the_effect_and_not_the_longest_that_could_be_shown():
    assert time_constants_s({"parameters": CREEP}) == [4.0, 60.0]
    assert time_constants_s({"parameters": {"whole_s": parameter(300.0, "s")}}) == [300.0], "a drift's own"
    assert time_constants_s({"parameters": {"slowest_s": parameter(240.0, "s")}}) == []


def test_the_test_of_a_slow_effect_lasts_twice_the_longest_constant_that_its_sentence_gives():
    diagnosis = content(verdict="explained", alternatives=[], next_run=None, evidence__covered=COVERED)
    diagnosis["mechanisms"] = [diagnosis["mechanisms"][1] | {"parameters": CREEP}]
    assert "time constants of 4 s to 60 s" in time_constants(CREEP)
    text = " ".join(page(diagnosis).split())
    assert "(2 min or longer each, twice its longest time constant" in text and "8 min" not in text
