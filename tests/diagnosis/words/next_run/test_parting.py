"""Which explanations the run to make next tells apart."""

import copy

import pytest
from made_content import content, full, page, told

from pipeline.diagnosis.words.next_run import parting, worth


def parted(*gaps, **changes):
    """A tie of three: friction with creep, heat or wear; `gaps` as foretold of creep-heat, creep-wear, heat-wear."""
    ids = [["friction_hysteresis", last] for last in ("creep", "thermal", "wear")]
    pairs = [[ids[0], ids[1]], [ids[0], ids[2]], [ids[1], ids[2]]]
    entries = [
        {"ids": pair, "gap_now": 9.0, "gap_then": then} for pair, then in zip(pairs[::-1], gaps[::-1], strict=True)
    ]
    least = min(entries, key=lambda entry: entry["gap_then"])
    diagnosis = content(next_run__pairs=entries, next_run__gap_now=9.0, next_run__gap_then=least["gap_then"], **changes)
    diagnosis["next_run"]["parts"], diagnosis["alternatives"] = least["ids"], ids[1:]
    return diagnosis


@pytest.mark.parametrize(
    ("gaps", "expected"),
    [
        (
            (400.0, 400.0, 9.1),
            "Of the 3 likeliest explanations it can tell creep from the others; thermal and wear stay",
        ),
        (
            (9.1, 400.0, 400.0),
            "Of the 3 likeliest explanations it can tell wear from the others; creep and thermal stay",
        ),
        ((400.0, 400.0, 400.0), "It can tell all 3 likeliest explanations apart."),
        ((9.1, 9.2, 9.1), "It is not sure to tell any of the 3 likeliest explanations from all others."),
    ],
)
def test_a_run_says_which_of_three_explanations_it_parts_and_which_it_leaves_together(gaps, expected):
    diagnosis = parted(*gaps)
    assert expected in told(copy.deepcopy(diagnosis))
    section = " ".join(full(diagnosis).partition("\nThe run to make next\n")[2].partition("\n\n")[0].split())
    assert section.count(expected) == 1, "where the run stands, and once"


def test_an_explanation_of_several_effects_stands_in_no_brackets_and_counts_as_one():
    """`jam, or friction_hysteresis and radius_compaction, the two that are hardest to tell apart`: which two?"""
    diagnosis = parted(400.0, 400.0, 9.1)
    for pair in diagnosis["next_run"]["pairs"]:
        pair["ids"] = [[*ids, "slack"] if ids[-1] == "creep" else ids for ids in pair["ids"]]
    diagnosis["mechanisms"].append({**diagnosis["mechanisms"][-1], "id": "slack"})
    sentence = "it can tell creep + slack from the others; thermal and wear stay together"
    assert sentence in parting.sentence(diagnosis)
    diagnosis["next_run"]["parts"] = [["creep", "slack"], ["thermal"]]
    assert worth.question(diagnosis) == "which is at work: creep + slack or thermal"
    diagnosis["next_run"] |= {"gap_now": 9.0, "gap_then": 30.0}
    assert "try the run that tells most" in told(diagnosis)
    for pair in diagnosis["next_run"]["pairs"]:
        pair["gap_then"] = 30.0
    assert "the two explanations that are hardest to tell apart" in told(diagnosis)


def test_the_step_says_first_what_the_run_tells_apart_where_it_leaves_the_closest_two_together():
    """`The run that tells jam from radius_compaction best` stood before `jam and radius_compaction stay together`."""
    diagnosis = parted(400.0, 400.0, 15.0)
    diagnosis["next_run"] |= {"gap_now": 9.0, "gap_then": 30.0}
    step = " ".join(page(diagnosis).partition("What to do, in this order")[2].split())
    need = "Only if you need to know which is at work: try the run that tells most"
    first = "Of the 3 likeliest explanations it can tell creep from the others; thermal and wear stay together."
    assert step.index(need) < step.index(first) < step.index("In tests such runs settled 30 of 50")
    assert "hardest to tell apart" not in step


def test_two_that_the_run_is_to_decide_between_never_stay_together_over_a_third():
    diagnosis = parted(400.0, 9.1, 9.2)  # it decides between creep and heat, and parts wear from neither
    ids = [["friction_hysteresis", last] for last in ("creep", "thermal")]
    diagnosis["next_run"] |= {"parts": ids, "gap_now": 9.0, "gap_then": 400.0}
    sentence = "it can tell creep from thermal; it need not tell wear from creep or thermal."
    assert f"Of the 3 likeliest explanations {sentence}" in told(copy.deepcopy(diagnosis)), "the details"
    text = " ".join(full(diagnosis).split())
    assert "which is at work, creep or thermal" in text and text.count(sentence) == 1 and "stay together" not in text


def test_of_two_explanations_and_in_an_older_file_nothing_is_said_to_stay_together():
    assert "stay together" not in told() and "likeliest explanations it can" not in told()
    two = {"ids": [["friction_hysteresis", "creep"], ["friction_hysteresis", "thermal"]], "gap_now": 5.02}
    assert "It can tell all" not in told(content(next_run__pairs=[two | {"gap_then": 5330.0}]))
