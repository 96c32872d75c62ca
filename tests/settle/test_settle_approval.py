"""What a person reads before she approves a run: each leg in numbers, and what the run is expected to tell."""

import json
from dataclasses import replace
from types import SimpleNamespace

import pytest
from settle.test_settle_parts import RIG, entry

from pipeline.settle.approve import told
from pipeline.settle.choose import Budget, chosen, in_words, leg_json
from pipeline.settle.first import strokes
from pipeline.settle.limits import Allowed
from pipeline.settle.loop import Loop
from pipeline.settle.motion_table import lines, table, winds
from pipeline.settle.motor import Motor
from pipeline.settle.step import Place, Step
from pipeline.watch.settling import Settling


def proposed(**more) -> Step:
    step, why = chosen(
        [entry("one stroke at twice the speed under twice the load", load_n=40.0, **more)], 1, RIG, Budget(3, 9.0, 9)
    )
    assert step is not None, why
    return step


def test_before_a_person_says_yes_each_leg_is_said_in_numbers(tmp_path):
    text = told(proposed(), Place(tmp_path))
    assert "Before it the motor stands at 0.00 turns, under 20 N." in text
    assert "Before it the motor stands at 0.00 turns, under 20 N. Leg 1 is the rest before the run." in text
    assert "under twice the load (10 s, 1 stroke; before it leg 1, 2 s)" in text, "10 s stand in the verdict"
    rows = [line.split() for line in text.splitlines()]
    assert ["leg", "s", "turns", "turns/s", "load", "(N)"] in rows
    assert ["1", "2.0", "stands", "at", "0.00", "0", "20"] in rows
    assert ["2", "5.0", "0.00", "to", "20.00", "4.08", "40"] in rows, "with the ramps of the rig: faster than 20 / 5"
    assert ["3", "5.0", "20.00", "to", "0.00", "4.08", "40"] in rows
    assert (
        "By the library's formulas it puts the closest two explanations about 20 standard deviations apart; in t"
        in text
    )


def test_before_a_person_says_yes_the_tie_is_named_with_its_probabilities_and_the_file_of_the_verdict(
    tmp_path, monkeypatch, capsys
):
    """`about 55 standard deviations apart` of nobody knew what, and no word of where the verdict stands."""
    place = Place(tmp_path)
    pairs = [
        {"ids": [["backlash"], ["creep", "wear"]], "gap_now": 1.0, "gap_then": 900.0},
        {"ids": [["backlash"], ["friction_hysteresis"]], "gap_now": 4.0, "gap_then": 400.0},
    ]
    parts = [["backlash"], ["friction_hysteresis"], ["creep", "wear"]]
    step = replace(proposed(pairs=pairs, parts=parts), run_dir=str(tmp_path / "a-s1"))
    assert "verdict so far" not in told(step, place), "of a folder that is not there"
    explanations = [{"ids": ["friction_hysteresis"], "probability": 0.481}, {"ids": ["backlash"], "probability": 0.376}]
    explanations += [{"ids": ["wear", "creep"], "probability": None}]
    rest = {"verdict": "ambiguous", "mechanisms": [], "alternatives": []}
    written = json.dumps(rest | {"evidence": {"explanations": explanations}})
    for path, words in (("diagnosis.json", written), ("verdict.txt", "ambiguous")):
        place.folder(0).mkdir(exist_ok=True)
        (place.folder(0) / path).write_text(words)
    text = told(step, place)
    assert "what ties: backlash (38 %), friction_hysteresis (48 %), creep + wear." in text
    assert f"the verdict so far: {tmp_path / 'step-0' / 'verdict.txt'}" in text
    assert "it puts the closest two explanations, backlash and friction_hysteresis, about 20 standard" in text
    assert "apart; in tests 30 of 50 ties were settled rightly by such runs (docs/settle.md)." in text
    place.write(Step(0, "diagnosed", proposal={"runs": [str(tmp_path / "a")]}))
    place.write(step)
    monkeypatch.setattr(Motor, "takes", lambda self: RIG)
    monkeypatch.setattr("sys.stdin", SimpleNamespace(isatty=lambda: True))
    monkeypatch.setattr("builtins.input", lambda question: "no")
    Loop([tmp_path / "a"], place, Motor("port", 1, Allowed({}), False), "ask", Budget(3, 9.0, 9)).go()
    ending = capsys.readouterr().out.splitlines()[-1]
    assert "not approved" in ending and ending.endswith(f"the verdict so far: {tmp_path / 'step-0' / 'verdict.txt'}")


def test_the_table_begins_where_the_motor_stands_now():
    step, _ = chosen([entry("one")], 1, replace(RIG, at_turns=6.0), Budget(3, 9.0, 9))
    assert step is not None and table(step)[0].turns == "6.00 to 0.00"


def test_legs_that_repeat_are_said_together():
    legs = [leg_json(leg) for leg in strokes(RIG, 6, 0.5)]
    step = Step(0, "proposed", proposal={"title": "a first recording", "legs": legs, "from": 0.0, "load": None})
    rows = lines(step)
    assert len(legs) == 27 and len(rows) == 7
    numbers = [row.split("  ")[0] for row in rows[1:]]
    assert numbers == ["1, 2", "3, 7 … 23", "4, 8 … 24", "5, 9 … 25", "6, 10 … 26", "27"]
    assert winds(step) == 6 and all(row.endswith("as it hangs") for row in rows[1:])


def test_the_page_says_the_same(tmp_path):
    place = Place(tmp_path)
    place.write(Step(0, "diagnosed"))
    step = place.write(proposed())
    settling = Settling(tmp_path, tmp_path / "raw" / "a")
    moves = settling.told(settling.step())["moves"]
    assert ("2", "5.0", "0.00 to 20.00", "4.08", "40") in moves["legs"] and "40" in moves["legs"][2]
    assert "20 standard deviations" in moves["apart"] and moves["winds"] is None
    assert settling.told(step.at("approved"))["moves"]["winds"] == 1, "of the program: the rig's own motion has another"
    assert settling.told(step.at("diagnosed"))["moves"] is None
    assert settling.told(step.at("diagnosed"))["came"] is None
    (place.folder(0) / "came.png").write_bytes(b"")
    drawing = {"step": 0, "file": str(place.folder(0) / "came.png")}
    assert settling.told(step)["came"] == drawing, "of the step before, while the next one is proposed"
    step.legs[1]["seconds"] = 0.0
    assert settling.told(step)["moves"] is None, "a damaged file ends no page"


@pytest.mark.parametrize(
    ("deviations", "words"),
    [
        (0.44, "about 0.4 standard"),
        (9.97, "about 10 s"),
        (94.9, "about 95 standard"),
        (641.0, "more than 100 s"),
    ],
)
def test_a_gap_is_said_in_standard_deviations(deviations, words):
    assert in_words(deviations).startswith(words)
