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
    assert " ".join(text.split()).startswith(
        "a: 18 strokes recorded, 13 of them compared under 20 N (1 to 13). The model below is calibrated on the first "
        "3 of them. Left out: 5 strokes under 40 N (14 to 18). A change of load is no ageing; 20 N has the most (13 "
        "strokes). Strokes left are counted from stroke 13: the string did 5 strokes since."
    )
    assert "Beware: zero not compared between a-1 and a-2: a-1 rests last at 20 N, a-2 begins at 40 N, " in text
    assert saved["load_n"] == pytest.approx(20.0) and saved["strokes_of_another_load"] == [14, 15, 16, 17, 18]
    assert saved["strokes_seen"] == 13 and len(saved["zeros_not_compared"]) == 1
    assert max(saved["indicators"]["model_error_mm"]) < 0.1
    docs = (Path(__file__).parents[2] / "docs" / "lifespan.md").read_text()
    assert all("A change of load is no ageing" in " ".join(words.split()) for words in (text, docs))


def test_of_as_many_strokes_those_of_the_last_load_count_and_more_of_them_are_asked_for(tmp_path: Path) -> None:
    text, saved = asked(tmp_path, (7, 20.0), (7, 40.0))
    text = " ".join(text.split())
    assert text.startswith(
        "a: no forecast yet: 14 strokes recorded, 7 of them compared under 40 N (8 to 14); at least 12 under one load"
    )
    assert re.search(r"Record 5 or more further strokes of this very string under 40 N as a new run \(.* a-2\)", text)
    assert "passed" not in text and "the string did" not in text
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


def test_the_range_of_which_stroke_is_left_out_is_the_median_of_the_first_and_not_what_they_all_do(
    tmp_path: Path,
) -> None:
    """ "Not wound over 0.0587 to 17.9 turns, as the first 3 do" of strokes of which the third was left out."""
    ages = samples(5, 0.0)
    ages.loc[ages.index // 114 == 2, "motor_turns"] *= 0.8
    runs = [
        folder(tmp_path, "a-1", ages, string=string(id="a")),
        folder(tmp_path, "a-2", under(samples(3, 0.0), 40.0, 1e4), string=string(id="a")),
    ]
    words = " ".join(programs.run("pipeline.lifespan", *runs, "--out", tmp_path / "out").stdout.split())
    median = "turns within 5 %, the median of the first 3 strokes under 20 N (1 to 3)."
    assert "Left out: 1 stroke under 20 N (3), not wound over" in words and median in words


@pytest.mark.parametrize("swing_n", [0.0, 4.0])
def test_strokes_of_one_load_are_all_compared(tmp_path: Path, swing_n: float) -> None:
    table = samples(14, 0.002, load_swing_n=swing_n)
    (health,) = strings([folder(tmp_path, "a-1", table)])
    assert isinstance(health, Health) and len(health.strokes) == 14
    assert not health.loads.others and not health.uncompared


def test_a_stroke_that_was_done_under_another_load_is_no_stroke_to_ask_again_at(tmp_path: Path) -> None:
    """It said "at stroke 26" of a string that had done 33: 13 under the one load and 20 more since."""
    text = " ".join(asked(tmp_path, (13, 20.0), (10, 40.0), (10, 60.0))[0].split())
    again = "Ask again once strokes under 20 N are recorded after stroke 33: stroke 26, at which that was due, is done."
    assert again in text and "passed already" not in text
    text = " ".join(asked(tmp_path / "fewer", (13, 20.0), (5, 40.0))[0].split())
    assert re.search(r"\d+ strokes left after stroke 13 in 90 % of the futures", text)
    assert re.search(r"Ask again at stroke \d+, (the next one|\d+ strokes from now): the string has done 18\.", text)


def test_where_calibration_and_question_are_both_overdue_one_sentence_says_what_to_do_now(tmp_path: Path) -> None:
    """Both strokes were printed with "(passed already)": no advice. "18 compared" stood beside "14 strokes seen"."""
    ages = samples(18, 0.0)
    turned = ages.index // 114
    ages.loc[np.isin(turned, (12, 13, 14, 15)), "motor_turns"] *= 0.8
    contraction_mm = BASE.contraction_mm(ages["motor_turns"].to_numpy(), 20.0) * (1.0 - 0.0005 * turned)
    noise_mm = 0.02 * np.random.default_rng(1).standard_normal(len(ages))
    ages["displacement_mm"] = contraction_mm - 0.05 * turned + noise_mm
    runs = [
        folder(tmp_path, "a-1", ages, string=string(id="a")),
        folder(tmp_path, "a-2", under(samples(4, 0.0), 40.0, 1e4), string=string(id="a")),
    ]
    done = programs.run("pipeline.lifespan", *runs, "--drift-mm", "0.9", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    text = " ".join(done.stdout.split())
    assert len(done.stdout.splitlines()) <= 32
    assert text.startswith(
        "a: 22 strokes recorded, 14 of them compared under 20 N over 0 to 20 turns (1 to 12, 17 to 18)."
    )
    assert "Left out: 4 strokes under 20 N (13 to 16), not wound over 0 to 20 turns within 5 %" in text
    assert "Left out: 4 strokes under 40 N (19 to 22)." in text and "strokes seen" not in text
    now = r"Advice: calibrate your model again now, on the strokes recorded; ask again once strokes under 20 N are "
    now += r"recorded after stroke 22: stroke (19|20|21|22), at which the calibration was due, is among the 22 strokes "
    now += r"done\."
    assert re.search(now, text) and "passed already" not in text
    assert text.index("Until 10 % of the stroke") < text.index("Until that model") < text.index("Advice")


def test_of_loads_with_as_many_strokes_the_last_is_compared_and_it_says_so() -> None:
    """A person with three strokes under each of two loads was not told why one of them was taken."""
    loads = Loads(30.0, [4, 5, 6], [(20.0, [1, 2, 3])])
    assert "A change of load is no ageing; 30 N has as many as the most, and later (3 strokes)." in loads.left_out
