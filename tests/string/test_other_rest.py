"""The zero of a run that begins under another load than the last rest: an earlier rest or a line in load tells it."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_recording import BASE, content, recording
from stages.nine_strokes import recorded, string

from pipeline.ground.words.jump_notes import CARRIED, EARLIER_REST, KNOWN_IN_PART, MODEL_VALUE, NOT_COMPARED
from pipeline.run.strokes import segment
from pipeline.stages.dataset import make_dataset
from pipeline.string.history import Recorded
from pipeline.string.not_compared import not_compared
from pipeline.string.other_rest import other_rest
from pipeline.string.rests import Rests
from pipeline.string.tare_notes import set_anew, tare_notes
from pipeline.string.zero import offsets_mm, zeros

MOVED_MM, MM_PER_N = 0.6, 1.0 / 28.0
MIXED_N = (20.0, 40.0, 15.0, 30.0, 50.0)  # the load of each rest of the first run, and of the stroke after it
NEXT_N = (25.0, 45.0, 35.0, 20.0, 30.0)
TWICE_N = (20.0, 50.0, 25.0, 50.0)  # two loads, and the first: no line can be tested


def samples(loads_n: tuple[float, ...], seed: int, wore_mm: float = 0.0, square_mm: float = 0.0) -> pd.DataFrame:
    """A string that stretches with its load, by 1 mm per 28 N beyond the model, and lengthens with each stroke."""
    table = recording(len(loads_n) - 1, rate_hz=20.0, seed=seed)
    rests = segment(table, "motor_turns", "a")
    load_n = np.full(len(table), loads_n[0])
    for after, begins in rests.loc[rests["phase"] == "rest", ["stroke", "first_sample"]].to_numpy(int).tolist():
        load_n[begins:] = loads_n[after]
    turns = table["motor_turns"].to_numpy()
    beyond_mm = -MM_PER_N * (load_n - 20.0) - square_mm * np.square(load_n - 30.0) / 100.0
    modelled_mm = BASE.contraction_mm(turns, load_n) - BASE.contraction_mm(turns, 20.0)
    worked = np.cumsum(np.maximum(np.diff(turns, prepend=0.0), 0.0)) / turns.max()
    moved_mm = modelled_mm + beyond_mm + (0.1 - wore_mm) * worked
    return table.assign(load_n=load_n, displacement_mm=table["displacement_mm"] + moved_mm)


def pair(
    first_n: tuple[float, ...] = MIXED_N, tare: str | None = "run", wore_mm: float = 0.0, square_mm: float = 0.0
) -> list[Recorded]:
    """Two runs of one string; before the second one its sensor was moved."""
    before = samples(first_n, 0, wore_mm, square_mm)
    after = samples(NEXT_N, 1, wore_mm, square_mm)
    shift_mm = MOVED_MM - wore_mm * (len(first_n) - 1)
    after = after.assign(displacement_mm=after["displacement_mm"] + shift_mm, time_s=after["time_s"] + 500.0)
    return [
        recorded("a-1", samples=before, string=string(id="a")),
        recorded("a-2", samples=after, string=string(id="a"), tare=tare),
    ]


def rests_of(runs: list[Recorded]) -> list[Rests]:
    return [Rests.of(each) for each in runs]


def test_under_a_load_between_those_of_earlier_rests_the_zero_is_known_without_the_stretch() -> None:
    """Such a run was set to the model's value, off by what the string stretches from its first load: 0.18 mm."""
    runs = pair()
    first, second = offsets_mm(runs)
    assert first - second == pytest.approx(MOVED_MM, abs=0.02)
    points = make_dataset(runs)
    nominal_mm = BASE.contraction_mm(points["motor_turns"].to_numpy(), points["load_n"].to_numpy())
    off_mm = points["displacement_mm"] - nominal_mm + MM_PER_N * (points["load_n"] - 20.0)
    by_run = off_mm.groupby(points["run"]).median()
    assert by_run["a-2"] - by_run["a-1"] == pytest.approx(0.0, abs=0.02)
    ((_, note),) = tare_notes(rests_of(runs))
    which = "the last rest of a-1, carried from 50 to 25 N by the straight line of its rests under 15 to 50 N"
    assert f"It is compared with {which} (0.36 mm per 10 N): so the zero was moved by +0." in note
    assert note.endswith(CARRIED)
    (note,) = set_anew(rests_of(runs))
    assert f" mm, by {which}" in note and note.endswith(CARRIED)


def test_an_earlier_rest_under_the_load_tells_the_zero_but_for_what_the_string_changed_since() -> None:
    wore_mm = 0.05
    runs = pair(TWICE_N, wore_mm=wore_mm)
    zero = zeros(rests_of(runs))[1]
    assert zero.told_by == "the rest of a-1 after its stroke 2, under 25 N too" and zero.doubt == EARLIER_REST
    assert zero.moved_mm == pytest.approx(MOVED_MM - wore_mm, abs=0.02), "one stroke's change is lost, and said"
    ((_, note),) = tare_notes(rests_of(runs))
    assert f"It is compared with {zero.told_by}: so the zero was moved by" in note and note.endswith(EARLIER_REST)


def test_of_earlier_runs_the_latest_whose_zero_is_known_tells_it() -> None:
    first_run, second = rests_of(pair(TWICE_N))
    described = first_run.run
    between = replace(first_run, run=described.model_copy(update={"run": "a-1b"}), load_n=(80.0, 80.0, 80.0, 80.0))
    zero = zeros([first_run, between, second])[2]
    assert zero.told_by.startswith("the rest of a-1 after") and zero.moved_mm == pytest.approx(MOVED_MM, abs=0.02)
    nearer = replace(between, load_n=(80.0, 25.0, 80.0, 80.0))
    assert zeros([first_run, nearer, second])[2].told_by.startswith("the rest of a-1b after its stroke 1, ")
    anew = replace(nearer, run=between.run.model_copy(update={"tare": "run"}), load_n=(200.0, 25.0, 80.0, 80.0))
    assert zeros([first_run, anew, second])[1].doubt == MODEL_VALUE
    told_by = zeros([first_run, anew, second])[2].told_by
    assert told_by.startswith("the rest of a-1 after"), "the zero of a run at the model's value is unknown"


def test_a_line_in_load_is_refused_where_the_rests_show_none() -> None:
    before, after = rests_of(pair())
    assert other_rest(before, after)
    for load_n in (10.0, 60.0):  # outside of the loads
        assert other_rest(before, replace(after, load_n=(load_n,))) is None
    assert other_rest(before, replace(after, turns=(10.0,))) is None
    two_loads = replace(before, load_n=(15.0, 50.0, 15.0, 50.4, 50.0))
    assert other_rest(two_loads, after) is None
    bent = rests_of(pair(square_mm=0.05))
    assert other_rest(*bent) is None, "a line that the rests stray from by more than the noise"
    worn = rests_of(pair(wore_mm=0.1))
    assert other_rest(*worn) is None, "nor one that the string's own change bends"


def test_without_such_a_rest_the_words_name_what_the_zero_is_off_by() -> None:
    """They named what the string had changed before alone, and not its stretch, which was all of it."""
    rests = rests_of(pair((20.0, 50.0, 50.0)))
    assert zeros(rests)[1].moved_mm is None
    for note in (tare_notes(rests)[0][1], set_anew(rests)[0]):
        assert "off by what the string stretches from its first load to this one beyond the model" in note


def test_what_is_not_compared_says_what_a_tare_would_compare() -> None:
    (note,) = not_compared(rests_of(pair(tare=None)))
    assert "its first rest is then compared with the last rest of a-1, carried from 50 to 25 N by" in note
    (note,) = not_compared(rests_of(pair((20.0, 50.0, 50.0), tare=None)))
    assert "its first rest is then set to the model's value. If neither moved" in note


@pytest.mark.parametrize("tare", [None, "checked"])
def test_new_run_says_that_the_zero_of_a_second_run_is_not_compared(tmp_path: Path, tare: str | None) -> None:
    """It said nothing, as if the rests had been compared and were the same."""
    folder = tmp_path / "raw" / "a-1"
    folder.mkdir(parents=True)
    (folder / "run.yaml").write_text(json.dumps(content("a-1", string=string(id="a"))))
    first_run, second = pair(tare=None)
    first_run.samples.to_parquet(folder / "recording.parquet", index=False)
    second.samples.to_csv(tmp_path / "second.csv", index=False)
    how = ["--tare", tare] if tare else []
    words = ("a-2", "--like", folder, "--recording", tmp_path / "second.csv", *how)
    done = programs.run("pipeline.new_run", *words)
    assert done.returncode == 0, done.stderr
    why = f"warning: {NOT_COMPARED} a-1 and a-2: a-1 rests last at 50 N, a-2 begins at 25 N, "
    mend = f"(python -m pipeline.mend {tmp_path / 'raw' / 'a-2'} tare=run)"
    warnings = " ".join(done.stderr.split())
    assert (why in warnings and mend in warnings) == (tare is None)


def test_lifespan_says_no_more_of_such_a_zero_than_is_known(tmp_path: Path) -> None:
    """It called a zero at the model's value known within 0.05 mm in the median."""
    folders = [tmp_path / "raw" / name for name in ("a-1", "a-2")]
    for folder, recorded_run in zip(folders, pair((20.0, 50.0, 50.0)), strict=True):
        folder.mkdir(parents=True)
        tare = "run" if folder.name == "a-2" else None
        (folder / "run.yaml").write_text(json.dumps(content(folder.name, string=string(id="a"), tare=tare)))
        recorded_run.samples.to_parquet(folder / "recording.parquet", index=False)
    done = programs.run("pipeline.lifespan", *folders, "--out", tmp_path / "life")
    assert done.returncode == 0, done.stderr
    words = " ".join(done.stdout.split())
    assert MODEL_VALUE in words and KNOWN_IN_PART not in words
