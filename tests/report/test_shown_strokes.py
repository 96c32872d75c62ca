import pytest

from pipeline.report.shown.shown_strokes import drawn, ranges, shown_of, tabled, tabled_and_last, there_of


@pytest.mark.parametrize(
    ("available", "wanted", "shown"),
    [
        (range(1, 10), (1, 5, 9), [1, 5, 9]),
        (range(1, 9), (1, 5, 9), [1, 5, 8]),
        (range(1, 9), (1, 3, 5, 7), [1, 3, 5, 7]),
        (range(21, 30), (1, 5, 9), [21, 25, 29]),
        ([2], (1, 5, 9), [2]),
        ([], (1, 5, 9), []),
    ],
)
def test_figures_show_strokes_that_are_there(available, wanted, shown):
    assert drawn(available, wanted) == shown


def test_tables_drop_a_stroke_that_is_not_there():
    assert tabled(range(1, 9), (1, 5, 9)) == [1, 5]
    assert tabled(range(21, 30), (1, 5, 9)) == [21, 25, 29]


def test_which_strokes_there_are_is_said_as_ranges():
    assert ranges([1, 2, 3, 7, 9, 10]) == "1 to 3, 7 and 9 to 10" and there_of(["all", "10", "9"]) == [9, 10]


def test_which_strokes_are_shown_and_why_is_said():
    """Tables of 42 strokes had three rows a model, without a word why."""
    where = " All strokes are rows of processed/nylon/metrics.parquet, column stroke."
    paper = "(the paper has 1, 5 and 9)"
    assert shown_of(range(1, 43), (1, 5, 9), "nylon") == f"Shown are strokes 1, 5 and 9 of 1 to 42.{where}"
    assert shown_of(range(1, 6), (1, 5, 9), "nylon") == f"Shown are strokes 1 and 5 of 1 to 5 {paper}.{where}"
    assert f"Shown are strokes 21, 25 and 29 of 21 to 29 {paper}." in shown_of(range(21, 30), (1, 5, 9), "nylon")
    assert shown_of([2], (1, 5, 9), "m") == f"Shown is stroke 2, all that there are {paper}."
    assert shown_of([1, 5, 9], (1, 5, 9), "m") == ""


def test_a_figure_of_a_string_of_ones_own_shows_the_tables_strokes_and_the_last():
    assert tabled_and_last(range(1, 11), (1, 5, 9), 4) == [1, 5, 9, 10]
    assert tabled_and_last(range(1, 16), (1, 5, 9), 4) == [1, 5, 9, 15]
    assert tabled_and_last(range(1, 10), (1, 5, 9), 4) == [1, 5, 9] and tabled_and_last([1, 2], (1, 5, 9), 4) == [1, 2]
