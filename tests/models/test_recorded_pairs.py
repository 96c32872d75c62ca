"""What `predict` calls inside was recorded: at that load as far as that twist; what lies between loads is said."""

import re
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_dataset import made_dataset, words_that_ask

from pipeline.ground.stored import schemas
from pipeline.models.parts.inside.recorded_pairs import Paired, pairs_of
from pipeline.models.parts.questions.between import Between
from pipeline.models.parts.questions.prediction_intervals import Intervals

TOP_AT_30_N = 16.0


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Five strokes under 20 N to 27 turns, the last two under 30 N and only to 16."""
    path = tmp_path_factory.mktemp("recorded") / "dataset.parquet"
    points = made_dataset(60, 7)
    points["load_n"] += np.random.default_rng(0).normal(0.0, 0.05, len(points))
    points.loc[points["stroke"] > 5, "load_n"] += 10.0
    points = points[(points["stroke"] <= 5) | (points["motor_turns"] <= TOP_AT_30_N)].reset_index(drop=True)
    schemas.write(points, schemas.DATASET, path)
    return path


def ask(dataset: Path, rows: list[str], *words: str, given_column: str = "motor_turns") -> tuple[pd.DataFrame, str]:
    questions, answers = dataset.with_name("questions.csv"), dataset.with_name("answers.csv")
    questions.write_text("\n".join([f"stroke,direction,{given_column},load_n", *rows]) + "\n")
    done = programs.run("pipeline.predict", dataset, questions, "--out", answers, *words)
    assert done.returncode == 0, done.stderr
    return pd.read_csv(answers, keep_default_na=False, na_values={"motor_turns_low": [""]}), done.stdout


@pytest.fixture(scope="module", params=["anew", "saved"])
def words(request: pytest.FixtureRequest, dataset: Path) -> tuple[str, ...]:
    return words_that_ask(dataset, is_saved=request.param == "saved")


def test_a_twist_that_no_run_under_its_load_came_near_is_outside(dataset: Path, words: tuple[str, ...]) -> None:
    """It was answered as inside with a narrow interval, and models contradicted each other."""
    table, out = ask(dataset, ["6,1,19,30", "6,1,16,30", "6,-1,19,30.4", "3,1,26,20", "3,1,27,30"], *words)
    assert table["inside"].tolist() == [False, True, False, True, False]
    reason = r"twist 19 turns is above (16\.\d+), the most recorded around load 30 N"
    limit = float(re.match(reason, table["why"][0])[1])
    assert table["why"].astype(bool).tolist() == [True, False, True, False, True] and "3 of them" in out
    assert ("the export answers" in table["why"][0]) == (words[0] == "--saved")
    table, _ = ask(dataset, [f"6,1,{limit},30", f"6,1,{limit + 0.02},30"], *words)
    assert table["inside"].tolist() == [True, False], "a limit that is named is itself inside"


def test_between_recorded_loads_is_inside_as_far_as_its_neighbours_and_said(
    dataset: Path, words: tuple[str, ...]
) -> None:
    table, out = ask(dataset, ["5,1,15,25", "5,1,21,25", "5,1,23,25", "5,1,21,29.5", "3,1,15,20.2"], *words)
    assert table["inside"].tolist() == [True, True, False, False, True]
    assert re.fullmatch(r"no load between 20\.\d+ and 29\.\d+ N was recorded.*", table["why"][0])
    between = table["why"][0].removesuffix("; the interval reaches over the answers at both")
    assert (between != table["why"][0]) == (words[0] != "--saved"), "a saved model gives no interval"
    assert table["why"][2].endswith(between) and table["why"][4] == "" and "2 between what was recorded" in out
    assert "no load" not in table["why"][3], "29.5 N is as near to 30 N as the range has room"


def test_answers_are_counted_by_the_kind_of_their_reason_whatever_its_words(
    dataset: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They were counted by the words at the ends of their reasons."""
    monkeypatch.setattr(Between, "said", lambda *_: "the interval is 2 times as wide")
    table, out = ask(dataset, ["5,1,15,25", "3,1,15,20.2"], "--model", "polynomial")
    assert table["why"][0].endswith("there; the interval is 2 times as wide") and table["why"][1] == ""
    assert "; 1 between what was recorded. The column" in out and "errs more" not in out, out


def test_a_contraction_that_only_more_twist_than_was_recorded_gives_is_outside(
    dataset: Path, words: tuple[str, ...]
) -> None:
    forward, _ = ask(dataset, ["6,1,15,30", "6,1,19,30"], *words)
    rows = [f"6,1,{value},30" for value in forward["displacement_mm"]]
    table, _ = ask(dataset, rows, *words, given_column="displacement_mm")
    assert table["inside"].tolist() == [True, False] and "recorded around load 30 N" in table["why"][1]
    assert table["motor_turns"][0] == pytest.approx(15.0, abs=0.1)
    assert table["motor_turns"][1] == pytest.approx(19.0 if words[0] == "--saved" else 16.4, abs=0.4)
    assert table["why"][1].startswith("HELD") == (words[0] != "--saved"), "the header gives the twist as it is"


@pytest.fixture
def fitted_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first fit of a test, to the same points, is that of its later questions as well: it takes seconds."""
    fits: list[tuple[pd.DataFrame, dict[str, object]]] = []
    fit = Intervals.fit

    def fit_once(self: Intervals, points: pd.DataFrame, seed: int) -> None:
        if not fits:
            fit(self, points, seed)
            fits.append((points, dict(vars(self))))
        pd.testing.assert_frame_equal(points, fits[0][0])
        vars(self).update(fits[0][1])

    monkeypatch.setattr(Intervals, "fit", fit_once)


@pytest.mark.long
def test_held_is_said_as_soon_as_the_answer_gives_another_contraction(dataset: Path, fitted_once: None) -> None:
    """All contractions up to 0.4 mm beyond the end of the curve were answered by that end, as inside."""
    top, _ = ask(dataset, ["3,1,27.1,20"], "--model", "spline")
    half = top["displacement_mm_high"][0] - top["displacement_mm"][0]
    asked_mm = top["displacement_mm"][0] + np.linspace(-0.2, 0.4, 25)
    table, _ = ask(
        dataset, [f"3,1,{value},20" for value in asked_mm], "--model", "spline", given_column="displacement_mm"
    )
    back, _ = ask(dataset, [f"3,1,{turns},20" for turns in table["motor_turns"]], "--model", "spline")
    off = np.abs(back["displacement_mm"] - asked_mm) > half
    is_held = table["why"].str.startswith("HELD")
    assert table["why"][is_held].str.endswith(" at this stroke, direction and load").all()
    assert is_held.tolist() == off.tolist() and 0 < is_held.sum() < len(is_held)
    assert (table["inside"] == ~is_held).all() and half < 0.3


def test_the_pairs_are_a_hull_with_room_and_a_column_that_hardly_varies_has_none() -> None:
    points = pd.DataFrame({"load_n": [10.0, 10.0, 20.0, 20.0, 30.0, 30.0], "motor_turns": [0.0, 10, 2, 20, 0, 10]})
    paired = Paired.of(points, "load_n")
    at = pd.DataFrame({"load_n": [10.0, 15.0, 20.0, 25.0, 30.0, 31.0, 8.0]})
    least, most = paired.turns(at)
    np.testing.assert_allclose(least, -0.2)
    np.testing.assert_allclose(most, np.array([11.0, 16.0, 20.0, 16.0, 11.0, 10.0, 10.0]) + 0.2)
    assert paired.never(at, np.full(7, 15.0)) == [
        "twist 15 turns is above 11.2, the most recorded around load 10 N", "", "", "",
        "twist 15 turns is above 11.2, the most recorded around load 30 N",
        "twist 15 turns is above 10.2, the most recorded around load 31 N", "",
    ]  # fmt: skip
    assert [bool(note) for note in paired.gaps(at)] == [False, True, False, True, False, False, False]
    assert pairs_of(made_dataset(20, 2)) == ()
