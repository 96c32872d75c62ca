"""By how much the zeros of runs that were diagnosed together differ, in the details."""

from made_content import CONTENT, content, page, told

MOVE = {"value": 0.5961, "low": 0.5932, "high": 0.5993}


def together(count=3):
    """Runs of one diagnosis, each later one with its zero 0.6 mm above the first one's."""
    zeros = {f"zero_{number}_mm": {"nominal": 0.0, "value": -150.0} for number in range(1, count + 1)}
    for number in range(2, count + 1):
        zeros[f"zero_{number}_mm"]["from_first"] = MOVE
    return content(run=[f"k-{number}" for number in range(1, count + 1)], parameters=CONTENT["parameters"] | zeros)


def test_the_details_say_by_how_much_each_zero_differs_from_the_first_ones():
    """A zero that was moved between runs stood in no word."""
    text = " ".join(told(together(), ("raw/k-1", "raw/k-2", "raw/k-3")).split())
    amount = "+0.596 mm (+0.593 to +0.599)"
    line = f"The zero of the reading, less that of k-1 (90 % interval): k-2 {amount} and k-3 {amount}."
    assert text.partition(" Dimensions ")[2].partition(" The run to make next ")[0].count(line) == 1
    assert "less that of" not in " ".join(page(together(), ("raw/k-1", "raw/k-2", "raw/k-3")))
    assert "less that of" not in told()


def test_of_many_runs_the_first_are_named():
    text = " ".join(told(together(12), tuple(f"raw/k-{number}" for number in range(1, 13))).split())
    assert "k-9 +0.596 mm (+0.593 to +0.599) and 3 more runs (in diagnosis.json)." in text


def test_an_older_file_says_nothing_of_it():
    older = together(2)
    del older["parameters"]["zero_2_mm"]["from_first"]
    assert "less that of" not in told(older, ("raw/k-1", "raw/k-2"))
