"""A zero that was not compared is said on the pages and at the job's end: it stood in the log of the dataset alone."""

import pytest

from pipeline.ground.words.jump_notes import NOT_COMPARED
from pipeline.report.end_of_job import summary as end
from pipeline.report.index import page
from pipeline.report.layout.made_by import MadeBy
from pipeline.report.parts import jumps
from pipeline.report.parts.page_parts import of_materials, of_runs

NOTE = f"{NOT_COMPARED} a-1 and a-2: a-1 rests last at 35 N, a-2 begins at 25 N."
JUMP = "The zero jumps between two runs of one string."


@pytest.mark.parametrize(("notes", "meaning"), [([NOTE], jumps.MOVED), ([JUMP, NOTE], jumps.UNTIL)])
def test_a_page_says_it_in_a_box_and_what_it_means(notes: list[str], meaning: str) -> None:
    for text in (jumps.box(notes).unescape(), "".join(jumps.quoted(notes))):
        assert f"Beware: {NOTE[:20]}" in text and meaning in text
        assert (jumps.UNTIL in text) == (JUMP in notes)
    assert jumps.beneath("md", notes)[-1].startswith(f"Beware: {NOT_COMPARED}")
    what = "the zero jumps" if JUMP in notes else "the zero was not compared"
    assert jumps.beneath("tex", notes) == [f"Beware: {what} between runs of one string; see the log of the dataset."]


def test_the_page_of_all_reports_says_it_and_speaks_of_no_jump(tmp_path) -> None:
    runs, mark = of_runs(tmp_path, []), MadeBy("default.yaml", "abc1234", "default", "", ())
    text = page(tmp_path, of_materials(tmp_path, [], {}, runs), runs, {}, [], mark, {"dyneema": [NOTE]})
    assert NOTE in text and 'id="jumps">The zero was not compared</h2>' in text and "The zero jumps" not in text
    assert "its zero was not compared between runs</a>" in jumps.hint("dyneema", {"dyneema": [NOTE]})
    assert "its zero jumps" in jumps.hint("dyneema", {"dyneema": [JUMP, NOTE]})


@pytest.mark.parametrize("notes", [[NOTE], [JUMP, NOTE], []])
def test_the_job_says_it_at_its_end(tmp_path, monkeypatch, notes: list[str]) -> None:
    note = tmp_path / "processed" / "dyneema" / "zero_jumps.json"
    model = note.with_name("spline") / "within-0.model"
    model.parent.mkdir(parents=True)
    model.touch()
    note.touch()
    monkeypatch.setattr(end, "read_jumps", lambda _: notes)
    end_text = end.summary([str(note), str(model)], tmp_path / "reports", ["dyneema"], [])
    assert "\nto a controller: " in end_text and (NOTE in end_text) == bool(notes)
    assert (end.UNCOMPARED in end_text) == (notes == [NOTE]) and (end.JUMPED in end_text) == (JUMP in notes)
