from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from made_life import folder, samples

from pipeline.ground.errors import BadInput
from pipeline.lifespan.forecast.life_questions import model_error, stroke_loss
from pipeline.lifespan.from_folders import strings
from pipeline.lifespan.stroke_health.health import INDICATORS, health
from pipeline.lifespan.stroke_health.stiffness import stiffness
from pipeline.lifespan.words.sentences import sentences
from pipeline.run.strokes import segment
from pipeline.string.from_raw import read


@pytest.fixture(scope="module")
def worn_string(tmp_path_factory):
    return strings([folder(tmp_path_factory.mktemp("raw"), "a-1", samples(20, 0.004))])[0]


def slope(table, name):
    return float(np.polyfit(table["stroke"], table[name], 1)[0])


def test_every_complete_stroke_is_there(worn_string):
    assert worn_string.strokes["stroke"].tolist() == list(range(1, 21)) and not worn_string.left_out
    assert worn_string.string == "a-1" and worn_string.runs == ["a-1"]
    for name in INDICATORS:
        assert (worn_string.strokes[f"{name}_error"].dropna() > 0).all()


def test_indicators_follow_what_was_made(worn_string):
    table = worn_string.strokes
    full_mm = table["stroke_mm"].iloc[0]
    assert slope(table, "stroke_mm") == pytest.approx(-0.004 * full_mm, rel=0.05)
    assert slope(table, "rest_mm") == pytest.approx(-0.05, rel=0.15)
    assert table["loop_mm"].mean() == pytest.approx(0.1, abs=0.02)
    assert table["model_error_mm"].iloc[:3].max() < 0.3 < 1.0 < table["model_error_mm"].iloc[-1]


def test_errors_are_as_large_as_the_scatter(worn_string):
    table = worn_string.strokes
    for name in ("stroke_mm", "rest_mm", "loop_mm"):
        line = np.polyval(np.polyfit(table["stroke"], table[name], 1), table["stroke"])
        assert 0.3 < np.std(table[name] - line) / table[f"{name}_error"].median() < 2.0, name


def test_stiffness_is_absent_where_the_load_stands(worn_string):
    assert worn_string.strokes["stiffness_n_per_mm"].isna().all()


def test_stiffness_is_the_load_s_slope(tmp_path):
    swung = strings([folder(tmp_path, "a-1", samples(6, 0.0, load_swing_n=6.0))])[0]
    assert swung.strokes["stiffness_n_per_mm"].to_numpy() == pytest.approx(20.0, rel=0.15)


def test_a_length_that_ignores_the_load_has_no_stiffness():
    generator = np.random.default_rng(0)
    table = pd.DataFrame({"motor_turns": np.linspace(0, 9, 80), "left_mm": generator.standard_normal(80)})
    table["load_n"], table["direction"] = 20.0 + 5.0 * generator.standard_normal(80), np.repeat([1.0, -1.0], 40)
    assert np.isnan(stiffness(table)["stiffness_n_per_mm"])


def test_runs_of_one_string_continue_each_other(tmp_path):
    table = samples(16, 0.004)
    string = {"material": "UHMWPE", "radius_mm": 0.4, "length_mm": 400, "stiffness_n_per_mm": 15, "id": "s"}
    half = len(table) // 2
    whole = strings([folder(tmp_path / "whole", "a-1", table)])[0].strokes
    parts = [
        folder(tmp_path, f"a-{number}", part.reset_index(drop=True), string=string)
        for number, part in ((2, table.iloc[half:]), (1, table.iloc[:half]))
    ]
    both = strings(parts)
    assert len(both) == 1 and both[0].runs == ["a-1", "a-2"]
    assert both[0].strokes["stroke"].tolist() == list(range(1, 17))
    for name in ("stroke_mm", "rest_mm"):
        assert np.abs(both[0].strokes[name] - whole[name]).max() < 0.06


def test_cutting_the_table_is_cutting_the_recording(tmp_path):
    """What scores early forecasts cuts the strokes' table: nothing of the later strokes may have reached it."""
    table = samples(20, 0.004)
    late = strings([folder(tmp_path / "whole", "a-1", table)])[0].strokes.iloc[:10]
    early = strings([folder(tmp_path / "half", "a-1", table.iloc[: 114 * 10 + 8])])[0].strokes
    for name in ("stroke_mm", "rest_mm", "loop_mm", "model_error_mm"):
        assert early[name].to_numpy() == pytest.approx(late[name].to_numpy(), abs=0.01), name


def test_strokes_of_another_range_are_left_out(tmp_path):
    table = samples(12, 0.0)
    short = table["motor_turns"].where(~table.index.isin(range(114 * 6, 114 * 7)), table["motor_turns"] * 0.8)
    string_health = strings([folder(tmp_path, "a-1", table.assign(motor_turns=short))])[0]
    assert string_health.left_out == [7] and len(string_health.strokes) == 11
    low, high = string_health.range_turns
    assert "\n  Left out: 1 stroke (7), not wound over" in sentences(string_health, [], 0.9)
    assert f"{low:.3g} to {high:.3g} turns within 5 %, the median of the first 3 strokes (1 to 3)." in sentences(
        string_health, [], 0.9
    )
    assert f", wound to {high:.3g} turns. Then name all runs" in sentences(string_health, [], 0.9)


def test_other_rigs_are_refused(tmp_path):
    recorded = read(folder(tmp_path, "a-1", samples(4, 0.0)))
    other = replace(recorded, run=recorded.run.model_copy(update={"actuator": "moving_mass"}))
    with pytest.raises(BadInput, match="no string"):
        health([other])


def shortened(table, stroke, share):
    """The recording with one stroke's top cut off by a share of its range."""
    segments = segment(table, "motor_turns", "made").set_index("stroke").loc[[stroke]]
    rows = slice(int(segments["first_sample"].min()), int(segments["last_sample"].max()))
    table.loc[rows, "motor_turns"] = table.loc[rows, "motor_turns"].clip(upper=20.0 * (1.0 - share))
    return table


@pytest.mark.parametrize("stroke", [2, 15])
def test_a_stroke_that_ends_a_little_short_does_not_silence_the_others(tmp_path, stroke):
    string_health = strings([folder(tmp_path, "a-1", shortened(samples(24, 0.004), stroke, 0.046))])[0]
    assert string_health.strokes["stroke_mm"].isna().sum() == 1 and not string_health.left_out
    for answer in (stroke_loss(string_health, 0.5), model_error(string_health, 50.0)):
        assert np.isfinite(answer.values).all() and answer.left.reason == "" and len(answer.left.when)


def test_strokes_of_no_common_range_are_refused(tmp_path):
    with pytest.raises(BadInput, match="same range"):
        strings([folder(tmp_path, "a-1", shortened(samples(2, 0.004), 2, 0.3))])


def test_the_strokes_that_there_are_are_counted_right(tmp_path):
    string_health = strings([folder(tmp_path, "a-1", samples(2, 0.004))])[0]
    assert "2 strokes are too few" in model_error(string_health, 1.0).left.reason
