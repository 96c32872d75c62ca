"""One of a thing is no plural: messages counted "1 rows" and "1 strokes"."""

import re

import numpy as np
import pytest
from made_recording import recording

from pipeline.ground.errors import BadInput
from pipeline.ground.words.counts import are, counted
from pipeline.lifespan.words.stroke_counts import strokes_at_least, strokes_at_most
from pipeline.run.samples import check_finite
from pipeline.string.jump import Jump


def test_one_is_singular_and_all_else_plural():
    assert [counted(count, "line") for count in (0, 1, 2)] == ["0 lines", "1 line", "2 lines"]
    assert counted(np.int64(1), "line") == "1 line" and counted(np.int64(3), "line") == "3 lines"
    assert (are(1), are(2)) == ("is", "are")
    assert (strokes_at_least(1.7), strokes_at_most(1.7)) == ("1 stroke", "2 strokes")


@pytest.mark.parametrize(("bad", "count_words"), [(1, "in 1 of 2300 rows, first in row 6"), (2, "in 2 of 2300 rows")])
def test_rows_without_a_number_are_counted_in_right_words(tmp_path, bad, count_words):
    samples = recording()
    samples.loc[5 : 4 + bad, "displacement_mm"] = np.nan
    with pytest.raises(BadInput, match=f"is not a number {count_words}"):
        check_finite(samples, tmp_path / "recording.csv")


@pytest.mark.parametrize(
    ("unrecorded", "count_words"), [(1, "1 stroke that was not recorded"), (2, "2 strokes that were not recorded")]
)
def test_strokes_between_two_runs_are_counted_in_right_words(unrecorded, count_words):
    jump = Jump("a-1", "a-2", 0.5, 0.01, unrecorded)
    assert re.search(rf"with {count_words} in between", jump.sentence)
