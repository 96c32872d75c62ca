"""A stroke under a load counts as recorded where runs came near the two together; beyond, no answer is `inside`."""

from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_dataset import made_dataset, words_that_ask

from pipeline.ground.stored import schemas
from pipeline.models.parts.inside.recorded_strokes import Under


def two_loads() -> pd.DataFrame:
    """One string of 12 strokes, the first six under 30 N and the others under 20 N, where it is 0.7 mm shorter."""
    points = made_dataset(60, 12)
    points["load_n"] = np.where(points["stroke"] <= 6, 30.0, 20.0)
    points["displacement_mm"] += (20.0 - points["load_n"]) / 15.0
    return points


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("strokes") / "dataset.parquet"
    schemas.write(two_loads(), schemas.DATASET, path)
    return path


def ask(dataset: Path, rows: list[str], *words: str) -> pd.DataFrame:
    questions, answers = dataset.with_name("questions.csv"), dataset.with_name("answers.csv")
    questions.write_text("\n".join(["stroke,direction,load_n,motor_turns,displacement_mm", *rows]) + "\n")
    done = programs.run("pipeline.predict", dataset, questions, "--out", answers, *words)
    assert done.returncode == 0, done.stderr
    return pd.read_csv(answers, keep_default_na=False)


@pytest.mark.parametrize("saved", [False, True])
def test_a_stroke_that_no_run_under_its_load_came_near_is_not_inside(dataset: Path, saved: bool) -> None:
    """It was answered as inside with a narrow interval and no word, far beyond all that was recorded."""
    words = words_that_ask(dataset, is_saved=saved)
    rows = ["9,1,30,10,", "9,-1,30,,3", "3,1,20,10,", "3,1,30,10,", "9,1,20,10,", "7,1,30,10,", "13,1,20,10,"]
    table = ask(dataset, rows, *words)
    assert table["inside"].tolist() == [False] * 3 + [True] * 4
    why = table["why"].tolist()
    assert all(
        each.startswith("stroke 9 was not recorded under load 30 N: the last stroke there is 6") for each in why[:2]
    )
    assert why[2].startswith("stroke 3 was not recorded under load 20 N: the first stroke there is 7")
    assert why[3:] == [""] * 4
    assert all(("tsa_recorded says of which" in each) == saved for each in why[:3])


def test_an_answer_beyond_all_that_was_recorded_is_not_inside(tmp_path: Path) -> None:
    """A string that grows by 1 mm a stroke: three strokes ahead it is beyond all that was recorded."""
    path = tmp_path / "dataset.parquet"
    points = made_dataset(60, 9)
    points["displacement_mm"] += points["stroke"]
    schemas.write(points, schemas.DATASET, path)
    table = ask(path, ["12,1,20,27,", "9,1,20,10,"], "--model", "polynomial")
    most = points["displacement_mm"].max()
    reason = r"the answer is beyond all that was recorded: contraction [\d.]+ mm is above ([\d.]+), the most that was"
    assert table["inside"].tolist() == [False, True] and table["displacement_mm"][0] > most
    assert float(table["why"].str.extract(reason)[0][0]) == pytest.approx(most, rel=0.02)


@pytest.mark.long
def test_between_two_loads_a_stroke_is_inside_only_where_strokes_under_both_came_near(tmp_path: Path) -> None:
    """A string under 20 N, then 35 N, then 20 N: at 28 N the answer for an early stroke was 7 mm off, and inside."""
    path = tmp_path / "dataset.parquet"
    points = made_dataset(60, 9)
    points["load_n"] = np.where(points["stroke"].between(4, 6), 35.0, 20.0)
    schemas.write(points, schemas.DATASET, path)
    table = ask(path, ["2,1,28,10,", "2,-1,28,,3", "5,1,28,10,", "9,1,28,10,", "2,1,20,10,"])
    assert table["inside"].tolist() == [False, False, True, False, True]
    first = "stroke 2 was not recorded both below and above load 28 N: the first stroke near both is 3"
    assert all(reason.startswith(first) for reason in table["why"][:2])
    last = "stroke 9 was not recorded both below and above load 28 N: the last stroke near both is 7"
    assert table["why"][3].startswith(last)
    assert "was not recorded both" not in table["why"][2]


def test_between_loads_that_no_stroke_shares_none_is_recorded() -> None:
    """Strokes 1 to 3 under 20 N, 7 to 9 under 30 N; the sentence named a first stroke after the last."""
    points = made_dataset(20, 9)
    points = points[~points["stroke"].between(4, 6)]
    points["load_n"] = np.where(points["stroke"] < 5, 20.0, 30.0)
    under = Under.of(points, 1)
    assert under is not None
    questions = pd.DataFrame({"load_n": 25.0, "stroke": [2.0, 5.0, 8.0]})
    reason = "was not recorded both below and above load 25 N: no stroke is near both"
    assert under.never(questions, np.zeros(3)) == [f"stroke {stroke} {reason}" for stroke in (2, 5, 8)]


def test_under_loads_that_rise_and_fall_with_the_strokes_those_around_a_load_count() -> None:
    """Every stroke has its own load: one counts where others before and after it were under less and under more."""
    loads_n = [10.0, 30.0, 20.0, 14.0, 26.0, 17.0]
    points = made_dataset(20, 6).assign(load_n=lambda table: table["stroke"].map(dict(enumerate(loads_n, start=1))))
    under = Under.of(points, 1)
    assert under is not None
    questions = pd.DataFrame({"load_n": [22.0, 22.0, 22.0, 15.0, 29.5], "stroke": [1.0, 3.0, 6.0, 5.0, 5.0]})
    reasons = under.never(questions, np.zeros(5))
    assert [bool(reason) for reason in reasons] == [True, False, False, False, True]


def test_the_strokes_under_a_load_go_on_ahead_under_the_last_load_of_each_string() -> None:
    under = Under.of(two_loads(), 3)
    assert under is not None
    loads = pd.DataFrame({"load_n": [20.0, 25.0, 30.0]})
    first, last = under.strokes(loads, np.full(3, 10.0))
    np.testing.assert_allclose(first, [6.5, 6.0, 0.5])
    np.testing.assert_allclose(last, [16.0, 7.0, 7.0])
    light_string, other = made_dataset(20, 4), made_dataset(20, 6).assign(string="b", load_n=30.0)
    apart = Under.of(pd.concat([light_string, other]), 1)
    questions = pd.DataFrame({"load_n": [20.0, 20.0, 30.0, 30.0, 50.0], "stroke": [5.0, 7.0, 7.0, 90.0, 3.0]})
    assert apart is not None
    assert [bool(reason) for reason in apart.never(questions, np.full(5, 10.0))] == [False, True, False, False, False]
    assert Under.of(light_string, 1) is None


def test_a_stroke_counts_under_a_load_only_as_far_as_it_was_wound_there() -> None:
    """One sample of a stroke's last rest was under the next load: the whole stroke counted as recorded under it."""
    points = two_loads()
    rest = points[(points["stroke"] == 6)].index[-1]
    points.loc[points["stroke"] > 6, "load_n"] = 40.0
    points.loc[rest, ["load_n", "motor_turns"]] = 40.0, 0.0
    points.loc[points["stroke"] == 3, "load_n"] = np.where(points["motor_turns"][points["stroke"] == 3] < 9, 40.0, 30.0)
    under = Under.of(points, 1)
    assert under is not None
    questions = pd.DataFrame({"load_n": 40.0, "stroke": [6.0, 6.0, 7.0, 3.0, 3.0, 2.0, 13.0, 5.0]})
    why = under.never(questions, np.array([0.0, 26.0, 26.0, 5.0, 20.0, 0.0, 26.0, 5.0]))
    assert [bool(reason) for reason in why] == [False, True, False, False, True, True, False, False]
    assert why[1] == "stroke 6 was not recorded under load 40 N as far as 26 turns: the first stroke there is 7"
    assert why[5] == "stroke 2 was not recorded under load 40 N: the first stroke there is 3"
    assert not any(under.never(points, points["motor_turns"].to_numpy(float))), "what was recorded counts as that"


def test_a_load_that_comes_back_every_few_strokes_is_near_the_strokes_around_it() -> None:
    """Loads in turn: 20 N is between 10 and 30 N, and its strokes are one before and one after theirs."""
    points = made_dataset(20, 9)
    points["load_n"] = np.take([10.0, 20.0, 30.0], (points["stroke"].to_numpy() - 1) % 3)
    others = points[points["load_n"] != 20.0]
    questions = pd.DataFrame({"load_n": 20.0, "stroke": [1.0, 2.0, 5.0, 8.0, 10.0]})
    under = Under.of(others, 1)
    assert under is not None
    assert under.never(questions, np.zeros(5)) == [""] * 5
    in_blocks = others.assign(load_n=np.where(others["stroke"] < 5, 10.0, 30.0))
    under = Under.of(in_blocks, 1)
    assert under is not None
    assert [bool(reason) for reason in under.never(questions, np.zeros(5))] == [True, True, False, True, True]
