"""A change of the load is no ageing: strokes under one load are compared, and the others are said to be left out."""

import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_life import folder, samples
from made_recording import BASE
from stages.nine_strokes import string

from pipeline.lifespan.from_folders import strings
from pipeline.lifespan.stroke_health.health import Health
from pipeline.lifespan.stroke_health.one_load import Loads

STIFFNESS = BASE.stiffness_n_per_mm


def under(table: pd.DataFrame, load_n: float, begins_s: float) -> pd.DataFrame:
    """A recording that begins at a time, under another load than 20 N, by which the string is longer."""
    longer_mm = (load_n - 20.0) / STIFFNESS
    return table.assign(
        time_s=table["time_s"] + begins_s, load_n=load_n, displacement_mm=table["displacement_mm"] - longer_mm
    )


def lives(place: Path, *parts: tuple[int, float]) -> list[Path]:
    """Runs of one string that does not age, each of so many strokes under a load."""
    runs = []
    for number, (strokes, load_n) in enumerate(parts):
        table = samples(strokes, 0.0)
        ageless = table["displacement_mm"] + 0.05 * np.minimum(np.arange(len(table)) // 114, strokes - 1)
        table = under(table.assign(displacement_mm=ageless), load_n, 1e4 * number)
        runs.append(folder(place, f"a-{number + 1}", table, string=string(id="a")))
    return runs


def asked(place: Path, *parts: tuple[int, float]) -> tuple[str, dict]:
    """What the program prints, and what it writes."""
    done = programs.run("pipeline.lifespan", *lives(place, *parts), "--out", place / "out")
    assert done.returncode == 0, done.stderr
    return done.stdout, json.loads((place / "out" / "a" / "lifespan.json").read_text())


def test_a_change_of_load_is_no_ageing(tmp_path: Path) -> None:
    """It said that a model was off by 2 mm and to be calibrated now, of a string that had not aged at all."""
    text, saved = asked(tmp_path, (13, 20.0), (5, 40.0))
    assert "calibrate your model again now" not in text and "passed already" not in text
    assert text.startswith("a: 13 strokes seen under 20 N, the last one stroke 13.\n")
    compared = "Loads differ: only the 13 strokes under 20 N are compared (1 to 13): no other load has as many."
    assert f"{compared} A change of load is no ageing." in " ".join(text.split())
    assert "  Left out: 5 strokes under 40 N (14 to 18)." in text
    since = "The string did 5 strokes more since: strokes left are counted from stroke 13, the last one under 20 N."
    assert since in text
    assert "Beware: zero not compared between a-1 and a-2: a-1 rests last at 20 N, a-2 begins at 40 N." in text
    assert saved["load_n"] == pytest.approx(20.0) and saved["strokes_of_another_load"] == [14, 15, 16, 17, 18]
    assert saved["strokes_seen"] == 13 and len(saved["zeros_not_compared"]) == 1
    assert max(saved["indicators"]["model_error_mm"]) < 0.1
    docs = (Path(__file__).parents[2] / "docs" / "lifespan.md").read_text()
    assert all("A change of load is no ageing" in " ".join(words.split()) for words in (text, docs))


def test_of_as_many_strokes_those_of_the_last_load_count_and_more_of_them_are_asked_for(tmp_path: Path) -> None:
    text, saved = asked(tmp_path, (7, 20.0), (7, 40.0))
    text = " ".join(text.split())
    assert text.startswith("a: no forecast yet: 7 strokes seen under 40 N; at least 12 under one load are needed, 5")
    assert re.search(r"Record 5 or more further strokes of this very string under 40 N as a new run \(.* a-2\)", text)
    assert "passed" not in text and "The string did" not in text
    assert saved["strokes_of_another_load"] == [1, 2, 3, 4, 5, 6, 7] and saved["last_stroke"] == 14


def test_strokes_of_one_load_are_compared_across_those_of_another(tmp_path: Path) -> None:
    (health,) = strings(lives(tmp_path, (7, 20.0), (3, 30.0), (7, 20.5)))
    assert health.loads.kept == [*range(1, 8), *range(11, 18)] and health.loads.others == [(30.0, [8, 9, 10])]
    assert health.strokes["model_error_mm"].max() < 0.1
    assert len(health.uncompared) == 2


def test_a_load_that_is_hung_amid_a_run_is_seen_by_stroke(tmp_path: Path) -> None:
    first_part, other = samples(8, 0.0), samples(4, 0.0)
    ended = float(first_part["time_s"].iloc[-1]) + 0.1
    both = pd.concat([first_part, under(other, 40.0, ended)], ignore_index=True)
    (health,) = strings([folder(tmp_path, "a-1", both)])
    assert health.loads.kept == list(range(1, 9)) and [numbers for _, numbers in health.loads.others] == [
        [9, 10, 11, 12]
    ]


@pytest.mark.parametrize("swing_n", [0.0, 4.0])
def test_strokes_of_one_load_are_all_compared(tmp_path: Path, swing_n: float) -> None:
    table = samples(14, 0.002, load_swing_n=swing_n)
    (health,) = strings([folder(tmp_path, "a-1", table)])
    assert isinstance(health, Health) and len(health.strokes) == 14
    assert not health.loads.others and not health.loads.sentences and not health.uncompared


def test_a_stroke_that_was_done_under_another_load_is_no_stroke_to_ask_again_at(tmp_path: Path) -> None:
    """It said "at stroke 26" of a string that had done 33: 13 under the one load and 20 more since."""
    text = " ".join(asked(tmp_path, (13, 20.0), (10, 40.0), (10, 60.0))[0].split())
    assert "Ask again after 13 strokes, at stroke 26 (passed already: the string has done 33 strokes)." in text


def test_of_loads_with_as_many_strokes_the_last_is_compared_and_it_says_so() -> None:
    """A person with three strokes under each of two loads was not told why one of them was taken."""
    loads = Loads(30.0, [4, 5, 6], [(20.0, [1, 2, 3])])
    assert "under 30 N are compared (4 to 6): of loads with as many it is the last." in loads.sentences[0]
