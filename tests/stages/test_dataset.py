import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_recording import BASE, recording
from stages.nine_strokes import NINE, recorded, string

from pipeline.ground.stored import schemas
from pipeline.stages.dataset import HELD_OUT_POINTS, blocks_from_top, held_out, make_dataset
from pipeline.stages.splits import Thinned
from pipeline.string.history import Recorded, in_order, tare_mm


def test_points_move_and_carry_the_string():
    assert list(NINE.columns) == schemas.DATASET.names
    assert set(NINE["phase"]) == {"winding", "unwinding"}
    assert (NINE["direction"] == np.where(NINE["phase"] == "winding", 1, -1)).all()
    assert sorted(set(NINE["stroke"])) == list(range(1, 10))
    assert (NINE["radius_tolerance"] == 0.03).all() and (NINE["length_tolerance_mm"] == 2).all()
    assert (NINE["radius_mm"] == 0.4).all() and (NINE["separator_mm"] == 8).all() and (NINE["load_n"] == 20).all()


def test_every_sample_of_a_moving_stretch_is_a_point_the_last_one_too():
    recorded_run = recorded(samples=recording(2))
    moving = recorded_run.strokes[
        recorded_run.strokes["phase"].isin(["winding", "unwinding"]) & (recorded_run.strokes["stroke"] > 0)
    ]
    at = np.concatenate([np.arange(a, b + 1) for a, b in moving[["first_sample", "last_sample"]].to_numpy()])
    assert make_dataset([recorded_run])["time_s"].tolist() == recorded_run.samples["time_s"].iloc[np.sort(at)].tolist()


def test_exactly_5000_training_points_in_both_splits():
    for split in ("within", "later"):
        assert (NINE[split] == "train").sum() == 5000
        assert set(NINE[split]) == {"train", "test", ""}


def test_no_block_leaks_within():
    blocks = NINE.groupby(["string", "stroke", "phase", "block"])["within"].agg(set)
    assert all("test" not in labels or labels == {"test"} for labels in blocks)
    assert 0.2 < (NINE["within"] == "test").mean() < 0.3


def test_no_stroke_leaks_later():
    strokes = NINE.groupby("stroke")["later"].agg(set)
    assert [n for n, labels in strokes.items() if labels == {"test"}] == [8, 9]
    assert all("test" not in labels for n, labels in strokes.items() if n <= 7)


def test_each_group_of_four_blocks_holds_out_another_one():
    stroke = np.ones(16, np.int64)
    assert np.flatnonzero(held_out(np.arange(16), stroke)).tolist() == [0, 6, 9, 15]
    over_four = np.concatenate([np.flatnonzero(held_out(np.arange(16), n * stroke)) for n in range(1, 5)])
    assert sorted(over_four.tolist()) == list(range(16))


def test_points_are_thinned_evenly_from_the_first_to_the_last():
    thinned = Thinned(100, 4)
    chosen = np.concatenate([thinned.chosen(np.ones(count, bool)) for count in (30, 50, 20)])
    assert np.flatnonzero(chosen).tolist() == [0, 33, 66, 99]


def test_splits_know_no_seed():
    again = make_dataset([recorded()])
    assert again.equals(NINE)


def test_the_table_strokes_hold_out_their_top_and_every_twist_is_held_out_somewhere():
    winding = NINE[NINE["phase"] == "winding"]
    for stroke, points in winding.groupby("stroke"):
        top = points.loc[points["motor_turns"].idxmax(), "within"]
        assert (top == "test") == (stroke in (1, 5, 9))
    tested = winding.loc[winding["within"] == "test", "motor_turns"]
    edges = np.histogram(tested, bins=20, range=(0, 27))[0]
    assert (edges > 0).all()


@given(st.integers(0, 5000))
def test_blocks_count_down_to_the_top(samples):
    block = blocks_from_top(samples)
    assert len(block) == samples
    if samples:
        assert block[-1] == 0 and (np.diff(block) <= 0).all() and block[0] == min(max(samples // 10, 1), 80) - 1
        assert np.unique(block, return_counts=True)[1].min() >= min(samples, 10)


def test_a_quarter_of_the_blocks_is_held_out_and_four_strokes_cover_them():
    block = np.arange(80)
    sets = [held_out(block, np.full(80, stroke)) for stroke in range(1, 10)]
    assert all(chosen.sum() == 20 for chosen in sets)
    assert np.sum(sets[:4], axis=0).tolist() == [1] * 80
    assert (sets[0] == sets[4]).all() and sets[0][0]


@pytest.mark.parametrize(("strokes", "tested"), [(4, [4]), (5, [5]), (6, [6]), (8, [7, 8]), (9, [8, 9]), (10, [9, 10])])
def test_later_tests_the_last_quarter(strokes, tested):
    dataset = make_dataset([recorded(samples=recording(strokes))])
    assert sorted(set(dataset.loc[dataset["later"] == "test", "stroke"])) == tested


def test_later_is_skipped_below_four_strokes():
    dataset = make_dataset([recorded(samples=recording(3))])
    assert set(dataset["later"]) == {""}
    assert (dataset["within"] == "test").any()


def test_tare_sets_the_rest_before_the_first_stroke_to_the_models_value():
    recorded_run = recorded()
    rest = recorded_run.samples["time_s"] < 1.8
    tared = recorded_run.samples.loc[rest, "displacement_mm"] + tare_mm(recorded_run)
    assert tared.median() == pytest.approx(BASE.contraction_mm(0.0, 20.0), abs=1e-6)


def test_tare_without_a_rest_takes_the_first_sample():
    samples = recording(3)
    samples = samples[samples["time_s"] > 6.0].reset_index(drop=True)  # begins within the first winding
    recorded_run = recorded(samples=samples)
    first = samples.iloc[0]
    expected = BASE.contraction_mm(first["motor_turns"], 20.0) - first["displacement_mm"]
    assert tare_mm(recorded_run) == pytest.approx(float(expected))


def test_runs_of_one_string_continue_each_other_and_share_the_tare():
    first, second = recording(3), recording(2, seed=1)
    second["displacement_mm"] -= 0.3
    runs = [recorded(name, samples=samples, string=string(id="s")) for name, samples in (("b", first), ("c", second))]
    dataset = make_dataset(runs[::-1])
    assert dataset.groupby("run")["stroke"].agg(lambda n: sorted(set(n))).to_dict() == {"b": [1, 2, 3], "c": [4, 5]}
    alone = make_dataset([recorded("c", samples=second)])
    assert set(alone["stroke"]) == {1, 2}
    shift = dataset.loc[dataset["run"] == "c", "displacement_mm"].to_numpy() - alone["displacement_mm"].to_numpy()
    assert shift == pytest.approx(tare_mm(runs[0]) - tare_mm(runs[1]))


def test_strokes_before_count():
    worked = string(strokes_before=20)
    assert make_dataset([recorded(samples=recording(2), string=worked)])["stroke"].min() == 21
    continued = [
        recorded("b", samples=recording(2), string=string(id="s")),
        recorded("c", samples=recording(2), string=string(id="s", strokes_before=10)),  # unrecorded strokes between
    ]
    assert sorted(set(make_dataset(continued)["stroke"])) == [1, 2, 11, 12]


def test_strings_are_numbered_on_their_own():
    dataset = make_dataset([recorded("b", samples=recording(2)), recorded("c", samples=recording(4))])
    assert dataset.groupby("string")["stroke"].max().to_dict() == {"b": 2, "c": 4}
    assert set(dataset.loc[dataset["string"] == "b", "later"]) == {""}


def test_order_of_runs():
    early, late = recording(1), recording(1)
    late["time_s"] += 1000.0
    b_late, c_early = recorded("b", samples=late), recorded("c", samples=early)
    names = [recorded_run.run.run for recorded_run in in_order([b_late, c_early])]
    assert names == ["c", "b"]
    same = [recorded("c", samples=early), recorded("b", samples=early)]
    assert [recorded_run.run.run for recorded_run in in_order(same)] == ["b", "c"]
    noted = [recorded("b", "2026-11-21T12:00:00Z", early), recorded("c", "2026-11-21T09:00:00Z", early)]
    assert [recorded_run.run.run for recorded_run in in_order(noted)] == ["c", "b"]


def test_order_of_runs_without_a_clock_goes_by_strokes_before_or_by_number():
    same = recording(1)
    counted_runs = [
        recorded(name, samples=same, string=string(strokes_before=n)) for name, n in (("a-late", 10), ("b-early", 0))
    ]
    assert [recorded_run.run.run for recorded_run in in_order(counted_runs)] == ["b-early", "a-late"]
    booted = same.assign(time_s=same["time_s"] + 5000.0)  # a logger whose clock began anew before the second run
    clocks = [recorded("b-late", samples=same, string=string(strokes_before=7))]
    clocks.append(recorded("a-early", samples=booted, string=string(strokes_before=0)))
    assert [recorded_run.run.run for recorded_run in in_order(clocks)] == ["a-early", "b-late"]
    numbered = [recorded(name, samples=same) for name in ("r-10", "r-2")]
    assert [recorded_run.run.run for recorded_run in in_order(numbered)] == ["r-2", "r-10"]


def test_the_last_rest_before_the_first_stroke_is_the_tare():
    recorded_run = recorded()
    rest = recorded_run.strokes.iloc[[0]]
    earlier = rest.assign(last_sample=20)
    later = rest.assign(first_sample=21)
    samples = recorded_run.samples.copy()
    samples.loc[:20, "displacement_mm"] += 2.0  # the zero moved before the last rest
    two = Recorded(
        recorded_run.run, "", samples, pd.concat([earlier, later, recorded_run.strokes.iloc[1:]], ignore_index=True)
    )
    assert tare_mm(two) == pytest.approx(tare_mm(recorded_run), abs=0.02)


def test_the_runs_own_tolerance_goes_with_its_points():
    dataset = make_dataset([recorded(samples=recording(2), tolerance={"radius": 0.07, "separator_mm": 0.2})])
    assert (dataset["radius_tolerance"] == 0.07).all() and (dataset["separator_tolerance_mm"] == 0.2).all()


def test_what_lies_before_the_first_stroke_stays_out():
    samples = recording(3)
    samples = samples[samples["time_s"] > 18.0].reset_index(drop=True)  # begins within the first unwinding
    dataset = make_dataset([recorded(samples=samples)])
    assert dataset["stroke"].min() == 1 and dataset["time_s"].min() > 30.0


def test_unwinding_blocks_count_from_the_top_too():
    unwinding = NINE[(NINE["phase"] == "unwinding") & (NINE["stroke"] == 1)]
    assert unwinding.loc[unwinding["motor_turns"].idxmax(), "block"] == 0


def test_held_out_points_are_capped_evenly():
    dataset = make_dataset([recorded(samples=recording(9, rate_hz=600.0))])
    assert (dataset["within"] == "test").sum() == HELD_OUT_POINTS == (dataset["later"] == "test").sum()
    point_counts = dataset[dataset["within"] == "test"].groupby(["stroke", "phase"]).size()
    assert len(point_counts) == 18 and point_counts.max() < 1.2 * point_counts.min()


def test_a_stiffness_that_nobody_measured_is_the_usual_one_of_its_size():
    unknown = {key: value for key, value in string().items() if key != "stiffness_n_per_mm"}
    usual = make_dataset([recorded(string=unknown)])["stiffness_n_per_mm"]
    assert usual.to_numpy() == pytest.approx(7000 * np.pi * 0.4**2 / 400)
