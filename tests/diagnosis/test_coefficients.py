"""What the numbers of an adopted effect multiply, in words."""

import re

import pytest

from pipeline.diagnosis.library import mechanisms
from pipeline.diagnosis.words.coefficients import multiplied

NAMES = {"twist": "a", "steep_twist": "b", "load": "c", "dry_*_twist": "d"}


def test_of_two_words_at_one_place_the_longer_one_is_meant() -> None:
    assert multiplied(NAMES, ["steep_twist_60_s_mm_per_10_n"]) == ["    steep_twist in a name: it multiplies b"]
    both = multiplied(NAMES, ["steep_twist_60_s_mm", "twist_60_s_mm", "load_4_s_mm", "load_15_s_mm"])
    assert [line.split()[0] for line in both] == ["steep_twist", "twist", "load"]


def test_a_share_within_a_name_is_any_number_and_is_not_said() -> None:
    found = multiplied(NAMES, ["dry_0.02_twist_mm_per_10_n", "dry_0.1_twist_mm_per_10_n"])
    assert found == ["    dry_twist in a name: it multiplies d"]


@pytest.mark.parametrize("id_", [id_ for id_, one in mechanisms().items() if one.names])
def test_every_word_that_is_explained_stands_in_a_name_of_its_mechanism(problem, id_: str) -> None:
    one, drivers = mechanisms()[id_], problem.drivers
    options = [nonlinear | ({"loaded": 1.0} if "loaded" in nonlinear else {}) for nonlinear in one.candidates(drivers)]
    named = [f"_{term.name}_" for nonlinear in options for term in one.terms(drivers, nonlinear)]
    for word in one.names:
        there = re.compile(f"_{re.escape(word)}_".replace(r"\*", "[0-9.]+"))
        assert any(there.search(name) for name in named), word
