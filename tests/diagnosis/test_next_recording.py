"""What a verdict says of the next recording: what it shows, of which rival, under which load, and when to adopt."""

import copy
import shlex

import pytest
from made_content import SYSTEMS, content, full, page

from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.words.foretold.expectation import lines
from pipeline.diagnosis.words.foretold.foretold_numbers import compared
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.next_run import recipe, second_load
from pipeline.diagnosis.words.pages.adoption import weighed_anew
from pipeline.run.samples import read_samples

WORDS = Vocabulary.of(SYSTEMS["mm"])
ALONE = {"verdict": "explained", "alternatives": [], "next_run": None, "evidence__loaded": False}
COVERED = {"load": [13.2, 13.2], "speed_per_s": [1.0, 2.0], "longest_hold_s": 3.0, "longest_rest_s": 6.0}


def foretold(half_mm: float, ids: list[str], **numbers: float) -> dict:
    """What an explanation foretells, each number with one half-width; a loop as before in the recording, too."""
    foretold_mm = {f"{key}_mm": value for key, value in numbers.items()}
    own = {"recorded": {"loop_mm": numbers["loop_as_before"]}} if "loop_as_before" in numbers else {}
    return {"ids": ids, **foretold_mm, **own, "plus_minus": dict.fromkeys(foretold_mm, half_mm)}


FRICTION = foretold(0.03, ["friction_hysteresis"], loop_as_before=0.09, loop_half_load=0.045, loop_twice_load=0.18)
PLAY = foretold(0.015, ["backlash"], loop_as_before=0.09, loop_half_load=0.09, loop_twice_load=0.09)
LAG = foretold(0.01, ["sensor_lag"], loop_as_before=0.04, loop_half_load=0.04, loop_twice_load=0.04)


def named(ids: list[str], explanations: list[dict], shares: dict[str, float], recorded: float = 0.09, **more) -> dict:
    """A verdict that names `ids`, with what is foretold and how likely each explanation is."""
    expected = {"load": 13.2, "speed_per_s": 2.0, "stand_s": 120.0, "explanations": explanations}
    expected["recorded"] = {"loop_mm": recorded}
    diagnosis = content(**ALONE | more, evidence__covered=COVERED, evidence__expected=expected)
    diagnosis["mechanisms"] = [entry for entry in diagnosis["mechanisms"] if entry["id"] in ids]
    for id_, share in shares.items():
        diagnosis["evidence"]["explanations"].append(
            {"ids": [id_], "standing": "named" if id_ in ids else "beaten", "left_mm": 0.03,
             "with_discrepancy_mm": 0.03, "probability": share, "worse": 9.0, "gap_mm": 0.1, "driver": None,
             "location": {"motor_turns": [0, 1], "strokes": [1, 2], "phase": "all", "share": 0.8}}
        )  # fmt: skip
    return diagnosis


def rubbing(**more) -> dict:
    shares = {"friction_hysteresis": 0.9, "backlash": 0.02, "sensor_lag": 0.001}
    return named(["friction_hysteresis"], [FRICTION, LAG, PLAY], shares, **more)


def test_the_rival_is_the_runner_up_and_no_rejected_one_stands_beside_it():
    assert [each["ids"] for each in compared(rubbing())] == [["friction_hysteresis"], ["backlash"]]
    table = lines(rubbing(), WORDS)
    assert "backlash (2 %)" in table[0] and not any("sensor_lag" in line for line in table[:1])
    alike = named(["friction_hysteresis"], [FRICTION, LAG, PLAY], {"backlash": 0.002, "sensor_lag": 0.004})
    assert [each["ids"][0] for each in compared(alike)][1:] == ["sensor_lag", "backlash"], "both unlikely: by share"


def test_the_same_holds_and_rests_are_asked_for_only_where_there_are_some():
    diagnosis = rubbing()
    assert "with the same holds and rests" in recipe.sentence(diagnosis, WORDS, ["friction_hysteresis"])
    diagnosis["evidence"]["covered"] = COVERED | {"longest_hold_s": 0.0, "longest_rest_s": 0.0}
    request = recipe.sentence(diagnosis, WORDS, ["friction_hysteresis"])
    assert request.startswith("So record:") and "holds" not in request


def test_a_rival_that_is_likelier_than_one_in_the_table_is_said_not_to_be_in_it():
    diagnosis = rubbing()
    assert not any("Not in the table" in line for line in lines(diagnosis, WORDS))
    like = diagnosis["evidence"]["explanations"][0]
    diagnosis["evidence"]["explanations"].append(like | {"ids": ["slack"], "probability": 0.14, "standing": "beaten"})
    assert any("Not in the table: slack (14 %), of which nobody" in line for line in lines(diagnosis, WORDS))


def test_the_load_that_parts_more_is_the_one_that_is_asked_for_and_the_command_carries_it():
    text = " ".join(full(rubbing()).split())
    assert "It has no second load: 26 N, twice, tells friction_hysteresis from backlash best" in text
    assert (
        "So record: 12 strokes as before, 0 to 30.7 turns, but under 26 N in place of 13 N, at 1 to 2 turns/s" in text
    )
    assert "--like raw/nylon-3 --load-n 26" in text
    near = foretold(0.2, ["friction_hysteresis"], loop_as_before=0.09, loop_half_load=0.045, loop_twice_load=0.18)
    neither = named(["friction_hysteresis"], [near, PLAY], {"backlash": 0.02})
    assert second_load.best(neither, WORDS)[1] < 1.0
    details = " ".join(full(neither).split())
    assert "neither 26 N nor 6.6 N tells friction_hysteresis from backlash here by more than the plus-minus" in details


def test_a_load_that_a_column_holds_is_not_typed():
    diagnosis = rubbing()
    diagnosis["evidence"]["covered"] = COVERED | {"load": [13.1, 13.3]}
    assert recipe.load(diagnosis, WORDS, ["friction_hysteresis"]) is not None
    assert recipe.to_type(diagnosis, WORDS, ["friction_hysteresis"]) == "" and "--load-n 2" not in page(diagnosis)


def test_one_speed_asks_for_a_second_one():
    diagnosis = rubbing()
    diagnosis["evidence"]["covered"] = COVERED | {"speed_per_s": [2.0, 2.0]}
    assert "at 2 turns/s, then as many at 1 turn/s" in recipe.sentence(diagnosis, WORDS, ["friction_hysteresis"])


CREEP = foretold(1.0, ["creep"], loop_as_before=0.18, hold=-0.35, rest=0.25)
LASTING = foretold(0.05, ["plastic_elongation"], loop_as_before=0.0, hold=0.0, rest=0.0)


def test_a_name_beyond_doubt_asks_for_no_further_run():
    diagnosis = named(["creep"], [CREEP, LASTING], {"creep": 0.98}, recorded=0.5)
    for share, asks in ((0.98, True), (0.995, False)):
        diagnosis["mechanisms"][0]["confidence"] = share
        assert ("to be surer of a name" in " ".join(full(copy.deepcopy(diagnosis)).split())) == asks


def test_a_run_that_tells_nothing_is_asked_for_no_more_where_each_name_is_sure():
    creep = foretold(0.2, ["creep"], loop_as_before=0.18, hold=-0.35, rest=0.26)
    alike = {**creep, "ids": ["plastic_elongation"]}
    two_loads = {"loaded": True, "covered": COVERED | {"load": [13.2, 26.4]}}
    for share, rival, asks in ((0.9, alike, False), (0.7, alike, True), (0.9, LASTING, True)):
        diagnosis = named(["creep"], [creep, rival], {"creep": share}, recorded=0.18)
        diagnosis["mechanisms"][0]["confidence"] = share
        diagnosis["evidence"] |= two_loads
        assert ("to be surer of a name" in " ".join(full(diagnosis).split())) == asks, share


def test_where_a_hold_has_no_telling_number_the_page_says_in_words_what_it_shows_and_why():
    text = " ".join(full(named(["creep"], [CREEP, LASTING], {"creep": 0.8}, recorded=0.5)).split())
    assert (
        "if it is plastic_elongation, the reading changes by less than 0.050 mm in a hold of 2 min and in a rest of 2 "
        "min. By how much it changes if it is creep cannot be said: this recording was too short for it (it has holds "
        "of up to 3 s and rests"
    ) in text
    creep_foretold = foretold(0.2, ["creep"], loop_as_before=0.18, hold=-0.35, rest=0.26)
    near = {**LASTING, "plus_minus": {key: 0.2 for key in LASTING["plus_minus"]}}
    text = " ".join(full(named(["creep"], [creep_foretold, near], {"creep": 0.8}, recorded=0.5)).split())
    assert "In words" not in text, "0.35 less 0.2 is no more than 0.2"
    assert "in the first one hold 2 min at 30.7 turns and rest 2 min at 0 turns after it" in text
    assert recipe.shows(named(["creep"], [creep_foretold, near], {}, recorded=0.5), WORDS, ["creep"]) == {
        "loop_as_before", "hold", "rest",
    }, "a hold of the first stroke moves the tops of later ones"  # fmt: skip
    firm = foretold(0.05, ["creep"], loop_as_before=0.18, hold=-0.35, rest=0.25)
    assert not any("In words" in line for line in lines(named(["creep"], [firm, LASTING], {}, recorded=0.5), WORDS))


def test_a_loop_that_was_recorded_is_evidence_and_no_row_of_what_is_to_come():
    firm = foretold(0.05, ["creep"], loop_as_before=0.18, loop_half_speed=0.18, hold=-0.35, rest=0.25)
    table = lines(named(["creep"], [firm, LASTING], {"creep": 0.8}, recorded=0.2), WORDS)
    text = " ".join(table)
    assert "the loop of a stroke as before" not in text and "plastic_elongation" not in table[0]
    assert "This recording itself shows a loop of 0.20 mm. creep makes it (0.18 ± 0.05 mm)" in text
    assert "plastic_elongation alone (0.00 ± 0.05 mm) does not, so the loop excludes that already." in text
    other = " ".join(lines(named(["creep"], [firm, LASTING], {"creep": 0.8}, recorded=0.03), WORDS))
    assert "excludes" not in other, "the best one does not make it either"


@pytest.mark.long
def test_the_loop_of_a_recording_is_that_of_its_effect(conceal):
    run, samples = read_samples(conceal("backlash", kappa=3.0, rich=False)[0])
    expected = diagnosed([RecordedRun.cut(run, samples)])[0]["evidence"]["expected"]
    best, shown = expected["explanations"][0], expected["recorded"]["loop_mm"]
    assert shown == pytest.approx(best["recorded"]["loop_mm"], abs=best["plus_minus"]["loop_as_before_mm"])
    assert shown == pytest.approx(best["loop_as_before_mm"], abs=2.0 * best["plus_minus"]["loop_as_before_mm"])
    assert best["ids"] == ["backlash"]
    loops = {
        tuple(each["ids"]): [each[f"loop_{load}_load_mm"] for load in ("half", "twice")]
        for each in expected["explanations"]
    }
    half, twice = loops["backlash",]
    assert half == pytest.approx(twice, rel=0.05), "play has the width that it has"
    half, twice = loops["friction_hysteresis",]
    assert half < 0.6 * shown < 1.6 * shown < twice, "friction grows with the load"


def test_what_was_adopted_is_taken_out_of_each_run_before_its_name_is_weighed_again():
    adopted = {"effects": ["friction_hysteresis"], "verdict": "explained", "tied": [], "runs": ["nylon-3"]}
    diagnosis = rubbing(verdict="consistent", mismatch=None, adopted=[adopted], evidence__moved_sigma={})
    diagnosis["mechanisms"], diagnosis["simulation"] = [], [{"id": "friction_hysteresis", "parameters": {}}]
    text = full(diagnosis)
    removed = [line.strip() for line in text.splitlines() if "adopt --remove" in line]
    assert [shlex.split(line)[-1] for line in removed] == ["raw/nylon-3", "raw/nylon-3-next"]
    assert text.index("new_run nylon-3-next") < text.index("adopt --remove") < text.index("--together")
    assert "If you have adopted it already, first take it out of each run" in " ".join(
        full(rubbing()).split()
    ) and "not weighed again" in weighed_anew(WORDS)


def test_of_an_adopted_slow_effect_a_second_load_is_asked_for_where_no_hold_can_be_foretold():
    diagnosis = rubbing()
    assert recipe.load(diagnosis, WORDS, ["creep"]) is None, "a hold and a rest tell more"
    assert "hold 2 min" in recipe.sentence(diagnosis, WORDS, ["creep"])
    del diagnosis["evidence"]["expected"]
    assert recipe.load(diagnosis, WORDS, ["creep"]) == 6.6
    assert "under 6.6 N" in recipe.sentence(diagnosis, WORDS, ["creep"])


def test_a_test_that_the_recording_holds_already_is_not_asked_for():
    diagnosis = rubbing()
    diagnosis["evidence"] |= {"loaded": True, "covered": COVERED | {"load": [13.2, 26.4]}}
    text = page(diagnosis)
    assert "to be surer of a name" not in text and "record again" not in text and "this recording has" not in text
    assert "Optional, to be surer of a name" in page(rubbing()) and "this recording has it" not in page(rubbing())
