"""Words of a page that newcomers took for something else: what a percentage is of, stand-ins, and how far is far."""

import pytest
from made_content import confident, content, full, page

from pipeline.diagnosis.words.explanations import closest

NO_NAME = {"mechanisms": [], "alternatives": [], "next_run": None, "evidence__explanations": []}


def joined(text):
    return " ".join(text.split())


def first(text):
    return joined(text.partition("\n\n")[0])


@pytest.mark.parametrize("show", [page, full])
def test_the_doubt_about_a_slow_effects_name_stands_before_its_percentage(show):
    """`probably creep (63 %)` stood first, and far below that its name is not sure: 63 % was taken for that."""
    headline = first(show(confident(0.3, 0.62, evidence__loaded=False)))
    doubt = "one load cannot settle its name. By the probability of the library's formulas: "
    assert headline.startswith(f"nylon-3: something slow is likely at work, but {doubt}") and "creep (62 %)" in headline
    assert headline.index(doubt) < headline.index("%")
    assert "something slow is surely at work" in first(show(confident(0.3, 0.95, evidence__loaded=False)))
    assert "something slow" not in first(show(confident(0.3, 0.62, evidence__loaded=True))), "a second load settles it"


def test_one_explanation_with_a_slow_effect_has_the_doubt_first_too():
    alone = {"verdict": "explained", "alternatives": [], "next_run": None}
    headline = first(page(confident(0.93, 0.96, evidence__loaded=False, **alone)))
    assert headline.index("cannot settle its name") < headline.index("explained by friction_hysteresis + creep")


def test_where_no_percentage_is_known_none_is_spoken_of():
    headline = first(page(content(evidence__loaded=False)))
    assert "cannot settle its name. By the library's formulas: friction_hysteresis is in both" in headline


def test_a_stand_in_that_a_page_names_is_said_in_words():
    """`x_clock` stood on a page, and nothing said what that is."""
    other = {"verdict": "explained", "alternatives": [], "next_run": None, "evidence__chosen_without_them": ["x_clock"]}
    text = joined(page(content(**other)))
    assert "x_clock" in text and text.count("x_clock (the clocks of motor and displacement run apart)") == 1
    assert closest.not_told("x_clock: the clocks of motor\n  and displacement run apart") == [], "it says so itself"
    assert closest.not_told("creep") == []


def test_the_table_of_effects_and_its_remark_say_in_plain_words_what_dimensions_could_make():
    """`share no dimension can imitate` was the head of the column."""
    moved = {"moved_alone_sigma": {"radius_mm": 1.9}, "moved_sigma": {"radius_mm": 0.1}}
    evidence = {f"evidence__{key}": value for key, value in moved.items()}
    diagnosis = confident(0.93, 0.96, evidence__beyond_dimensions_mm={"creep": 0.031}, **evidence)
    diagnosis["mechanisms"] = diagnosis["mechanisms"][1:]
    text = joined(page(diagnosis))
    assert "part that no wrong dimension can make" in text and "imitate" not in text
    assert "Of creep report the last column, not the size before it: a slightly different radius could make the" in text


def test_explanations_are_compared_with_the_first_row_by_its_number():
    """`differs from 1 by 0.0069 mm` read as a number that differs from one."""
    text = joined(full(confident(0.93, 0.62)))
    assert "rms apart from no. 1" in text and "from 1 by" not in text and "than 1:" not in text


def test_a_page_says_from_where_to_where_dimensions_moved_and_by_how_many_per_cent():
    near = {"evidence__moved_sigma": {"radius_mm": 1.3}, "evidence__tolerance": {"radius_mm": 0.0165}}
    text = joined(page(content(verdict="parameters", **NO_NAME, **near)))
    assert "once its measured dimensions move (radius from 0.55 mm to 0.561 mm, +2 %); no physics is missing." in text
    assert "1.3 (+2 %)" in text and "in brackets: per cent of the value before." in text
    named = joined(page(confident(0.93, 0.96, **near)))
    assert "radius from 0.55 mm to 0.561 mm (+2 %, 1.3 times its tolerance of 0.01" in named
    far = page(confident(0.93, 0.96))
    assert "0.5612 mm (+2 %)" in far.partition("Measure again what calibration moved far")[2]


def test_what_begins_at_0_has_no_per_cent():
    turned = {"parameters": {"angle_turns": {"nominal": 0.0, "value": 0.06, "low": 0.05, "high": 0.07}}}
    moved = {"evidence__moved_sigma": {"angle_turns": 1.2}, "evidence__tolerance": {"angle_turns": 0.05}}
    text = joined(page(content(verdict="parameters", **NO_NAME, **turned, **moved)))
    assert "(zero of the motor from 0 turns to 0.06 turns); no physics" in text
