"""Verdicts on the page and at the end of the main job."""

from made_verdict import made_verdict

from pipeline.report.diagnoses import row, section, verdicts
from pipeline.report.summary import summary


def made(reports, run, words, **content):
    return made_verdict(reports / "diagnosis" / run, words, content)


HELD = {"nominal_mm": 1.92, "calibrated_mm": 0.81, "explained_mm": 0.034}
TIED = {
    "verdict": "ambiguous",
    "mismatch": {"rms_mm": 0.44},
    "mechanisms": [{"id": "creep"}, {"id": "backlash"}],
    "alternatives": [["thermal", "backlash"]],
    "fit": {"noise_floor_mm": 0.0312, "heldout": HELD},
    "next_experiment": "A rest: 2 min in all. 1. Hold 2 min at 0 turns.",
}
FINE = {
    "verdict": "consistent", "mismatch": None, "mechanisms": [], "alternatives": [],
    "fit": {"noise_floor_deg": 0.2, "heldout": None},
}  # fmt: skip


def test_a_row_says_what_is_left_out_and_what_it_improves(tmp_path):
    left_out = "creep + backlash or thermal + backlash"
    sizes = ["0.44 mm", "1.9 mm", "0.81 mm", "0.034 mm", "0.031 mm", "A rest"]
    assert row(made(tmp_path, "a", "a: ambiguous", **TIED)) == ["a", "ambiguous", left_out, *sizes]
    assert row(made(tmp_path, "b", "b: consistent", **FINE)) == ["b", "consistent", "", "", "", "", "", "0.2 deg", ""]
    assert row(made(tmp_path, "c", "too short"))[:2] == ["c", "not decided"]


def test_the_page_shows_every_run_and_escapes_what_it_prints(tmp_path):
    made(tmp_path, "a", "a: ambiguous <here>", **TIED)
    made(tmp_path, "c", "raw/c: too short")
    page = section(tmp_path, ["a", "c"])
    assert "a: ambiguous &lt;here&gt;" in page and page.count("<img") == 1 and "raw/c: too short" in page
    assert '<a href="diagnosis/a/diagnosis.pdf"><img src="diagnosis/a/diagnosis.png"' in page


def test_no_name_of_a_run_becomes_html(tmp_path):
    evil = '<img src=x onerror=alert(1)> it\'s "b"'
    made(tmp_path, evil, "x", **TIED)
    page = section(tmp_path, [evil])
    assert page.count("<img") == 1 and "onerror=alert(1)>" not in page and 'alt="Diagnosis of &lt;img' in page


def test_a_cell_names_two_ties_and_counts_the_rest(tmp_path):
    many = TIED | {"alternatives": [[id_] for id_ in ("thermal", "wear", "jam", "slack")]}
    cell = row(made(tmp_path, "a", "a: ambiguous", **many))[2]
    assert cell == "creep + backlash or thermal or wear or 2 more"


def test_the_end_of_the_main_job_says_each_verdict(tmp_path):
    made(tmp_path, "a", "a: ambiguous: several fit alike.\n  more", **TIED)
    assert verdicts(tmp_path, ["a", "b"]) == "a: ambiguous: several fit alike. creep + backlash or thermal + backlash"
    assert "left out" not in summary(tmp_path, [], []) and "a: ambiguous" in summary(tmp_path, [], ["a"])
