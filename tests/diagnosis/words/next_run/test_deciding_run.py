"""Where no run decides, and where none is needed."""

import pytest
from made_content import SYSTEMS, content, told

from pipeline.diagnosis.words.pages.spoken import spoken


@pytest.mark.parametrize("verdict", ["consistent", "parameters", "explained"])
def test_where_no_run_is_needed_next_the_verdict_says_so_and_why(verdict):
    made = spoken(content(verdict=verdict, next_run=None), SYSTEMS["mm"])
    text = told(content(verdict=verdict, next_run=None))
    assert "The run to make next\n  None is needed: " in text and "None is needed" not in told()
    assert made["next_experiment"] is None


def test_where_no_run_decides_the_open_effects_own_signs_are_told():
    heading = "\nWhat tells the open effects apart at the rig\n"
    said = told(content(next_run__gap_now=2809.0, next_run__gap_then=4761.0)).partition(heading)[2].partition("\n\n")[0]
    assert "\n  creep: a hold under load" in said and "\n  thermal: " in said and "These hold in general" in said
    decided = told().partition(heading)[2].partition("\n\n")[0]
    assert "\n  creep: a hold under load" in f"\n{decided}" and "These hold in general" not in decided
    assert heading not in told(content(verdict="explained", alternatives=[], next_run=None))
