"""Where no run decides, and where none is needed."""

import pytest
from made_content import SYSTEMS, confident, content, page, told

from pipeline.diagnosis.words.pages.spoken import spoken


@pytest.mark.parametrize("verdict", ["consistent", "parameters", "explained"])
def test_where_no_run_is_needed_next_the_verdict_says_so_and_why(verdict):
    diagnosis = spoken(content(verdict=verdict, next_run=None), SYSTEMS["mm"])
    text = told(content(verdict=verdict, next_run=None))
    assert "The run to make next\n  None is needed: " in text and "None is needed" not in told()
    assert diagnosis["next_experiment"] is None


def test_where_no_run_decides_the_open_effects_own_signs_are_told():
    heading = "\nWhat tells the open effects apart at the rig\n"
    section = (
        told(content(next_run__gap_now=2809.0, next_run__gap_then=4761.0)).partition(heading)[2].partition("\n\n")[0]
    )
    assert (
        "\n  creep: a hold under load" in section and "\n  thermal: " in section and "These hold in general" in section
    )
    decided = told().partition(heading)[2].partition("\n\n")[0]
    assert "\n  creep: a hold under load" in f"\n{decided}" and "These hold in general" not in decided
    assert heading not in told(content(verdict="explained", alternatives=[], next_run=None))


ALONE = {"verdict": "explained", "alternatives": [], "next_run": None}
NEAR = {"evidence__moved_sigma": {"radius_mm": 0.4}}


def test_what_makes_sure_of_a_name_is_said_to_stand_above_only_where_it_does():
    above = "What makes sure of a name stands above, under What to do."
    doubtful, sure = (told(confident(share, share, **ALONE, **NEAR)) for share in (0.9, 0.995))
    assert above in doubtful and "\nWhat to do, in this order\n" in doubtful
    assert "None is needed: " in sure and "stands above" not in sure and "\nWhat to do" not in sure


def test_the_page_promises_of_the_details_no_numbers_that_they_have_not():
    covered = {"load": [20.0, 20.0], "speed_per_s": [1.0, 1.0], "longest_hold_s": 0.0, "longest_rest_s": 4.0}
    bare = {**ALONE, **NEAR, "evidence__loaded": False, "evidence__covered": covered}
    diagnosis = confident(0.9, 0.9, **bare)
    diagnosis["mechanisms"] = diagnosis["mechanisms"][:1]
    assert "Its tests and the commands: details.txt." in page(diagnosis), "they foretell no number"
    assert (
        "no holds and rests of up to 4 s" in told(diagnosis)
        and "0 s" not in told(diagnosis).partition("Recorded so far")[2][:90]
    )
