"""Verdicts on the page and at the end of the main job."""

import html
import re

from made_verdict import made_verdict

from pipeline.ground.words.glossary import MEANING
from pipeline.report.end_of_job.summary import summary
from pipeline.report.parts.diagnoses import (  # fmt: skip
    content_of,
    explanations,
    named_of,
    next_recording,
    part,
    sizes,
    verdict_of,
    verdicts,
    why_nothing,
)
from pipeline.report.parts.index_head import advice, counted, runs_table


def made(reports, run, words, **content):
    return made_verdict(reports / "diagnosis" / run, words, content)


HELD = {"nominal_mm": 1.92, "calibrated_mm": 0.81, "explained_mm": 0.034}
TIED = {
    "verdict": "ambiguous",
    "mismatch": {"rms_mm": 0.44},
    "mechanisms": [{"id": "creep"}, {"id": "backlash"}],
    "alternatives": [["thermal", "backlash"]],
    "fit": {"noise_floor_mm": 0.0312, "heldout": HELD},
}
FINE = {
    "verdict": "consistent", "mismatch": None, "mechanisms": [], "alternatives": [],
    "fit": {"noise_floor_deg": 0.2, "heldout": None},
}  # fmt: skip


def test_a_row_says_what_is_left_out_and_what_it_improves(tmp_path):
    made_there = made(tmp_path, "a", "a: ambiguous", **TIED), made(tmp_path, "b", "b: consistent", **FINE)
    a, b, c = (content_of(folder) for folder in (*made_there, made(tmp_path, "c", "too short")))
    assert [verdict_of(content) for content in (a, b, c)] == ["ambiguous", "consistent", "not decided"]
    assert sizes(a) == ["0.44 mm", "1.9 mm", "0.81 mm", "0.034 mm", "0.031 mm"]
    assert sizes(b) == ["", "", "", "", "0.2 deg"] and sizes(c) == [""] * 5
    assert explanations(a) == [["creep", "backlash"], ["thermal", "backlash"]] and explanations(c) == []
    assert ">creep</abbr> + <abbr" in named_of(a) and named_of(a).endswith(", or 1 other explanation")
    assert named_of(b) == named_of(c) == ""


NOTHING = """\
a: explained: physics is missing.

What to know first
  Adopt nothing: not said under its heading.

What to do, in this order
  1. Adopt nothing: on the unseen strokes the explanation makes the simulator worse. Record the rig once more,
     with more strokes (see details.txt), and diagnose all runs together.
  2. You can report: 0.17 mm. Record the rig again.

More: details.txt"""


def test_a_name_that_makes_the_simulator_worse_has_that_in_its_badge_and_is_counted_apart(tmp_path):
    worse = {**TIED, "verdict": "explained", "fit": {**TIED["fit"], "worse_than_nominal": ["explained"]}}
    contents = {"a": worse, "b": {**TIED, "verdict": "explained"}, "c": {**worse, "verdict": "unknown"}}
    badge = "explained</abbr>, but worse on unseen strokes: do not adopt</span>"
    rows = str(runs_table(tmp_path, contents, {}, str)).split("<tr>")
    assert [badge in row for row in rows[-3:]] == [True, False, False]
    top = str(counted(contents))
    assert 'data-only="explained, but worse on unseen strokes: do not adopt">1 ' in top and badge in top
    assert 'data-only="explained">1 ' in top and 'data-only="unknown">1 ' in top


def test_a_name_that_changes_without_the_last_strokes_has_the_badge_that_its_verdict_says(tmp_path):
    """The badge said "worse on unseen strokes", and the page "not settled": one verdict had two names."""
    others = {"chosen_without_them": ["wear"]}
    harm = {**TIED["fit"], "worse_than_nominal": ["explained"]}
    contents = {"a": {**TIED, "verdict": "explained", "fit": harm, "evidence": others}}
    row = str(runs_table(tmp_path, contents, {}, str)).split("<tr>")[-1]
    assert "explained</abbr>, but not settled</span>" in row and "worse on unseen" not in row
    assert 'data-only="explained, but not settled">1 ' in str(counted(contents))


def test_the_table_of_runs_calls_an_error_what_a_verdict_and_the_glossary_call_it(tmp_path):
    """An error stood under "explained" here and in the row "as diagnosed" of the verdict."""
    heads = str(runs_table(tmp_path, {"a": TIED}, {}, str)).partition("<tbody>")[0]
    rules = re.findall(r'<th class="(over|bare)" colspan="(\d+)">(<span>rms error [^<]*</span>)?</th>', heads)
    assert [(kind, int(width)) for kind, width, _ in rules] == [("bare", 5), ("over", 3), ("bare", 2)] and rules[1][2]
    assert "as diagnosed</abbr></th>" in heads and "explained" not in heads
    assert "error" not in MEANING["explained"] and "physics that the verdict names" in MEANING["as diagnosed"]


def test_an_unknown_verdict_has_no_error_of_what_it_names():
    assert sizes({**TIED, "verdict": "unknown"})[1:4] == ["1.9 mm", "0.81 mm", "–"]


def test_the_error_of_other_effects_is_not_that_of_what_the_verdict_names(tmp_path):
    """2.3 mm stood beside creep and friction; they were tried on no unseen stroke, and verdict.txt has a dash there."""
    others = {**TIED, "evidence": {"chosen_without_them": ["plastic_elongation", "shaft_windup"]}}
    assert sizes(others)[1:4] == ["1.9 mm", "0.81 mm", "–"]
    row = html.unescape(str(runs_table(tmp_path, {"a": {**others, "verdict": "explained"}}, {}, str)).split("<tr>")[-1])
    why = "0.034 mm with plastic_elongation + shaft_windup, which is named without these strokes"
    assert f'<td>–<br><span class="why">{why}</span></td>' in row, "the dash had no reason beside it"
    unknown = str(runs_table(tmp_path, {"a": {**TIED, "verdict": "unknown"}}, {}, str))
    assert '–<br><span class="why">nothing is named</span>' in unknown
    for chosen in (["backlash", "creep"], None):
        assert sizes({**TIED, "evidence": {"chosen_without_them": chosen}})[3] == "0.034 mm"
    for closest, error in ((["creep", "backlash"], "0.034 mm"), (["creep"], "–")):
        without = {"chosen_without_them": [], "closest_without_them": closest}
        assert sizes({**TIED, "evidence": without})[3] == error, "the named effects come closest, in whatever order"


def test_a_row_says_adopt_nothing_and_which_recording_its_verdict_asks_for(tmp_path):
    bad = made(tmp_path, "a", NOTHING, **TIED)
    good = made(tmp_path, "b", NOTHING.replace("What to do", "What was done"), **TIED)
    wanted_recording = "Record the rig once more, with more strokes (see details.txt), and diagnose all runs together"
    reason = "on the unseen strokes the explanation makes the simulator worse"
    assert why_nothing(bad) == reason and why_nothing(good) == why_nothing(tmp_path / "gone") == ""
    assert next_recording(bad) == wanted_recording and next_recording(good) == next_recording(tmp_path / "gone") == ""
    words = {run: str(runs_table(tmp_path, {run: content_of(tmp_path / "diagnosis" / run)}, {}, str)) for run in "ab"}
    assert f"<br>explains what was recorded, but adopt nothing: {reason}</td>" in words["a"]
    assert wanted_recording.partition(" (")[0] in words["a"]
    assert ">ambiguous</abbr></span></td>" in words["a"]  # a click on a verdict shows the rows of that cell's words
    assert "adopt nothing" not in words["b"] and "Record" not in words["b"]
    unknown = made(tmp_path, "d", NOTHING, **{**TIED, "verdict": "unknown"})
    assert advice("unknown", unknown) == f"adopt nothing: {reason}"
    own = {**TIED, "next_experiment": "hold 20 N: for 15 minutes"}
    assert "hold 20 N</td>" in runs_table(tmp_path, {"a": own}, {}, str)


def test_a_part_shows_its_run_and_escapes_what_it_prints(tmp_path):
    made(tmp_path, "a", "a: ambiguous <here>\n\nThe rest", **TIED)
    made(tmp_path, "c", "raw/c: too short")
    shown = part(tmp_path, "a")
    assert shown.index("a: ambiguous &lt;here&gt;") < shown.index("<img") < shown.index("The rest")
    assert shown.count("<img") == 1 and "raw/c: too short" in part(tmp_path, "c") and "<img" not in part(tmp_path, "c")
    assert "gone: no verdict was written" in part(tmp_path, "gone")


def test_a_part_leads_to_its_files_from_wherever_its_page_lies(tmp_path):
    folder = made(tmp_path, "a", "a: ambiguous", **TIED)
    assert 'href="../diagnosis/a/diagnosis.pdf"' in part(tmp_path, "a", "../")
    assert 'src="diagnosis/a/diagnosis.png"' in part(tmp_path, "a")
    (folder / "diagnosis.pdf").unlink()
    assert "diagnosis.pdf" not in part(tmp_path, "a")


def test_the_end_of_the_main_job_says_each_verdict(tmp_path):
    folder = made(tmp_path, "a", "a: backlash is at\n  work (ambiguous).\n\nWhat to know first\n  more", **TIED)
    sentence = "a: backlash is at work (ambiguous)."
    assert verdicts([folder, tmp_path / "b"]) == sentence
    assert "left out" not in summary([], tmp_path, [], ["a"])
    assert sentence in summary([str(folder)], tmp_path, [], ["a"])
