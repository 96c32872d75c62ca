"""Rows of a table of questions are named so that a person finds them, however many they are."""

import pytest

from pipeline.models.parts.questions.bad_rows import SHOWN, numbered


@pytest.mark.parametrize(
    ("rows", "text"),
    [
        ([3], "row 3"),
        ([2, 3], "rows 2, 3"),
        ([1, 3, 4, 5, 9], "rows 1, 3 to 5, 9"),
        (list(range(1, 97)), "rows 1 to 96"),
        (list(range(2, 2 * SHOWN + 5, 2)), f"rows {', '.join(map(str, range(2, 2 * SHOWN + 1, 2)))} and 2 more"),
    ],
)
def test_rows_that_follow_each_other_are_one_stretch_and_of_many_the_first_are_named(
    rows: list[int], text: str
) -> None:
    assert numbered(rows) == text
