"""Why an explanation is less likely than the best one: exact parts of the judge's score, and words for them."""

import json

import numpy as np
import pytest

from pipeline.diagnosis.facts.aspects import MARKS, SIGNS, by_aspect, chief
from pipeline.diagnosis.facts.explanations import explanations
from pipeline.diagnosis.numerics.judge import Weighed, judge
from pipeline.diagnosis.numerics.recogniser import OF_ALL, OF_EXPLANATION
from pipeline.diagnosis.words.explanations.reasons import NAMES, SAID, chiefly, less_often, reason

NAMED = [("creep",), ("creep", "jam"), ("creep", "slack", "wear"), ("thermal", "wear")]


@pytest.fixture
def candidates() -> list[Weighed]:
    """Explanations of every size, their signs drawn over all that the judge has knots for."""
    draw = np.random.default_rng(1)
    knots = (judge().knots | {name: (-5.0, 0.0) for name in (*OF_EXPLANATION, OF_ALL)}).items()
    return [Weighed(ids, {name: float(draw.uniform(ends[0], ends[-1])) for name, ends in knots}) for ids in NAMED]


def test_the_parts_of_the_judges_score_add_up_to_the_log_of_the_ratio_of_probabilities(candidates) -> None:
    shares = judge().probabilities(candidates)
    for candidate, share in zip(candidates, shares, strict=False):
        for other, beside in zip(candidates, shares, strict=False):
            ratio = pytest.approx(np.log(share / beside), abs=1e-9)
            assert sum(judge().because(candidate, other).values()) == ratio
            assert sum(by_aspect(judge(), candidate, other).values()) == ratio
            assert set(judge().because(candidate, other)) == {*judge().knots, *OF_EXPLANATION, "names", "size"}


def test_a_sign_in_which_two_explanations_agree_counts_nothing(candidates) -> None:
    candidate, other = (
        candidates[1],
        Weighed(candidates[3].ids, {**candidates[3].signs, "left_share": candidates[1].signs["left_share"]}),
    )
    assert judge().because(candidate, other)["left_share"] == 0.0 and judge().because(candidate, other)["size"] == 0.0
    assert judge().because(candidate, Weighed(candidate.ids[:1], candidate.signs))["size"] != 0.0


def test_every_sign_of_the_judge_has_an_aspect_and_every_aspect_a_word(candidates) -> None:
    of_signs = [sign for signs in SIGNS.values() for sign in signs]
    assert len(of_signs) == len(set(of_signs)) and set(SAID) == {*SIGNS, "size"}
    judged_signs = {*judge().knots, *OF_EXPLANATION}
    assert {sign for sign in judged_signs if not sign.startswith(MARKS)} == set(of_signs)
    for aspect in by_aspect(judge(), candidates[0], candidates[1]):
        for more in (-1.0, 0.0, 1.0):
            assert reason({"aspect": aspect, "log_odds": -1.0, "more": more})


def test_what_counts_most_against_an_explanation_is_said_with_how_much_less_likely_it_is(candidates) -> None:
    chief_reasons = chief(judge(), candidates[0], candidates[1])
    parts = by_aspect(judge(), candidates[0], candidates[1])
    assert [each["log_odds"] for each in chief_reasons] == sorted(parts.values())[:2] and chief_reasons[0][
        "log_odds"
    ] < 0.0
    because = [
        {"aspect": "weakest", "log_odds": -1.0, "more": -2.0},
        {"aspect": "mark_jam", "log_odds": -1, "more": -1},
    ]
    assert chiefly({"because": because}) == (
        "chiefly since its weakest effect adds less and since it leaves out jam, whose mark this recording shows"
    )
    names, leaves_out = {"aspect": "names", "log_odds": -2.0, "more": 0.0}, "since it leaves out jam, whose mark"
    assert chiefly({"because": [names, because[1]]}) == f"partly {leaves_out} this recording shows"
    assert chiefly({"because": [because[1], names]}) == f"chiefly {leaves_out} this recording shows"
    taught = "were right less often in the simulated recordings that taught the judge"
    assert chiefly({"because": [names]}).endswith(taught)
    assert chiefly({"probability": 0.2}) == "" and less_often({"probability": 0.2}, {"probability": 0.6}) == "3.0"
    for share in (0.0, None, 0.6):
        assert less_often({"probability": share, "because": because}, {"probability": 0.6}) == ""


def test_a_diagnosis_keeps_the_reasons_against_each_explanation_that_was_weighed(studied) -> None:
    shown = explanations(studied("creep")[0], "mm", 0.5)
    reasons = [
        explanation["because"] for explanation in shown if explanation["ids"] and explanation["standing"] != "named"
    ]
    assert reasons and any(reasons) and all(len(each or []) <= 2 for each in reasons)
    assert all(part["log_odds"] < 0.0 for each in reasons for part in each or [])
    (alone,) = (each for each in shown if not each["ids"])
    assert alone["left_mm"] == 0.5 != alone["approximated_mm"], (
        "as the table has it, beside what the search took it for"
    )
    assert json.dumps(shown) and "because" not in next(
        explanation for explanation in shown if explanation["standing"] == "named"
    )


def test_what_a_reader_takes_for_a_merit_is_no_reason_against_an_explanation() -> None:
    worse, fewer = (
        {"aspect": aspect, "log_odds": -1.0, "more": more} for aspect, more in (("fit", -1.0), ("numbers", -2.0))
    )
    assert chiefly({"because": [worse, fewer]}) == "chiefly since it fits the recording worse"
    assert chiefly({"because": [fewer, worse]}) == "partly since it fits the recording worse"
    assert chiefly({"because": [fewer]}) == (
        "though it has fewer free numbers: such explanations were right less often in the simulated recordings that "
        "taught the judge"
    )
    hardly = {"aspect": "more", "log_odds": -7e-5, "more": 4e-4}
    names = {"aspect": "names", "log_odds": -1.0, "more": -1.0}
    assert chiefly({"because": [names, hardly]}) == f"chiefly since {NAMES}", "what counts nothing is no reason"
    assert chiefly({"because": [names]}) == f"chiefly since {NAMES}"
