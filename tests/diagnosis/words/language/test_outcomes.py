"""Each run that tries what a nameless mismatch follows says what each of its outcomes would mean, on any rig."""

import pytest

from pipeline.diagnosis.proposal.legs import AFTER_UNKNOWN
from pipeline.diagnosis.words.language import outcomes
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.systems import systems

TITLES = [title for title, _ in AFTER_UNKNOWN.values()]


@pytest.mark.parametrize("title", TITLES)
def test_a_run_after_unknown_says_what_at_least_two_outcomes_would_mean(title: str) -> None:
    for name, system in systems().items():
        head, *rows = outcomes.table(title, Vocabulary.of(system))
        assert head.startswith("if what is missing") and len(rows) >= 2, title
        assert all(len(row) <= 112 for row in rows), "it stands indented on a page of 120 columns"
        assert system.needs_string or not {"twist", "string"} & set(" ".join(rows).split()), name


def test_no_run_but_those_has_outcomes_and_each_of_them_is_made() -> None:
    assert set(outcomes.OUTCOMES) == set(TITLES)
    assert outcomes.table("one more stroke as before", Vocabulary.of(systems()["separator"])) == []
