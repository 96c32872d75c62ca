"""How sure an effect and its size are, in words."""

import copy

import pytest
from made_content import confident, content, told


def test_a_sure_effect_whose_size_may_be_nothing_says_so():
    diagnosis = content()
    diagnosis["mechanisms"][0]["rms_mm"] |= {"low": 0.0}
    diagnosis["evidence"]["moved_sigma"] = {}
    sure = "friction_hysteresis is sure though the interval reaches 0, for the percentage counts all signs"
    for share, is_sure in ((0.85, True), (0.6, False)):
        diagnosis["mechanisms"][0]["confidence"] = share
        for explained in diagnosis["evidence"]["explanations"][1:]:
            explained["probability"] = 0.1
        text = told(copy.deepcopy(diagnosis))
        assert (sure in text) is is_sure and "since dimensions or other effects can take over much" in text
    diagnosis["mechanisms"][0]["confidence"], diagnosis["evidence"]["moved_sigma"] = 0.85, {"radius_mm": 3.0}
    at_its_limit = " ".join(told(diagnosis).split())
    assert sure not in at_its_limit
    assert "friction_hysteresis is probable though the interval reaches 0" in at_its_limit
    assert "friction_hysteresis has 85 %, but is only probable: the radius stands at its limit." in at_its_limit


AT_LIMIT = {"radius_mm": 3.0}


def test_the_first_lines_say_which_effects_are_sure_probable_and_open():
    text = " ".join(told(confident(0.93, 0.46)).split())
    assumption = (
        "The percentages compare explanations of the library in which a dimension may move by three tolerances."
    )
    more = (
        "The 93 % of friction_hysteresis is the sum over all explanations with it; the best explanation alone has 52 %."
    )
    words = "Sure: 80 % or more; probable: 50 % or more, or sure but for a reason that is told; open: less."
    assert f"{words} {more}" in text and assumption in text
    assert "friction_hysteresis sure, 93 %" in text and "creep open, 46 %" in text and "thermal open, 31 %" in text
    limit = told(confident(0.93, 0.46) | {"evidence": {**confident(0.93, 0.46)["evidence"], "moved_sigma": AT_LIMIT}})
    stands = "The radius stands at that limit: measured better, it can change the percentages."
    assert f"{assumption} {stands}" in " ".join(limit.split())
    text = " ".join(told(confident(0.8, 0.62, alternatives=[["friction_hysteresis"]])).split())
    assert "friction_hysteresis sure, 80 %" in text and "creep probable, 62 %" in text
    assert "Sure:" not in told(content()) and "The percentages compare" not in told(content())


def test_a_share_meets_a_limit_as_both_are_printed():
    """`probable, 80 %` stood beside `Sure: 80 % or more`."""
    text = " ".join(told(confident(0.7956, 0.4956)).split())
    assert "friction_hysteresis sure, 80 %" in text and "creep probable, 50 %" in text
    assert "is needed; it" not in text and "friction_hysteresis (sure, 80 %)" in text
    less = " ".join(told(confident(0.7949, 0.4949)).split())
    assert "friction_hysteresis probable, 79 %" in less and "creep open, 49 %" in less


def test_an_effect_less_likely_than_not_is_one_of_several_or_rather_absent():
    text = told(confident(0.93, 0.46))
    assert "One of creep and thermal is needed; it is not known which." in text and "more likely absent" not in text
    text = told(confident(0.93, 0.46, alternatives=[["friction_hysteresis", "thermal"], ["friction_hysteresis"]]))
    assert "creep is about as likely absent as at work (46 %)." in text and "is needed; it" not in text
    several = [["friction_hysteresis", "thermal"], ["friction_hysteresis", "sensor_drift", "wear"]]
    text = " ".join(told(confident(0.93, 0.34, alternatives=several)).split())
    others = "explanations of 34 % have it, and the others that are likely have another effect in its place"
    assert f"creep is open: {others}." in text and "absent" not in text, "a reader took it for no creep"
    both = " ".join(told(confident(0.34, 0.34, alternatives=[["thermal", "wear"], ["sensor_drift"]])).split())
    assert "friction_hysteresis and creep are open: explanations of 34 % have each, and the others" in both
    text = told(confident(0.93, 0.62))
    assert "is needed; it" not in text and "more likely absent" not in text


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (0.35, 0.44, "0.41 mm (0.35 to 0.44 mm)"),
        (0.0, 0.9, "0.41 mm (0 to 0.90 mm), poorly known"),
    ],
)
def test_the_first_table_says_whose_size_is_poorly_known_and_what_is_missing_follows(low, high, expected):
    diagnosis = content()
    diagnosis["mechanisms"][1]["rms_mm"] |= {"low": low, "high": high}
    text = told(diagnosis)
    (row,) = [line for line in text.splitlines() if line.startswith("  creep  ")]
    assert f"  {expected} Under load" in row and ("Poorly known: " in text) == ("poorly" in expected)
    assert "All hold if friction_hysteresis + creep is right." in text
    assert "\n  Over the whole recording 0.44 mm rms is missing after calibration" in text


def test_an_effect_far_larger_than_what_is_missing_is_mostly_hidden_in_both_places():
    diagnosis = content()
    diagnosis["mechanisms"][1]["rms_mm"] = {"value": 3.2, "low": 2.2, "high": 3.5}
    text = told(diagnosis)
    assert "3.2 mm (2.2 to 3.5 mm), mostly hidden" in text and "poorly known" not in text
    assert "Mostly hidden: it is far larger than the 0.44 mm that is missing." in text


@pytest.mark.parametrize(
    ("left_mm", "own_mm", "missing"),
    [
        (0.060, 0.30, "0.052 mm"),  # sqrt(0.060² - 0.030²), more than a tenth of the loop
        (0.060, 0.60, ""),  # it is small beside the loop
        (0.038, 0.05, ""),  # so little may be noise
    ],
)
def test_an_effect_beside_which_the_explanation_leaves_much_is_only_probable(left_mm, own_mm, missing) -> None:
    """Friction of an unusual law was backlash, `sure, 94 %`, in a fit that left 1.6 times the noise."""
    diagnosis = confident(0.93, 0.46, evidence__beyond_dimensions_mm={"friction_hysteresis": own_mm})
    diagnosis["evidence"]["explanations"][-1]["left_mm"] = left_mm
    text = " ".join(told(diagnosis).split())
    reason = (
        f"friction_hysteresis has 93 %, but is only probable: what is still missing, {missing} without the noise, is"
    )
    assert (f"{reason} more than a tenth as large." in text) is bool(missing)
    assert f"friction_hysteresis {'probable' if missing else 'sure'}, 93 %" in text
