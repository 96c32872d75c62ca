"""A zero that was not compared, or set anew, is said on the pages and at the job's end: it stood in a log alone."""

import pytest

from pipeline.ground.words.jump_notes import NOT_COMPARED, SET_ANEW, Kind, beside_answers, gravest, write_jumps
from pipeline.report.end_of_job import summary as end
from pipeline.report.index import page
from pipeline.report.layout.made_by import MadeBy
from pipeline.report.parts import jumps
from pipeline.report.parts.page_parts import of_materials, of_runs

NOTE = f"{NOT_COMPARED} a-1 and a-2: a-1 rests last at 35 N, a-2 begins at 25 N."
JUMP = "The zero jumps between two runs of one string."
ANEW = f"{SET_ANEW} a-3 (-0.61 mm), as run.yaml says."
KINDS = [
    ([NOTE], Kind.NOT_COMPARED),
    ([JUMP, NOTE], Kind.JUMP),
    ([ANEW], Kind.SET_ANEW),
    ([NOTE, ANEW], Kind.NOT_COMPARED),
]

WHAT = {Kind.JUMP: "zero jumps", Kind.NOT_COMPARED: "zero was not compared", Kind.SET_ANEW: "zero was set anew"}


@pytest.mark.parametrize(("notes", "kind"), KINDS)
def test_a_page_says_it_in_a_box_and_what_it_means(notes: list[str], kind: Kind) -> None:
    for text in (jumps.box(notes).unescape(), "".join(jumps.quoted(notes))):
        assert f"Beware: {notes[-1][:20]}" in text
        assert [each for each, meaning in jumps.MEANING.items() if meaning in text] == [kind]
    assert jumps.beneath("md", notes)[-1].startswith(f"Beware: {notes[-1][:18]}")
    beware = f"Beware: the {WHAT[kind]} between runs of one string; see the log of the dataset."
    assert jumps.beneath("tex", notes) == [beware]
    assert gravest(notes) == kind


def test_predict_says_the_gravest_and_how_many_more_there_are(tmp_path) -> None:
    path = tmp_path / "zero_jumps.json"
    assert beside_answers(path, {"a"}, {"a"}) == []
    write_jumps(path, {"a": [ANEW, NOTE, JUMP], "b": [ANEW]})
    (line,) = beside_answers(path, {"a"}, {"a"})
    assert line == f"beware: {JUMP} 2 more notes on the zero of these runs: {path}"
    assert beside_answers(path, {"b"}, set()) == [f"beware: {ANEW}"]


def test_the_zero_of_a_string_that_nobody_asks_about_is_named_in_one_short_line(tmp_path) -> None:
    """It stood as a Beware above answers about other strings, in full, whatever model answered."""
    path = tmp_path / "zero_jumps.json"
    write_jumps(path, {"a": [NOTE], "b": [], "c": [ANEW]})
    learnt = "note: the model that answers has learnt"
    expected = f"{learnt} strings a, c too, whose zero was not compared between runs: {path}"
    assert beside_answers(path, {"b"}, {"a", "b", "c"}) == [expected]
    expected = f"{learnt} string c too, whose zero was set anew between runs: {path}"
    assert beside_answers(path, {"a"}, {"a", "c"}) == [f"beware: {NOTE}", expected]
    assert beside_answers(path, {"b"}, set()) == [], "a model of each string alone has learnt no other"
    write_jumps(path, {f"s{number}": [JUMP] for number in range(7)})
    (line,) = beside_answers(path, {"new"}, {f"s{number}" for number in range(7)})
    assert f"strings s0, s1, s2, s3 and 3 more too, whose zero jumps between runs: {path}" in line


def test_the_page_of_all_reports_says_it_and_speaks_of_no_jump(tmp_path) -> None:
    runs, mark = of_runs(tmp_path, []), MadeBy("default.yaml", "abc1234", "default", "", ())
    text = page(tmp_path, of_materials(tmp_path, [], {}, runs), runs, {}, [], mark, {"dyneema": [NOTE]})
    assert NOTE in text and 'id="jumps">The zero was not compared</h2>' in text and "The zero jumps" not in text
    assert "its zero was not compared between runs</a>" in jumps.hint("dyneema", {"dyneema": [NOTE]})
    assert "its zero jumps" in jumps.hint("dyneema", {"dyneema": [JUMP, NOTE]})
    assert "its zero was set anew between runs, and is known in part" in jumps.hint("dyneema", {"dyneema": [ANEW]})


@pytest.mark.parametrize(("notes", "kind"), [*KINDS, ([], None)])
def test_the_job_says_it_at_its_end(tmp_path, monkeypatch, notes: list[str], kind: Kind | None) -> None:
    note = tmp_path / "processed" / "dyneema" / "zero_jumps.json"
    model = note.with_name("spline") / "within-0.model"
    model.parent.mkdir(parents=True)
    model.touch()
    note.touch()
    monkeypatch.setattr(end, "read_jumps", lambda _: notes)
    end_text = end.summary([str(note), str(model)], tmp_path / "reports", ["dyneema"], [])
    assert "\nto a controller: " in end_text and all(note in end_text for note in notes)
    assert [each for each, doubt in end.DOUBTS.items() if doubt in end_text] == ([kind] if notes else [])
