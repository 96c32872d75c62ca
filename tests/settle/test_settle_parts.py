"""Parts of the loop, each by itself: limits, budget, choice, approval, sheet and figure."""

import sys
from pathlib import Path

import numpy as np
import pytest
from made_recording import recording

from pipeline.capture.motion_program import as_legs
from pipeline.ground.errors import BadInput
from pipeline.run.folder import read_run
from pipeline.settle import loop
from pipeline.settle.answers import Answers
from pipeline.settle.approve import approved
from pipeline.settle.beyond import simulated_mm, zero_mm
from pipeline.settle.choose import Budget, chosen, firm, reachable
from pipeline.settle.expected_loop import expected_loops
from pipeline.settle.limits import Allowed, beyond
from pipeline.settle.motor import Motor
from pipeline.settle.move import describe, free_dir
from pipeline.settle.proposed import retimed
from pipeline.settle.sheet import hand_out, hung_before, sheet
from pipeline.settle.step import Place, Step
from pipeline.wire.motion import Limits

RIG = Limits(100, (0.0, 30.0), 8.0, 40.0, 600.0, 1.5, 0.0, (5.0, 60.0))


def entry(title: str, top: float = 20.0, load_n: float = 20.0, decides: bool = True, **more) -> dict:
    """A run of one stroke, as next_runs.json has it."""
    legs = [
        {"seconds": 2.0, "motor_turns": 0.0, "load_n": 20.0},
        {"seconds": 5.0, "motor_turns": top, "load_n": load_n},
        {"seconds": 5.0, "motor_turns": 0.0, "load_n": load_n},
    ]
    return (
        {"title": title, "legs": legs, "from": 0.0, "load": 20.0, "decides": decides, "raises": decides, "curves": {}}
        | {
            "gap_now": 4.0,
            "gap_then": 400.0 if decides else 4.1,
        }
        | more
    )


def test_what_both_allow_is_the_narrower_of_the_two():
    limits = Allowed.read("{turns: [-5, 25], turns_per_s: 9, load_n: [10, 90], seconds: 60}").within(RIG)
    assert (limits.turns, limits.turns_per_s, limits.load_n, limits.seconds) == ((0.0, 25), 8.0, (10, 60.0), 60)
    assert Allowed.read("{}").within(RIG) == RIG


@pytest.mark.parametrize(
    ("limits_text", "title"),
    [("{load_n: [20, 20]}", "one stroke"), ("{turns: [0, 15]}", "half"), ("{}", "one stroke under half the load")],
)
def test_a_person_who_moves_the_rig_may_say_limits_too(limits_text, title):
    options = [entry("one stroke under half the load", load_n=10.0), entry("one stroke"), entry("half", top=12.0)]
    bounds = Motor(None, 9600, Allowed.read(limits_text), False).bounds()
    assert chosen(options, 1, bounds, Budget(3, 9.0, 9))[0].proposal["title"] == title
    assert (bounds is None) == (limits_text == "{}")


@pytest.mark.parametrize(
    "text",
    ["[1]", "{turn: 3}", "{turns: 3}", "{turns: [5, 1]}", "{seconds: -1}", "{seconds: true}", "{load_n: [a, b]}"],
)
def test_limits_that_are_none_are_refused_with_an_example(text):
    with pytest.raises(BadInput, match="turns_per_s: 8"):
        Allowed.read(text)


def test_the_best_run_that_is_allowed_is_chosen_and_what_is_passed_over_is_said():
    options = [entry("far", top=40.0), entry("heavy", load_n=80.0), entry("good"), entry("less good")]
    step, why = chosen(options, 3, RIG, Budget(2, 10.0, 10))
    assert (
        step is not None
        and step.proposal["title"] == "good"
        and step.number == 3
        and (step.strokes, step.seconds) == (1, 12.0)
    )
    assert (
        "leg 2 goes to 40 turns" in why and "(far)" in why and "leg 2 asks for 80 N" in why and "less good" not in why
    )


def test_runs_that_are_passed_over_for_one_reason_are_said_together():
    options = [entry(f"far {number}", top=40.0) for number in range(5)]
    step, why = chosen([*options, entry("heavy", load_n=80.0)], 1, RIG, Budget(2, 10.0, 10))
    assert step is None and why.count("goes to 40 turns") == 1 and "(far 0, far 1, far 2 and 2 others)" in why
    assert "(heavy)" in why


def test_without_a_run_that_decides_the_tie_is_said_to_be_one_by_construction():
    step, why = chosen([entry("one", decides=False)], 1, RIG, Budget(2, 10.0, 10))
    assert (
        step is None
        and "about 2.0 standard deviations so far, about 2.0 standard deviations with the best" in why
        and "tie by construction" in why
    )
    step, _ = chosen([entry("one", decides=False, raises=True, gap_then=9.5)], 1, RIG, Budget(2, 10.0, 10))
    assert step is not None  # it decides nothing by itself, and raises the gap


@pytest.mark.parametrize(
    ("budget", "option"),
    [(Budget(1, 10.0, 10), "--runs"), (Budget(5, 0.39, 10), "--minutes"), (Budget(5, 10.0, 1), "--strokes")],
)
def test_a_budget_counts_what_was_spent(budget, option):
    spent_step = chosen([entry("one")], 1, RIG, Budget(1, 10.0, 10))[0].at("diagnosed")
    step, why = chosen([entry("two")], 2, RIG, budget.left([Step(0, "diagnosed"), spent_step]))
    assert step is None and option in why


def test_the_way_to_where_a_run_begins_is_slow_enough_for_the_rig():
    at = Limits(100, (0.0, 30.0), 2.0, 40.0, 600.0, 1.5, 28.0, None)
    legs = reachable(entry("one"), at)
    assert legs[0].seconds >= 28.0 / 2.0 and [leg.load_n for leg in legs] == [None] * 3
    assert [leg.load_n for leg in reachable(entry("two", load_n=40.0), at)] == [20.0, 40.0, 40.0]


@pytest.mark.parametrize(("turns_per_s", "is_chosen"), [(4.0, True), (3.3, False), (8.0, True)])
def test_a_run_that_is_a_little_too_fast_for_the_rig_is_made_as_fast_as_it_goes(turns_per_s, is_chosen):
    rig = Limits(100, (0.0, 30.0), turns_per_s, 40.0, 600.0, 1.5, 0.0, (0.0, 60.0))
    run = entry("quick")  # 20 turns in 5 s, with ramps faster than 4 turns/s
    step, why = chosen([run], 1, rig, Budget(2, 10.0, 10))
    assert (step is not None) == is_chosen, why
    if step is None:
        assert "and the rig makes 3.3" in why
        return
    assert [leg["seconds"] > 5.0 for leg in step.legs[1:]] == [turns_per_s < 5.0] * 2
    assert max(leg["seconds"] for leg in step.legs) <= 5.5 and beyond(as_legs(step.legs), rig) is None
    curves = {"time_s": [0.0, 2.0, 7.0, 12.0], "motor_turns": [0.0, 0.0, 20.0, 0.0]}
    moved = retimed(run | {"curves": curves}, step.legs)
    ends_s = np.cumsum([0.0, *(leg["seconds"] for leg in step.legs)])
    assert moved["legs"] == step.legs and np.allclose(moved["curves"]["time_s"], ends_s)
    assert moved["curves"]["motor_turns"] == curves["motor_turns"]


@pytest.mark.parametrize(
    ("answers", "moves"),
    [
        (["yes"], True),
        ([" YES "], True),
        (["y"], True),
        (["no"], False),
        (["N"], False),
        (["", "yes"], True),
        (["yess", "y"], True),
        (["", ""], False),
        (["ok", "make it"], False),
    ],
)
def test_a_person_is_asked_and_once_more_after_what_is_neither_yes_nor_no(answers, moves, monkeypatch, tmp_path):
    """`y` ended the program as "not approved"."""
    remaining, questions = iter(answers), []
    monkeypatch.setattr(sys.stdin, "isatty", lambda: True, raising=False)
    monkeypatch.setattr("builtins.input", lambda question: questions.append(question) or next(remaining))
    step = approved(Step(1, "proposed"), "ask", Answers(tmp_path))
    assert (step is not None) == moves and (step is None or step.state == "approved")
    assert len(questions) == len(answers) and all("neither yes nor no" in question for question in questions[1:])


def test_a_sheet_says_each_leg_and_how_to_record_it():
    step = chosen([entry("one", load_n=40.0)], 1, None, Budget(1, 10.0, 10))[0].at("proposed", run_dir="raw/a-s1")
    text = sheet(step, Path("raw/a"), "no --port was given")
    assert "Before it, hang 40 N, and leave it there." in text and "under" not in text
    assert "its run.yaml is there, and says the string of raw/a and load_n: 40, where no channel records it." in text
    assert (
        "1. stand at 0.00 turns for 2.0 s\n" in text
        and "2. go from 0.00 to 20.00 turns in 5.0 s, at 4.00 turns/s\n" in text
    )
    assert "3. go from 20.00 to 0.00 turns in 5.0 s, at 4.00 turns/s\n" in text and "capture PORT raw/a-s1" in text
    changes = entry("one", load_n=40.0)
    changes["legs"][2]["load_n"] = 10.0
    step = chosen([changes], 1, None, Budget(1, 10.0, 10))[0].at("proposed", run_dir="raw/a-s1")
    text = sheet(step, Path("raw/a"), "no --port was given")
    lines = [line.strip() for line in text.splitlines()]
    assert "Before it, hang 20 N." in lines
    for line in (
        "1. stand at 0.00 turns for 2.0 s",
        "2. hang 40 N in place of 20 N at 0.00 turns, in your own time",
        "3. go from 0.00 to 20.00 turns in 5.0 s, at 4.00 turns/s",
        "4. hang 10 N in place of 40 N at 20.00 turns, in your own time",
        "5. go from 20.00 to 0.00 turns in 5.0 s, at 4.00 turns/s",
    ):
        assert line in lines
    assert "record it as load_n too" in text and "leave it there" not in text


def as_recorded() -> tuple[Step, dict]:
    """A stroke as a poor recording led to it: the motor stood a hair below where it begins; and what is foretold."""
    legs = [
        {"seconds": seconds, "motor_turns": turns, "load_n": load_n}
        for seconds, turns, load_n in ((2, 0.953, 18.7), (0.5, 0.953, 37.4), (13, 25.7, 37.4), (20, 25.7, 37.4))
    ]
    legs.append({"seconds": 13, "motor_turns": 0.953, "load_n": 37.4})
    proposal = {"title": "one stroke", "legs": legs, "from": 0.94, "load": 18.7}
    time_s = np.linspace(0.0, 48.5, 400)
    turns = np.interp(time_s, [0, 2.5, 15.5, 35.5, 48.5], [0.953, 0.953, 25.7, 25.7, 0.953])
    down = time_s > 35.5
    rivals = {name: (0.1 * turns**2 + down * width * (turns > 1.0)).tolist() for name, width in WIDTHS.items()}
    curves = {"time_s": time_s.tolist(), "motor_turns": turns.tolist(), "load": [37.4] * 400, "calibrated": [0.0] * 400}
    return Step(1, "proposed", "raw/a-s1", proposal), curves | {"rivals": rivals}


WIDTHS = {"backlash": 0.2, "friction_hysteresis": 0.41}


def test_the_sheet_of_a_person_asks_for_nothing_that_nobody_can_see_or_do_in_time(tmp_path):
    """It said "go from 0.94 to 0.95 turns in 2.0 s" and "for 0.5 s, under 37.4 N", and not which loop to expect.

    The way of a hair made a second stroke of it, and its load one that changes; the page of details asked for one load.
    """
    step, curves = as_recorded()
    assert (step.strokes, step.loads_n) == (1, [37.4])
    place = Place(tmp_path)
    place.write_run(1, step.proposal | {"curves": curves})
    text = hand_out(hung_before(step), place, Path("raw/a"), "no --port was given")
    assert text == (tmp_path / "step-1" / "sheet.txt").read_text()
    motion = text[text.index("Before it") : text.index("Record all")].splitlines()
    assert motion == [
        "Before it, hang 37.4 N, and leave it there.",
        "What the motor does:",
        "  1. stand at 0.95 turns for 2.5 s",
        "  2. go from 0.95 to 25.70 turns in 13.0 s, at 1.90 turns/s",
        "  3. stand at 25.70 turns for 20.0 s",
        "  4. go from 25.70 to 0.95 turns in 13.0 s, at 1.90 turns/s",
        "The loop to expect, by how much winding and unwinding differ at most at one twist:",
        "  0.20 mm if backlash is right, 0.41 mm if friction_hysteresis is right",
        "",
    ]


def test_a_loop_that_tells_nothing_is_not_said_and_strokes_are_told_apart():
    step, curves = as_recorded()
    same = curves | {"rivals": {name: curves["rivals"]["backlash"] for name in WIDTHS}}
    assert expected_loops(step, same) == []
    twice = [*step.legs, {"seconds": 13, "motor_turns": 25.7}, {"seconds": 13, "motor_turns": 0.953}]
    longer = curves | {"time_s": [*curves["time_s"], 61.5, 74.5], "motor_turns": [*curves["motor_turns"], 25.7, 0.953]}
    longer["rivals"] = {name: [*curve, 66.0, 0.1] for name, curve in curves["rivals"].items()}
    lines = expected_loops(step.at("proposed", proposal=step.proposal | {"legs": twice}), longer)
    assert [line[:12] for line in lines[1:]] == ["  stroke 1: "], "in the second one they foretell the same"


def test_a_folder_that_a_proposal_left_empty_is_used_again(make_run, tmp_path):
    """Each start without a port could leave one more `raw/poor-1-sN` with nothing in it."""
    first = make_run("a", recording(4), rig={"torsion_zone_mm": 150, "separator_mm": 8, "load_n": 20.0})
    step = chosen([entry("one", load_n=40.0)], 1, None, Budget(1, 10.0, 10))[0].at("proposed", run_dir="raw/a-s1")
    waits = free_dir(first, first)
    assert waits.name == "a-s1"
    describe(waits, first, step)
    assert free_dir(first, first) == waits and not waits.exists(), "with a load of its own, of another proposal"
    describe(waits, first, step)
    text = (waits / "run.yaml").read_text()
    (waits / "run.yaml").write_text(text + "tolerance: {length_mm: 0.5}\n")
    assert free_dir(first, first).name == "a-s2" and waits.exists(), "somebody wrote into it"
    (waits / "run.yaml").write_text(text)
    (waits / "notes.txt").write_text("hung at noon")
    assert free_dir(first, first).name == "a-s2" and waits.exists()


@pytest.mark.parametrize(("rig", "hangs"), [({"load_n": 20.0}, 40.0), ({}, None)])
def test_a_load_that_nothing_measures_is_that_of_the_run_that_is_made(make_run, tmp_path, rig, hangs):
    first = make_run("a", recording(4), rig={"torsion_zone_mm": 150, "separator_mm": 8, **rig})
    step = chosen([entry("one", load_n=40.0)], 1, None, Budget(1, 10.0, 10))[0].at("proposed", run_dir="raw/a-s1")
    describe(first.parent / "a-s1", first, step)
    assert read_run(first.parent / "a-s1").rig.get("load_n") == hangs


def test_steps_are_read_as_they_were_written(tmp_path):
    place = Place(tmp_path)
    written = [place.write(Step(0, "diagnosed", verdict="ambiguous")), place.write(Step(1, "approved", "raw/a-s1"))]
    assert place.steps() == written
    (tmp_path / "step-1" / "state.json").write_text('{"number": 7, "state": "approved"}')
    with pytest.raises(BadInput, match="is no step of this folder"):
        place.steps()


def test_a_loop_reads_each_recording_once_however_many_steps_are_diagnosed_with_it(make_run, tmp_path, monkeypatch):
    run, place, reads = make_run("nylon-1"), Place(tmp_path / "out"), []

    def diagnosed(folders, out, options):
        reads.extend(options.reader(folder) for folder in folders)
        out.mkdir(parents=True)
        (out / "diagnosis.json").write_text('{"verdict": "ambiguous", "mechanisms": [], "alternatives": []}')

    monkeypatch.setattr(loop, "diagnose", diagnosed)
    going = loop.Loop([run], place, Motor(None, 0, Allowed({}), False), "ask", Budget(3, 30.0, 40))
    for number in (0, 1):
        going._diagnosed([*[Step(0, "diagnosed")] * number, Step(number, "recorded", used=number == 0)])
    assert len(reads) == 2 and reads[0] is reads[1]


def test_a_motor_that_runs_late_is_no_effect_in_the_figure():
    time_s = np.linspace(0.0, 10.0, 201)
    turns = np.interp(time_s, [0, 2, 6, 10], [0.0, 0.0, 8.0, 0.0])
    curves = {"time_s": time_s, "load": np.full(201, 20.0), "motor_turns": turns, "calibrated": turns**2}
    late = np.interp(time_s - 0.3, time_s, turns)
    np.testing.assert_allclose(simulated_mm(curves, time_s, late), late**2, atol=0.05)
    noisy = 5.0 + late**2 + np.where(time_s == 0.0, 1.0, 0.0)
    assert zero_mm(late, noisy) == 5.0


def test_a_name_that_is_not_sure_is_firm_when_a_second_run_says_it_again():
    tie, creep, wear = ("ambiguous", ["creep"]), ("explained", ["creep"]), ("explained", ["wear"])
    assert not firm([tie], doubted=True) and firm([creep], doubted=True)
    assert firm([tie, creep], doubted=False) and not firm([tie, creep], doubted=True)
    assert firm([tie, creep, creep], doubted=True) and not firm([tie, creep, wear], doubted=True)
    assert firm([tie, ("unknown", [])], doubted=False)
