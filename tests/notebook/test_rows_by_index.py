"""Rows of a table in memory are named by the labels of its index, which `DataFrame.drop` takes, and not by a count."""

import re

import numpy as np
import pandas as pd
import pytest
from made_recording import content, recording

import pipeline as tb

DESCRIPTION = {key: value for key, value in content("a-01").items() if key != "run"}
NOTE = "--- Bemerkung: Tür auf ---"
STEP = pd.DataFrame({"time_s": [0.0, 5.0, 2.0], "motor_turns": [0.0, 5.0, 0.0], "load_n": 20.0}, index=[7, 8, 9])


def log(cell: object = NOTE, column: str = "time_s") -> pd.DataFrame:
    """Samples whose 779th row is wrong."""
    samples = recording(6).astype({column: object})
    samples.loc[778, column] = cell
    return samples


@pytest.fixture(scope="module")
def nylon() -> tb.Recording:
    return tb.Recording.of(recording(6), DESCRIPTION)


def refused(samples: pd.DataFrame, **more: object) -> str:
    with pytest.raises(tb.BadInput) as caught:
        tb.Recording.of(samples, {**DESCRIPTION, **more})
    return str(caught.value)


def test_the_row_that_is_named_can_be_dropped_by_that_name() -> None:
    samples = log()
    fault = re.search(r"time_s: the row of index (\d+) holds .*Mend: remove that row", refused(samples))
    assert fault and fault[1] == "778"
    mended = tb.Recording.of(samples.drop(int(fault[1])), DESCRIPTION)
    assert len(mended.samples) == len(samples) - 1


@pytest.mark.parametrize(
    ("cell", "column", "words"),
    [
        (np.nan, "displacement_mm", "1 of 4550 rows, first in the row of index 778. Mend: remove the rows"),
        (0.0, "time_s", "time_s: runs backwards at the row of index 778"),
    ],
)
def test_every_fault_of_a_sample_names_its_label(cell: float, column: str, words: str) -> None:
    assert words in refused(log(cell, column).astype(float))


def test_a_leap_of_the_clock_is_named_by_its_label() -> None:
    samples = recording(6)
    samples.loc[778:, "time_s"] += 1e6
    assert " s in the row of index 777 and " in refused(samples)


def test_a_label_may_be_a_word_and_one_of_several_rows_tells_none() -> None:
    samples = log()
    assert "the row of index r778 holds" in refused(samples.set_index("r" + samples.index.astype(str)))
    assert "the row of iloc 778 holds" in refused(samples.set_index(samples.index % 100))


def test_rows_that_the_description_asks_for_keep_their_labels() -> None:
    assert "the row of index 778 holds" in refused(log(), file={"rows": [100, 2000]})


def test_times_of_day_are_named_by_label() -> None:
    clock = pd.Timestamp("2026-11-21") + pd.to_timedelta(recording(6)["time_s"], unit="s")
    samples = log().assign(time_s=clock.dt.strftime("%H:%M:%S.%f"))
    samples.loc[778, "time_s"] = NOTE
    assert re.search(r"the row of index 778 holds .* not a time of day .* remove that row", refused(samples))


def test_a_sample_that_no_rig_can_read_is_told_by_its_label(capsys: pytest.CaptureFixture[str]) -> None:
    tb.Recording.of(log(1e6, "displacement_mm").astype(float), DESCRIPTION)
    assert "in the row of index 778, where its neighbours" in capsys.readouterr().err


def test_the_rows_of_a_motion_are_named_by_label(nylon: tb.Recording) -> None:
    with pytest.raises(tb.BadInput, match=r"to 2 s in the row of index 8 and the row of index 9\."):
        nylon.simulate(motion=STEP)
    with pytest.raises(tb.BadInput, match=r"motor_turns: .* 1 of 3 rows, first in the row of index 9\."):
        nylon.simulate(motion=STEP.assign(time_s=[0.0, 2.0, 5.0], motor_turns=[0.0, 5.0, np.nan]))


def test_the_rows_of_questions_are_named_by_label(nylon: tb.Recording) -> None:
    points = tb.points([nylon])
    question = pd.DataFrame({"stroke": [1.5], "direction": [1], "motor_turns": [5.0]}, index=[41])
    with pytest.raises(tb.BadInput, match=r"^questions: stroke: is 1\.5 in the row of index 41, no whole number"):
        tb.answers(points, question, "polynomial")
    several = pd.concat([question] * 5).set_axis([41, 42, 43, 50, 60], axis=0).assign(direction=[1, 1, 1, 3, 3])
    with pytest.raises(tb.BadInput, match=r"^questions: rows: 5 cannot be answered\. Mend") as caught:
        tb.answers(points, several.assign(stroke=[1.5, 1.5, 1.5, 1, 1]), "polynomial")
    assert "  the rows of index 41 to 43: stroke is 1.5" in str(caught.value)
    assert "  the rows of index 50, 60: direction is 3" in str(caught.value)
