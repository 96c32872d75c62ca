"""Whether the run to make next is worth it."""

import copy
import re

import pytest
from made_content import content, told, weighed

from pipeline.diagnosis.words.next_run import worth


def test_a_proposed_run_says_how_probable_the_two_are_that_it_parts_and_whether_it_is_worth_it():
    diagnosis = weighed(0.004, 0.06, 0.31, 0.02, 0.52, next_run__gap_now=16.0, next_run__gap_then=16.0)
    diagnosis["alternatives"] += [["friction_hysteresis", "sensor_drift"], ["creep"], ["wear"]]
    text = told(diagnosis)
    pair = "friction_hysteresis + creep (probability 52 %) from friction_hysteresis + thermal (probability 31 %)"
    assert f"It is to tell {pair}." in text
    assert "Hardly worth making: you can skip it." in text
    none = "no other run that was tried in simulation does better"
    assert f"in this recording; {none}." in text
    diagnosis["next_run"] |= {"gap_now": 9.0, "gap_then": 900.0}
    text = told(copy.deepcopy(diagnosis))
    assert re.search(r"\n  friction_hysteresis \+ creep +52 %\n  friction_hysteresis \+ thermal +31 %\n", text)
    assert "The two of the table are the closest of the 4 likeliest explanations." in text
    diagnosis["next_run"]["parts"][0].append("wear")
    text = told(copy.deepcopy(diagnosis))
    assert (
        "at work, creep + wear or thermal" in text
        and "Without the run report the best explanation as one of 5." in text
    )
    assert "; the best one differs from both by at least as much." in text
    diagnosis["next_run"]["parts"][0] = ["friction_hysteresis", "thermal", "slack"]
    diagnosis["fit"]["heldout"]["explained_mm"] = 0.95
    assert "Without the run report all 5 explanations and adopt none." in told(diagnosis)


def test_a_run_that_hardly_parts_them_better_is_told_as_that():
    text = told(content(next_run__gap_now=2809.0, next_run__gap_then=4761.0))
    gaps = "differ by 69 standard deviations of noise in the run, by 53 in this recording."
    why = "for a formula that is wrong by 10 % could make as much: over all samples they"
    first = "This recording does not decide, and the run need not either,"
    assert f"{first} {why} {gaps}" in " ".join(text.split())
    step = " ".join(text.partition("What to do, in this order")[2].partition("\n\n")[0].split())
    assert "In tests such runs settled 30 of 50 ties rightly and 5 wrongly, and left 15 open." in step, (
        "one number in the step and below it"
    )
    assert "half of such runs" not in text
    text = " ".join(told(content(next_run__gap_now=2809.0, next_run__gap_then=2900.0)).split())
    assert "no other run that was tried in simulation does better." in text and "Hardly worth making" in text
    text = " ".join(told(content(next_run__gap_now=900.0)).split())
    why = why.partition(":")[0]
    unable = f"This recording does not, {why}. In the run it would have to be wrong by 24 %"
    assert f"The run can decide between these two. {unable}" in text
    assert "73 standard deviations" not in text and "need not" not in text


def test_a_run_that_decides_nothing_says_so_before_its_steps():
    text = told(content(next_run__gap_then=content()["next_run"]["gap_now"]))
    run = text.partition("\nThe run to make next\n")[2].partition("\n\n")[0]
    assert run.startswith(
        "  Hardly worth making: you can skip it. It would be a hold at full twist, then a rest, 3.5 min"
    )
    assert len(run.splitlines()) == 2 and "1. " not in run
    assert run.count("Hardly") == 1
    assert "Hardly" not in told()


@pytest.mark.parametrize(
    ("now", "then", "raises_gap"), [(4.0, 4.2, False), (4.0, 4.9, True), (0.1, 0.9, False), (0.1, 1.1, True)]
)
def test_a_run_raises_the_gap_where_more_than_a_standard_deviation_is_seen_after_it(now, then, raises_gap):
    assert worth.raises({"gap_now": now, "gap_then": then}) is raises_gap
