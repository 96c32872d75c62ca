"""How sure an effect and its size are, in words."""

import copy

import pytest
from made_content import confident, content, told


def test_a_sure_effect_whose_size_may_be_nothing_says_so():
    found = content()
    found["mechanisms"][0]["rms_mm"] |= {"low": 0.0}
    sure = "That it is there is sure; its size is poorly known: dimensions or other effects can take its place."
    for confidence, said in ((0.85, True), (0.6, False)):
        found["mechanisms"][0]["confidence"] = confidence
        assert (sure in told(copy.deepcopy(found))) is said
    found["mechanisms"][0]["confidence"], found["evidence"]["moved_sigma"] = 0.85, {"radius_mm": 3.0}
    at_its_limit = " ".join(told(found).split())
    assert sure not in at_its_limit
    assert (
        "That it is there is no more than probable, since the radius stands at its limit; its size is" in at_its_limit
    )


AT_LIMIT = {"radius_mm": 3.0}


def test_the_first_lines_say_which_effects_are_sure_probable_and_open():
    first = told(confident(0.93, 0.46)).partition("\n\n")[0]
    held = (
        "The percentages compare explanations made of the library's effects, in which each dimension may move by up to "
        "three times its tolerance."
    )
    open_ = "Open: creep (46 %) and thermal (31 %)."
    sure = "Sure (80 % or more): friction_hysteresis (93 %)."
    more = "counts each explanation that has it, so it can be more than the 52 % of the best one."
    assert f" {sure} {open_} How sure an effect is {more} {held} " in " ".join(first.split()) + " "
    limit = told(confident(0.93, 0.46) | {"evidence": {**confident(0.93, 0.46)["evidence"], "moved_sigma": AT_LIMIT}})
    stands = "The radius stands at that limit: measured better, it can change the percentages."
    assert f"{held} {stands}" in " ".join(limit.split())
    first = told(confident(0.8, 0.62, alternatives=[["friction_hysteresis"]])).partition("\n\n")[0]
    assert "\n  Sure (80 % or more): friction_hysteresis (80 %). Probable (50 % or more): creep (62 %).\n" in first
    assert "Sure" not in told(content()) and "The percentages compare" not in told(content())


def test_an_effect_less_likely_than_not_is_one_of_several_or_rather_absent():
    text = told(confident(0.93, 0.46))
    assert "One of creep and thermal is needed; it is not known which." in text and "more likely absent" not in text
    text = told(confident(0.93, 0.46, alternatives=[["friction_hysteresis", "thermal"], ["friction_hysteresis"]]))
    assert "creep is about as likely absent as at work (46 %)." in text and "is needed; it" not in text
    text = told(confident(0.93, 0.62))
    assert "is needed; it" not in text and "more likely absent" not in text


@pytest.mark.parametrize(
    ("low", "high", "said"),
    [
        (0.35, 0.44, "Each effect's own size is known to 15 % or better, if"),
        (0.0, 0.9, "Poorly known is how much creep (0 to 0.90 mm) does alone, if friction_hysteresis + creep is"),
    ],
)
def test_the_first_lines_say_how_much_is_missing_and_whose_size_is_poorly_known(low, high, said):
    made = content()
    made["mechanisms"][1]["rms_mm"] |= {"low": low, "high": high}
    assert f"\n  Size: 0.44 mm rms is missing after calibration. {said}" in told(made)


def test_an_effect_far_larger_than_what_is_missing_has_a_poorly_known_size_in_both_places():
    made = content()
    made["mechanisms"][1]["rms_mm"] = {"value": 3.2, "low": 2.2, "high": 3.5}
    text = told(made)
    assert (
        "Poorly known is how much creep (2.2 to 3.5 mm) does alone" in text
        and "Its size is no surer than the dimensions: it" in text
    )
