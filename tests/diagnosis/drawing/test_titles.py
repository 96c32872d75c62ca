"""The title of the figure."""

import pytest
from made_content import SYSTEMS

from pipeline.diagnosis.drawing.figures import title
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.next_run import experiment


def test_titles_are_said_in_the_rigs_words():
    run = {"title": "a rest at the lowest twist, then one stroke"}
    assert experiment.title(run, Vocabulary.of(SYSTEMS["deg"])) == "A rest at the lowest motor angle, then one stroke"


@pytest.mark.parametrize(
    ("others", "expected"),
    [
        ([], "creep"),
        ([["wear", "jam"]], "creep, or wear + jam"),
        ([["wear"], ["jam"]], "creep, or one of 2 other explanations"),
        ([[f"friction_hysteresis_{n}" for n in range(5)]], "creep, or 1 other explanation"),
    ],
)
def test_a_title_has_two_lines_at_most_and_breaks_nowhere_else(others, expected):
    diagnosis = {"run": "a-1", "verdict": "ambiguous", "mechanisms": [{"id": "creep"}], "alternatives": others}
    assert title(diagnosis).replace("\N{NO-BREAK SPACE}", " ") == f"a-1: ambiguous\n{expected}"
    assert title(diagnosis | {"mechanisms": [], "verdict": "unknown"}) == "a-1: unknown"
    adopted_ = diagnosis | {"mechanisms": [], "verdict": "parameters", "simulation": [{"id": "wear"}, {"id": "creep"}]}
    expected = "a-1: parameters\nbeside what run.yaml has adopted: wear + creep"
    assert title(adopted_).replace("\N{NO-BREAK SPACE}", " ") == expected
    assert title(adopted_, True).replace("\N{NO-BREAK SPACE}", " ") == "a-1: adopted wear + creep still hold"
    many = title(diagnosis | {"run": [f"nylon-20261122-{n:02}" for n in range(9)]})
    assert many.startswith("nylon-20261122-00 and 8 more: ambiguous\n") and many.count("\n") == 1


def test_a_title_says_that_a_name_is_not_settled_as_the_page_does():
    diagnosis = {
        "run": "a-1", "verdict": "explained", "mechanisms": [{"id": "creep"}], "alternatives": [],
        "evidence": {"chosen_without_them": ["wear"]}, "fit": {"heldout": None},
    }  # fmt: skip
    assert title(diagnosis) == "a-1: explained, but not settled\ncreep"
    assert title(diagnosis | {"evidence": {"chosen_without_them": ["creep"]}}) == "a-1: explained\ncreep"


def test_a_title_says_that_something_is_missing_as_the_page_does():
    """`explained` stood above a figure whose page said `explained, but something is still missing`."""
    diagnosis = {"run": "a-1", "verdict": "explained", "mechanisms": [{"id": "creep"}], "alternatives": []}
    diagnosis |= {"evidence": {}, "fit": {"heldout": None}}
    assert title(diagnosis, misses=True) == "a-1: explained, but something is still missing\ncreep"
    assert title(diagnosis) == "a-1: explained\ncreep"
