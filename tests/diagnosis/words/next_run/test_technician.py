"""The run to make next, as steps that a person or a program follows."""

import re

from made_content import SYSTEMS, adopted, content, leg, told

from pipeline.diagnosis.document.adopted_run import as_list
from pipeline.diagnosis.words.pages.spoken import spoken


def test_the_run_to_make_is_a_protocol_with_its_command():
    text = told()
    assert "A hold at full twist, then a rest; 3.5 min in all." in text
    for step in (
        "1. Begin at rest, at 0 turns under 20 N.", "2. Wind to 30.7 turns in 16 s (1.9 turns/s).",
        "3. Hold 60 s at 30.7 turns.", "4. Unwind to 0 turns in 16 s (1.9 turns/s).", "5. Hold 2 min at 0 turns.",
    ):  # fmt: skip
        assert step in text
    assert "it is to tell apart\n  friction_hysteresis + creep\n  friction_hysteresis + thermal\n" in text
    assert (
        "The run can decide between these two: over all samples they differ by 73 standard deviations of noise in the "
        "run, by 2.2 in this recording. Noise is not all that counts: in tests such runs settled 30 of 50 ties rightly "
        "and 5 wrongly, and left 15 open. Without the run report the best explanation as one of 2."
    ) in text
    assert "python -m pipeline.diagnose raw/nylon-3 raw/nylon-3-next --together --out DIR" in text


def test_the_json_holds_the_same_protocol_in_one_string():
    protocol = spoken(content(), SYSTEMS["mm"])["next_experiment"]
    assert protocol.startswith(
        "A hold at full twist, then a rest: 3.5 min in all. 1. Begin at rest, at 0 turns under 20 N."
    )
    assert "5. Hold 2 min at 0 turns." in protocol and "`--together`" in protocol


def test_another_load_where_the_load_is_not_recorded_is_a_run_of_its_own():
    legs = [leg(2.0, 0.0, 20.0), leg(0.5, 0.0, 30.0), leg(10.0, 12.0, 30.0), leg(10.0, 0.0, 30.0),
            leg(0.5, 0.0, 20.0), leg(20.0, 12.0, 20.0), leg(20.0, 0.0, 20.0)]  # fmt: skip
    run = {"title": "another load, then half the speed", "legs": legs, "load": 20.0, "follows": "twist"}
    both = told(content(next_run=run | {"fixed_load": True}))
    assert "Run 1: change the load from 20 to 30 N, and say so in run.yaml (`load_n: 30`)" in both
    assert "Run 2, under 20 N as recorded:" in both
    assert "raw/nylon-3 raw/nylon-3-next-1 raw/nylon-3-next-2 --together" in both
    assert "It shows whether what is missing follows the twist, as here, or what went along with it." in both
    assert "  python -m pipeline.new_run nylon-3-next-1 --like raw/nylon-3 --load-n 30\n" in both
    assert "  python -m pipeline.new_run nylon-3-next-2 --like raw/nylon-3\n" in both
    assert "  python -m pipeline.capture PORT raw/nylon-3-next-2\n" in both
    assert "If your rig cannot change its load, make the run at the other speed alone: it shows less." in both
    single_run = told(content(next_run=run | {"fixed_load": False}))
    assert "Change the load to 20 N." in single_run and "raw/nylon-3 raw/nylon-3-next --together" in single_run


def test_a_load_cell_that_reads_a_little_more_changes_no_load():
    legs = [leg(2.0, 0.0, 22.6), leg(0.5, 0.0, 22.6), leg(1.2, 20.0, 21.6), leg(1.2, 0.0, 21.6)]
    text = told(content(next_run={"title": "one stroke", "legs": legs, "load": 22.6, "fixed_load": False}))
    assert "hange the load" not in text


def test_a_rest_alone_would_be_refused_and_so_ends_with_a_stroke():
    run = {"title": "a rest with the motor off", "legs": [leg(2.0, 0.0, 20.0), leg(120.0, 0.0, 20.0)]}
    text = told(content(next_run=run))
    assert "1. Hold 2 min at 0 turns under 20 N." in text and "2. Then make one stroke as before" in text
    assert "Then make one stroke" not in told()


def test_what_is_repeated_is_counted_and_reversals_in_a_row_are_one_step():
    stroke = [leg(0.5, 0.0, 20.0), leg(5.0, 6.0, 20.0), leg(0.2, 6.0, 20.0), leg(5.0, 0.0, 20.0)]
    text = told(content(next_run={"title": "four strokes", "legs": [leg(2.0, 0.0, 20.0), *stroke * 4]}))
    assert "4. Repeat steps 2 to 3 another 3 times." in text
    places = (6.0, 3.0, 9.0, 4.0, 12.0, 0.0)
    row = [leg(abs(to - at), to, 20.0) for at, to in zip((0.0, *places), places, strict=False)]
    text = told(content(next_run={"title": "reversals", "legs": [leg(2.0, 0.0, 20.0), *row]}))
    assert "2. Go to 6, 3, 9, 4, 12 and 0 turns without a pause, at 1.0 turns/s (40 s in all)." in text


def test_a_run_of_the_adopted_verdict_keeps_its_loads():
    legs = [leg(2.0, 0.0, 20.0), leg(0.5, 0.0, 30.0), leg(10.0, 12.0, 30.0), leg(10.0, 0.0, 30.0),
            leg(0.5, 0.0, 20.0), leg(20.0, 12.0, 20.0), leg(20.0, 0.0, 20.0)]  # fmt: skip
    run = {"title": "another load", "legs": legs, "load": 20.0, "follows": "twist", "fixed_load": True}
    adopted_verdict = {"effects": ["creep"], "verdict": "ambiguous", "tied": [["thermal"]], "runs": ["nylon-3"]}
    adopted_verdict["next_experiment"] = spoken(content(next_run=run), SYSTEMS["mm"])["next_experiment"]
    text = adopted(adopted=[adopted_verdict])
    assert " Run 2, under 20 N as recorded:\n    1. Begin at rest, at 0 turns under 20 N.\n" in text
    assert "  python -m pipeline.new_run nylon-3-next-1 --like raw/nylon-3 --load-n 30\n" in text
    assert "  python -m pipeline.new_run nylon-3-next-2 --like raw/nylon-3\n" in text


def test_a_run_that_the_rig_may_not_bear_says_what_stays_without_it():
    text = told(content(next_run__title="one stroke under twice the load"))
    advice = "Only if the rig bears so much. If your rig cannot change its load, leave this run out: the likelier expl"
    assert f"{advice}anations stay tied." in text and "If your rig cannot" not in told()
    half = "one stroke under half the load"
    fixed = told(content(next_run__title=half, next_run__load=20.0, next_run__fixed_load=True))
    look = "`python -m pipeline.settle RUN --limits '{load_n: [20, 20]}'` looks for one under this load"
    assert f"the likelier explanations stay tied. {look}; it says where none does." in fixed and look not in text
    fast = told(content(next_run__title="one stroke at twice the speed"))
    assert "Only if the motor can go so fast. If your rig cannot go so fast, leave this run out" in fast


def test_the_run_that_decides_is_a_short_list_in_run_yaml_that_the_next_verdict_reads_as_the_paragraph():
    paragraph = spoken(content(next_run__title="one stroke under half the load"), SYSTEMS["mm"])["next_experiment"]
    protocol_lines = as_list(paragraph)
    assert protocol_lines[0] == "One stroke under half the load: 3.5 min in all." and protocol_lines[2].startswith(
        "2. Wind to 30.7 turns"
    )
    assert [line[:2] for line in protocol_lines[1:6]] == ["1.", "2.", "3.", "4.", "5."] and len(protocol_lines) < 12
    assert all(line.count(". ") <= 1 for line in protocol_lines), "a line says one thing"
    assert protocol_lines[-1].startswith("It is to tell friction_hysteresis + creep from")
    adopted_verdict = {"effects": ["creep"], "verdict": "ambiguous", "tied": [["thermal"]], "runs": ["nylon-3"]}
    texts = [
        adopted(adopted=[adopted_verdict | {"next_experiment": experiment}])
        for experiment in (paragraph, protocol_lines)
    ]
    steps = [re.findall(r"^    \d\. .*$", text, re.M) for text in texts]
    assert steps[0] == steps[1] and len(steps[0]) == 5
    load = [leg(2.0, 0.0, 20.0), leg(0.5, 0.0, 30.0), leg(10.0, 12.0, 30.0), leg(10.0, 0.0, 30.0)]
    run = {"title": "another load", "legs": load, "load": 20.0, "follows": "twist", "fixed_load": True}
    protocol_lines = as_list(spoken(content(next_run=run), SYSTEMS["mm"])["next_experiment"])
    assert "--load-n 30" in adopted(adopted=[adopted_verdict | {"next_experiment": protocol_lines}])
