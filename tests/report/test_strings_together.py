"""A page that holds strokes of several strings in one row says so: n=1 was of one string or of six, unsaid."""

import pandas as pd
import pytest
from stages.nine_strokes import NINE

from pipeline.report.shown.strings_together import together

TWO = pd.concat([NINE.assign(string="a"), NINE[NINE["stroke"] <= 5].assign(string="b")], ignore_index=True)
OWN = ", as every string counts its own."


@pytest.mark.parametrize(
    ("strokes", "words"),
    [
        ([1, 5, 9], f"Strings together: n=1 holds that stroke of 2 strings, n=5 of 2, n=9 of 1 (a, b){OWN}"),
        ([1, 5], f"Strings together: n=1, n=5 hold that stroke each of 2 strings (a, b){OWN}"),
        ([1], f"Strings together: n=1 holds that stroke of 2 strings (a, b){OWN}"),
        ([9], ""),
        ([], ""),
    ],
)
def test_strokes_of_several_strings_are_said_to_be(strokes: list[int], words: str) -> None:
    assert together(TWO, strokes) == words
    assert together(NINE, strokes) == together(None, strokes) == ""


def test_many_strings_are_counted_and_the_first_named() -> None:
    many = pd.concat([NINE.assign(string=f"s{number}") for number in range(6)], ignore_index=True)
    assert (
        together(many, [1]) == f"Strings together: n=1 holds that stroke of 6 strings (s0, s1, s2, s3 and 2 more){OWN}"
    )
