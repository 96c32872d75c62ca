"""What each explanation foretells of strokes that nobody made: its numbers follow the physics, the page says them."""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest
from made_content import SYSTEMS, confident, content, full, page, spoken, told

from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.proposal import expected
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.words.foretold.corner_table import corners
from pipeline.diagnosis.words.foretold.expectation import lines
from pipeline.diagnosis.words.foretold.prediction import stretches
from pipeline.diagnosis.words.language.quantity import plus_minus
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named.missing_signs import missing
from pipeline.diagnosis.words.next_run.after_adopting import of_adopted
from pipeline.diagnosis.words.pages.adoption import adopted_predictions
from pipeline.diagnosis.words.pages.details import details_text
from pipeline.run.samples import read_strokes

WORDS = Vocabulary.of(SYSTEMS["mm"])
BOTH = ["friction_hysteresis", "creep"]
CREEP = {"ids": BOTH, "loop_as_before_mm": 0.2, "loop_half_speed_mm": 0.1, "hold_mm": -0.28, "rest_mm": 0.1}
HEAT = {"ids": [BOTH[0], "thermal"], "loop_as_before_mm": 0.2, "loop_half_speed_mm": 0.2, "hold_mm": 0.001}
EXPECTED = {"load": 20.0, "speed_per_s": 2.0, "stand_s": 120.0, "explanations": [CREEP, HEAT]}
COVERED = {"load": [19.9, 20.1], "speed_per_s": [1.9, 2.1], "longest_hold_s": 3.0, "longest_rest_s": 60.0}


def details(diagnosis: dict) -> str:
    """The details with their commands, on one line."""
    diagnosis = spoken(diagnosis, SYSTEMS["mm"])
    return " ".join(details_text(diagnosis, SYSTEMS["mm"], [Path("raw/nylon-3")], Path("reports/nylon-3")).split())


def foretold(conceal, kind: str, rich: bool = True) -> list[dict]:
    """What each explanation of a recording with one effect foretells, the best one first."""
    diagnosis, _ = diagnosed([RecordedRun(*read_strokes(conceal(kind, kappa=3.0, rich=rich)[0]))])
    assert [entry["id"] for entry in diagnosis["mechanisms"]] == [kind]
    explanations = diagnosis["evidence"]["expected"]["explanations"]
    assert explanations[0]["ids"] == [kind] and len(explanations) > 1
    for other in (other for other in explanations[1:] if kind not in other["ids"]):  # a larger set copies the best one
        seen = [
            abs(other[key] - explanations[0][key])
            for key in other.keys() & explanations[0].keys()
            if key.endswith("_mm")
        ]
        assert max(seen) >= 2.0 * diagnosis["evidence"]["floor_mm"], "a number parts them"
    floor = diagnosis["evidence"]["floor_mm"]
    for each in (each for each in explanations if each is explanations[0] or kind not in each["ids"]):
        assert each["plus_minus"].keys() == {key for key in each if key.endswith("_mm")}, "each number has its own"
        assert all(half >= 1.6 * floor for half in each["plus_minus"].values()), "the noise at least"
    assert explanations[0]["plus_minus"]["loop_as_before_mm"] < 20.0 * floor
    return explanations


@pytest.mark.long
def test_a_loop_of_friction_does_not_follow_the_speed_as_those_of_its_look_alikes_do(conceal):
    best, *others = foretold(conceal, "friction_hysteresis")
    assert best["loop_half_speed_mm"] == pytest.approx(best["loop_as_before_mm"], rel=0.1)
    assert any("viscous_loss" in other["ids"] or "sensor_lag" in other["ids"] for other in others), "its look-alikes"
    assert "loop_half_load_mm" not in best, "two loads were recorded"


@pytest.mark.long
def test_creep_has_a_hold_and_a_rest_and_a_drift_beside_it_has_no_loop(conceal):
    best, *others = foretold(conceal, "creep")
    assert {"hold_mm", "rest_mm", "top_mm", "loop_as_before_mm"} <= best.keys()
    assert best["loop_as_before_mm"] < 0.1
    lasting = next(other for other in others if other["ids"] == ["plastic_elongation"])
    assert abs(lasting["hold_mm"]) < 1e-3 and abs(lasting["rest_mm"]) < 1e-3, "it stands still in a pause"


@pytest.mark.long
def test_no_loop_of_a_slow_effect_is_foretold_under_a_load_that_was_not_recorded(conceal):
    best, *_ = foretold(conceal, "creep", rich=False)
    assert "loop_half_speed_mm" in best and "loop_half_load_mm" not in best


@pytest.mark.long
def test_a_play_does_not_follow_the_speed_and_a_loss_of_speed_does(conceal):
    play, loss = foretold(conceal, "backlash")[0], foretold(conceal, "viscous_loss")[0]
    assert play["loop_half_speed_mm"] == pytest.approx(play["loop_as_before_mm"], rel=0.05)
    assert loss["loop_half_speed_mm"] < 0.8 * loss["loop_as_before_mm"]


@pytest.mark.long
def test_wear_goes_on_at_the_highest_twist_and_has_no_loop(conceal):
    best, *_ = foretold(conceal, "wear")
    assert abs(best["top_mm"]) > 0.02 and best["loop_as_before_mm"] < 0.5 * abs(best["top_mm"])


def test_the_table_has_a_column_for_each_explanation_and_no_row_that_nobody_would_see():
    diagnosis = content(evidence__expected=EXPECTED)
    rows = [re.split(r" {3,}", line) for line in lines(diagnosis, WORDS)]
    assert rows[0] == ["What to expect of", "with creep", "with thermal"], "without what both have"
    assert rows[1:4] == [
        ["change in a hold of 2 min at 30.7 turns under 20 N", "-0.28 mm", "hardly"],
        ["the loop at 1 turn/s, half the usual speed of 2 turns/s", "0.10 mm", "0.20 mm"],
        ["change in a rest of 2 min at 0 turns after it", "+0.10 mm", "–"],
    ], "what tells most comes first, what only one foretells last"
    assert "Differences of less than 0.033 mm tell nothing" in rows[-2][0] and len(rows) == 7
    assert rows[4][0].startswith("Both have friction_hysteresis as well. The loop is by how much winding and unwinding")
    assert rows[-1][0].endswith("by less than their ±: the loop of a stroke as before under 20 N.")
    assert "–: this explanation foretells no such number." in rows[4][0], "how to read the table, in one go"
    small = EXPECTED | {"explanations": [{"ids": BOTH, "loop_as_before_mm": 0.05}]}
    assert lines(content(evidence__expected=small), WORDS) == [] == lines(content(), WORDS)


def with_spread(explanation: dict, half_mm: float) -> dict:
    """An explanation with one half-width of all of its numbers."""
    return explanation | {"plus_minus": {key: half_mm for key in explanation if key.endswith("_mm")}}


def test_each_number_has_its_plus_minus_and_rows_within_it_are_left_out():
    both = [with_spread(CREEP, 0.02), with_spread(HEAT, 0.061)]
    table = lines(content(evidence__expected=EXPECTED | {"explanations": both}), WORDS)
    rows = [re.split(r" {3,}", line) for line in table]
    assert rows[1] == ["change in a hold of 2 min at 30.7 turns under 20 N", "-0.28 ± 0.02 mm", "0.00 ± 0.06 mm"]
    assert rows[2] == ["the loop at 1 turn/s, half the usual speed of 2 turns/s", "0.10 ± 0.02 mm", "0.20 ± 0.06 mm"]
    assert not any(row[0].startswith("the loop of a stroke as before") for row in rows)
    assert "less than their ±: the loop of a stroke as before under 20 N." in table[-1]
    text = " ".join(table)
    assert "±: in tests nine of ten loops and eight of ten changes in holds, rests and more strokes lay inside" in text
    assert "Differences of less than" not in text


def test_a_row_that_only_a_column_beyond_the_page_tells_is_no_row_that_tells():
    wide = {"ids": ["plastic_elongation", "radius_compaction"], "loop_as_before_mm": 0.9, "hold_mm": 0.1}
    three = [with_spread(each, 0.02) for each in (CREEP, HEAT, wide)]
    table = lines(content(evidence__expected=EXPECTED | {"explanations": three}), WORDS)
    assert "radius_compaction" not in table[0] and "thermal" in table[0]
    assert not any(line.startswith("the loop of a stroke as before") for line in table)


def test_of_columns_that_do_not_all_fit_those_stand_that_a_row_tells_apart():
    longest = [with_spread(CREEP | {"ids": [*BOTH, id_]}, 0.02) for id_ in ("radius_compaction", "plastic_elongation")]
    three = [longest[0], longest[1], with_spread(HEAT, 0.02)]
    table = lines(content(evidence__expected=EXPECTED | {"explanations": three}), WORDS)
    assert "thermal" in table[0] and "plastic_elongation" not in table[0], "it foretells the same as the best"


def test_where_the_one_explanation_stands_alone_the_page_says_which_loop_speaks_against_it():
    both = [with_spread(CREEP, 0.3), with_spread(HEAT, 0.3)]
    text = " ".join(
        lines(
            content(verdict="explained", alternatives=[], evidence__expected=EXPECTED | {"explanations": both}), WORDS
        )
    )
    assert "tells the explanations apart" not in text
    assert "Speaks against the name: the loop" in text and ", outside " in text


def test_where_no_number_tells_the_explanations_apart_no_table_stands_and_one_sentence_says_so():
    """A table "What to expect of" stood there, and below it that no number of it tells them apart."""
    both = [with_spread(CREEP, 0.3), with_spread(HEAT, 0.3)]
    expectation = EXPECTED | {"explanations": both}
    whole = "A single number does not decide. Only the fit of the whole run together with this one does."
    assert lines(content(evidence__expected=expectation), WORDS) == [whole], "a run that can decide is advised"
    table = lines(content(evidence__expected=expectation, next_run=None), WORDS)
    assert len(table) == 2 and table[0].startswith("No number of one stroke, hold or rest tells the explanations apart")
    assert table[-1] == "A hold and a rest of 2 min do not tell creep from thermal here.", "said plainly"
    alone = content(evidence__expected=expectation, next_run=None, evidence__loaded=False)
    assert lines(alone, WORDS)[-1] == "A hold and a rest of 2 min do not tell creep from thermal under one load."
    more = with_spread(CREEP | {"ids": [*BOTH, "sensor_drift"]}, 0.3)
    table = lines(content(evidence__expected=EXPECTED | {"explanations": [both[0], more]}, next_run=None), WORDS)
    best = "friction_hysteresis + creep"
    assert table[-1].endswith(f"do not tell {best} from {best} + sensor_drift here."), "one is part of the other"


@pytest.mark.parametrize(
    ("value", "half", "expected_words"),
    [
        (0.42, 0.061, "0.42 ± 0.06 mm"), (0.4211, 0.0123, "0.421 ± 0.012 mm"), (0.4, 0.096, "0.40 ± 0.10 mm"),
        (2.5, 32.5, "2 ± 32 mm"), (0.0002, 0.0004, "0.2 ± 0.4 µm"),
    ],
)  # fmt: skip
def test_a_number_is_said_to_the_digits_that_its_interval_leaves(value, half, expected_words):
    assert plus_minus(value, half, "mm") == expected_words


def test_what_lacks_a_part_of_the_best_explanation_comes_before_what_adds_to_it():
    more = CREEP | {"ids": [*BOTH, "sensor_drift"], "loop_as_before_mm": 0.3}
    diagnosis = content(evidence__expected=EXPECTED | {"explanations": [CREEP, more, HEAT]})
    table = " ".join(lines(diagnosis, WORDS))
    assert "(1) with creep; (2) with thermal; (3) with creep + sensor_drift." in table


def test_the_load_that_a_run_asks_for_is_another_one_than_before():
    legs = [{"seconds": 2.0, "motor_turns": 0.0, "load_n": 20.0}, {"seconds": 0.5, "motor_turns": 0.0, "load_n": 20.0}]
    for load in (20.0, 10.0):
        legs += [{"seconds": 15.0, "motor_turns": turns, "load_n": load} for turns in (30.0, 0.0)]
    run = {"title": "one stroke; one stroke under half the load", "legs": legs, "load": 20.0, "fixed_load": True}
    assert "another load (10 N)" in page(content(**{f"next_run__{key}": value for key, value in run.items()}))


def test_every_other_load_of_a_run_is_said_also_where_they_change_within_it():
    legs = [{"seconds": 15.0, "motor_turns": 30.0, "load_n": load} for load in (20.0, 40.0, 10.0, 40.0)]
    title = "one stroke under twice the load; one stroke under half the load"
    run = {"title": title, "legs": legs, "load": 20.0, "fixed_load": False}
    text = " ".join(page(content(**{f"next_run__{key}": value for key, value in run.items()})).split())
    assert "other loads (40 N and 10 N)" in text


def test_more_strokes_have_a_row_where_an_effect_is_slow():
    explanation = {"ids": BOTH, "top_mm": 0.11}
    diagnosis = content(evidence__expected=EXPECTED | {"strokes": 10, "explanations": [explanation]})
    assert "change at 30.7 turns, from the next stroke to the 10th   +0.11 mm" in lines(diagnosis, WORDS)


def test_the_page_of_one_explanation_has_the_table_and_the_details_of_a_tie_have_it():
    alone = {"verdict": "explained", "alternatives": [], "next_run": None}
    text = full(content(**alone, evidence__expected=EXPECTED))
    assert "What to expect of" in text and "new_run nylon-3-next --like raw/nylon-3" in text
    assert "What to expect of" not in full(content(**alone)) and "What to expect of" not in full()
    assert "What to expect of" in told(content(evidence__expected=EXPECTED))


def test_the_page_of_a_tie_says_by_how_much_the_readings_part_in_the_run():
    diagnosis = content(next_run__apart={"by_mm": 0.31, "motor_turns": 12.3, "first_mm": 31.42, "second_mm": 31.73})
    text = " ".join(full(diagnosis).split())
    both = "friction_hysteresis + creep 31.42 mm friction_hysteresis + thermal 31.73 mm"
    assert f"it is to tell apart reading in it, twist near 12 turns {both}" in text
    assert "their difference, if the run follows this one at once 0.31 mm" in text
    assert "their difference" not in full(), "an older file"


def test_a_run_asks_for_another_speed_only_if_it_leaves_those_that_were_recorded():
    changes = {"next_run__title": "one stroke at twice the speed", "evidence__covered": COVERED}
    assert "another speed" not in page(content(**changes)), "its legs move at 1.9 turns/s"
    slow = COVERED | {"speed_per_s": [1.0, 1.1]}
    assert "another speed" in page(content(**changes | {"evidence__covered": slow}))


def test_a_plan_of_corners_is_answered_in_a_table():
    time_s = np.arange(0.0, 10.01, 0.5)
    turns = np.interp(time_s, [0.0, 4.0, 6.0, 10.0], [0.0, 8.0, 8.0, 0.0])
    table = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "x_mm": 2.0 * turns, "low_mm": 2.0 * turns - 0.1})
    table["high_mm"] = np.where(time_s > 6.0, np.nan, 2.0 * turns + 0.1)
    lines_of_it = corners(table, "motor_turns", "x_mm")
    cells = [re.split(r" {3,}", line) for line in lines_of_it[1:]]
    assert [row[0] for row in cells] == ["0", "4", "6", "10"]
    assert cells[1] == ["4", "8", "16.00", "15.90 to 16.10"] and cells[3][-1] == "no band"


def test_of_a_plan_with_many_corners_it_is_said_that_the_file_has_them():
    time_s = np.arange(0.0, 40.01, 0.5)
    table = pd.DataFrame({"time_s": time_s, "motor_turns": 8.0 * (time_s.round() % 2), "x_mm": 1.0})
    (sentence,) = corners(table, "motor_turns", "x_mm")
    assert re.fullmatch(r"the plan turns or stops \d+ times, too often for a table: the file has each row", sentence)


def test_the_table_of_corners_has_the_reading_without_effects_and_marks_what_is_outside():
    time_s = np.arange(0.0, 42.01, 0.5)
    turns = np.interp(time_s, [0.0, 10.0, 20.0, 42.0], [0.0, 112.5, 112.5, 0.0])
    table = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": -1.0 - turns * np.e})
    table["without_effects_mm"] = 0.9 * table["displacement_mm"]
    out = ((time_s >= 14.0) & (time_s < 20.0)) | (time_s > 20.0)
    table["outside"] = out.astype(float)
    for name, way in (("low_mm", -0.123456), ("high_mm", 0.123456)):
        table[name] = np.where(out, np.nan, table["displacement_mm"] + way)
    *lines_of_it, when = corners(table, "motor_turns", "displacement_mm")
    head, *cells = [re.split(r" {3,}", line) for line in lines_of_it]
    assert head[3:] == ["without_effects_mm", "nine of ten readings", "the way there"]
    assert [row[-1] for row in cells[1:]] == ["inside", "63 % outside", "outside"]
    bare = 0.9 * (-1.0 - 112.5 * np.e)
    assert cells[1][3] == f"{bare:.2f}" and cells[1][4].count(".") == 2, "a band of ±0.12 mm has two decimals"
    assert cells[3][3] == "-0.90" and cells[3][-2] == "outside", "no band, and the decimals of its column"
    out[20] = True  # the corner itself, since the next leg is outside
    *_, leaving, _, _, _ = corners(table.assign(outside=out, low_mm=np.nan), "motor_turns", "displacement_mm")
    assert re.split(r" {3,}", leaving)[-2:] == ["outside from here on", "inside"]
    assert when == "the plan first leaves what was recorded at 14 s"
    assert max(map(len, lines_of_it)) <= 100
    inside = corners(table.assign(outside=0.0), "motor_turns", "displacement_mm")
    assert len(inside) == 5 and "first leaves" not in inside[-1]


def test_the_page_says_where_a_plan_has_a_band_and_which_string_a_plan_is_of():
    text = " ".join(full(content(evidence__covered=COVERED, evidence__loaded=False)).split())
    range_words = "0 to 30.7 turns, 1.52 to 2.1 turns/s, 20 N, holds of up to 6 s, rests of up to 2 min"
    wider = "(speeds, holds and rests reach further than recorded)."
    band = f"A plan has an error band within {range_words} and reversals near"
    assert f"{band} recorded ones {wider}" in text, "an older file"
    assert "Where its load falls" not in text
    two_loads = " ".join(full(content(evidence__covered=COVERED, evidence__loaded=True)).split())
    assert f"{wider} Where its load falls it has one only as far as a recorded load fell." in two_loads
    turned = {"turned": {"top": [[14.9, 15.1], [30.0, 30.7]], "bottom": [[0.0, 0.0]]}}
    text = " ".join(full(content(evidence__covered=COVERED | turned)).split())
    assert f"{band} 14.9 to 15.1 turns and 30 to 30.7 turns at the top and 0 turns at the bottom {wider}" in text
    assert (
        "creep goes on from the recording's end; without --after-recording a plan begins as the recording did." in text
    )
    assert "--motion PLAN.csv --after-recording --out FILE.csv" in text, "the command can be pasted as it stands"
    passing = full(content(mechanisms=content()["mechanisms"][:1]))
    assert "--after-recording" not in passing and "--motion PLAN.csv --out FILE.csv" in passing


def test_adopting_what_stays_in_the_string_says_how_to_predict_the_string_as_it_is():
    _, _, used, before = adopted_predictions("raw/a", WORDS, "load_n", ["wear"])
    assert "--motion PLAN.csv --after-recording --out FILE.csv" in used and "--after-recording" not in before
    assert not any("--after" in line for line in adopted_predictions("raw/a", WORDS, "load_n", ["backlash"]))


def test_a_slow_effect_is_sure_only_with_a_second_load():
    table = {loaded: full(confident(0.95, 0.9, evidence__loaded=loaded)) for loaded in (True, False)}
    assert re.search(r"creep +sure, 90 %", table[True]) and re.search(r"creep +probable, 90 %", table[False])
    alone = " ".join(table[False].split())
    assert "That something slow acts is sure; its name is not sure." in alone
    assert "creep has 90 %, but is only probable: a second load was not recorded." in alone


def test_an_effect_is_sure_only_if_what_tells_it_from_others_was_recorded():
    alone = {"evidence__loaded": False, "evidence__covered": COVERED}
    assert missing(content(**alone), WORDS, "friction_hysteresis") == ["load", "speed"]
    assert missing(content(**alone), WORDS, "backlash") == ["load"]
    assert missing(content(**alone), WORDS, "viscous_loss") == ["speed"]
    assert missing(content(**alone), WORDS, "jam") == [] == missing(content(), WORDS, "viscous_loss")
    two = {"evidence__loaded": True, "evidence__covered": COVERED | {"speed_per_s": [1.0, 2.0]}}
    assert missing(content(**two), WORDS, "friction_hysteresis") == []
    text = " ".join(full(confident(0.95, 0.46, **alone)).split())
    why = "a second load and a second speed were not recorded"
    assert f"friction_hysteresis has 95 %, but is only probable: {why}." in text


def test_after_adopting_the_page_says_which_sign_of_a_name_is_still_open():
    diagnosis = content(evidence__loaded=True, evidence__covered=COVERED)
    ((head, line, *_),) = of_adopted(diagnosis, WORDS, ["viscous_loss", "jam"], [Path("raw/nylon-3")], short=False)
    assert "no second speed." in head and line == "- viscous_loss: three speeds and small strokes at low twist."
    assert of_adopted(diagnosis, WORDS, ["jam", "gone"], [Path("raw/nylon-3")], short=False) == []


@pytest.mark.parametrize(
    ("trend", "grows", "lowers"), [(0.2, "grows", "raises"), (-0.2, "falls", "lowers"), (None, "changes", "moves")]
)
def test_wear_says_which_way_it_moves_the_radius_and_the_reading(trend, grows, lowers):
    entry = {"id": "wear", "rms_mm": {"value": 0.1, "low": 0.09, "high": 0.11}, "parameters": {}}
    changes = {"mechanisms": [entry], "evidence__spans_mm": {"wear": 0.3}, "evidence__tops_mm": {"wear": 0.2}}
    changes |= {"evidence__trends_mm": {"wear": trend}} if trend else {}
    text = " ".join(full(content(**changes)).split())
    assert f"radius {grows} with the distance travelled, which {lowers} the displacement by up to 0.30 mm" in text
    assert "0.20 mm more in the last stroke that goes there under the same load than in the first; no dimension" in text


def test_the_page_says_which_dimension_took_most_of_the_nominal_error_away():
    changes = {"evidence__nominal_mm": 1.1, "evidence__calibrated_mm": 0.2, "evidence__moved_sigma": {"radius_mm": 1.2}}
    text = details(content(**changes))
    most = "Moving dimensions alone takes most of the nominal error away (how far each moved: Dimensions)."
    assert most in text and "radius 0.55 mm 0.5612 mm (0.56 to 0.563) – 1.2 " in text
    assert "Only a dimension that moves by more than 2.5 tolerances is to be measured again." in text
    assert most not in details(content(**changes | {"evidence__calibrated_mm": 0.9}))


def test_when_a_plan_leaves_what_was_recorded_is_said_in_seconds():
    rows = np.array([0, 1, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0], bool)
    assert stretches(rows[:4], np.arange(4.0)) == "from 1 to 2 s"
    assert stretches(rows, np.arange(12.0)) == "from 1 to 2 s, at 4 s, at 6 s and 2 stretches more"
    assert stretches(rows[:9], np.arange(9.0)) == "from 1 to 2 s, at 4 s, at 6 s and 1 stretch more"
    assert stretches(np.array([1, 0, 1, 1], bool), np.arange(4.0)) == "at 0 s and 2 to 3 s"
    assert stretches(np.zeros(3, bool), np.arange(3.0)) == ""


def test_columns_whose_heads_do_not_fit_on_the_page_have_numbers():
    """The third of three likely explanations was left out of the table, and nothing said so."""
    wide = {"ids": ["plastic_elongation", "radius_compaction"], "loop_as_before_mm": 0.1, "hold_mm": 0.1}
    diagnosis = content(evidence__expected=EXPECTED | {"explanations": [CREEP, HEAT, wide]})
    table = lines(diagnosis, WORDS)
    assert table[0].split()[-3:] == ["(1)", "(2)", "(3)"] and max(map(len, table[:2])) <= 105
    assert "(3) plastic_elongation + radius_compaction" in " ".join(table)


def test_a_likely_explanation_without_numbers_is_named_below_the_table():
    diagnosis = content(evidence__expected=EXPECTED | {"explanations": [CREEP, HEAT]})
    assert "not in the table" not in " ".join(lines(diagnosis, WORDS))
    diagnosis["alternatives"] = [HEAT["ids"], ["wear"], ["jam", "slack"]]
    sentence = "Likely too, but not in the table: wear and jam + slack. Only 2 explanations are foretold."
    assert sentence in lines(diagnosis, WORDS)


@pytest.mark.parametrize(
    ("id_", "stand_s", "is_foretold"),
    [("sensor_drift", 160.0, False), ("sensor_drift", 140.0, True), ("creep", 160.0, True)],
)
def test_no_drift_is_foretold_for_longer_than_it_was_recorded(id_, stand_s, is_foretold):
    record, drivers = SimpleNamespace(time_s=np.linspace(0.0, 300.0, 50)), SimpleNamespace(loaded=False)
    study = SimpleNamespace(problem=SimpleNamespace(record=record, drivers=drivers))
    state = SimpleNamespace(acts=(Act(id_, ({},), (1.0,)),))
    which = expected._which(study, SimpleNamespace(load=10.0), {"stand_s": stand_s}, state)
    assert ("hold" in which, "rest" in which) == (is_foretold, is_foretold)
