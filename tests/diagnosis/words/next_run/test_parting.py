"""Which explanations the run to make next tells apart."""

import copy

import pytest
from made_content import content, full, told


def parted(*gaps, **changes):
    """A tie of three: friction with creep, heat or wear; `gaps` as foretold of creep-heat, creep-wear, heat-wear."""
    ids = [["friction_hysteresis", last] for last in ("creep", "thermal", "wear")]
    pairs = [[ids[0], ids[1]], [ids[0], ids[2]], [ids[1], ids[2]]]
    entries = [
        {"ids": pair, "gap_now": 9.0, "gap_then": then} for pair, then in zip(pairs[::-1], gaps[::-1], strict=True)
    ]
    least = min(entries, key=lambda entry: entry["gap_then"])
    made = content(next_run__pairs=entries, next_run__gap_now=9.0, next_run__gap_then=least["gap_then"], **changes)
    made["next_run"]["parts"], made["alternatives"] = least["ids"], ids[1:]
    return made


@pytest.mark.parametrize(
    ("gaps", "said"),
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
def test_a_run_says_which_of_three_explanations_it_parts_and_which_it_leaves_together(gaps, said):
    made = parted(*gaps)
    assert said in told(copy.deepcopy(made))
    section = " ".join(full(made).partition("\nThe run to make next\n")[2].partition("\n\n")[0].split())
    assert section.count(said) == 1, "where the run stands, and once"


def test_two_that_the_run_is_to_decide_between_never_stay_together_over_a_third():
    made = parted(400.0, 9.1, 9.2)  # it decides between creep and heat, and parts wear from neither
    ids = [["friction_hysteresis", last] for last in ("creep", "thermal")]
    made["next_run"] |= {"parts": ids, "gap_now": 9.0, "gap_then": 400.0}
    said = "it can tell creep from thermal; it need not tell wear from creep or thermal."
    assert f"Of the 3 likeliest explanations {said}" in told(copy.deepcopy(made)), "the details"
    text = " ".join(full(made).split())
    assert "which is at work: creep or thermal" in text and text.count(said) == 1 and "stay together" not in text


def test_of_two_explanations_and_in_an_older_file_nothing_is_said_to_stay_together():
    assert "stay together" not in told() and "likeliest explanations it can" not in told()
    two = {"ids": [["friction_hysteresis", "creep"], ["friction_hysteresis", "thermal"]], "gap_now": 5.02}
    assert "It can tell all" not in told(content(next_run__pairs=[two | {"gap_then": 5330.0}]))
