"""What the page says of adopting."""

from pathlib import Path

import pytest
from made_content import SYSTEMS, content, to_adopt

from pipeline.diagnosis.words.pages.details import details_text
from pipeline.diagnosis.words.pages.spoken import spoken
from pipeline.diagnosis.words.pages.verdict import verdict_text


def test_what_is_named_comes_with_the_command_that_adopts_it():
    near = {"evidence__moved_sigma": {"radius_mm": 0.4}}
    assert "  python -m pipeline.adopt reports/nylon-3/diagnosis.json raw/nylon-3\n" in to_adopt(**near)
    need = "Make the run above first, if you need to know which is at work: creep or thermal."
    assert need in to_adopt(**near), "the page says no more"
    tried = to_adopt(next_run__gap_then=9.0, **near).replace("\n    ", " ")
    assert "No run that was tried is sure to decide between the explanations." in tried
    simulate = "python -m pipeline.simulate raw/nylon-3 --simulation reports/nylon-3/diagnosis.json --out FILE.csv"
    assert f"  {simulate}\n" in to_adopt()
    assert "explanation" not in to_adopt(verdict="explained", next_run=None)
    assert to_adopt(fit__heldout__explained_mm=0.95).strip().startswith("Adopt nothing: on the unseen strokes")
    assert not to_adopt(verdict="unknown", mechanisms=[], alternatives=[], next_run=None)


@pytest.mark.parametrize(("sigma", "first"), [(3.0, True), (0.4, False)])
def test_the_command_that_adopts_is_told_only_where_adopting_is_advised(sigma, first):
    diagnosis, system = content(evidence__moved_sigma={"radius_mm": sigma}), SYSTEMS["mm"]
    text = details_text(spoken(diagnosis, system), system, [Path("raw/nylon-3")], Path("reports/nylon 3"))
    use = " ".join(text.partition("\nTo use it\n")[2].partition("\n\n")[0].split())
    assert use.startswith(
        "To predict with it, dimensions included (PLAN.csv is a motion that you plan: time_s, motor_turns and, unless "
        "it stands still, load_n; its corners will do): python -m pipeline.simulate raw/nylon-3 --simulation"
    )
    assert "--simulation 'reports/nylon 3/diagnosis.json' --motion PLAN.csv --after-recording --out FILE.csv" in use
    assert "--simulation 'reports/nylon 3/diagnosis.json' --out FILE" in use
    assert ("Do not adopt before the radius is measured again." in use) is first
    assert ("with the dimensions that fit with them; yours stay as measured" in use) is not first
    assert ("python -m pipeline.adopt 'reports/nylon 3/diagnosis.json' raw/nylon-3" in use) is not first


def test_the_page_simulates_and_settles_the_run_that_was_recorded_last():
    """On one page `settle` had the last run and `simulate` the first, and no reason was said."""
    folders = [Path("raw/nylon-3"), Path("raw/nylon-4")]
    text = verdict_text(content(run=["nylon-3", "nylon-4"]), SYSTEMS["mm"], folders, Path("reports/both"))
    commands = [line.split()[2:4] for line in text.splitlines() if "python -m pipeline.s" in line]
    assert commands == [["pipeline.settle", "raw/nylon-4"], ["pipeline.simulate", "raw/nylon-4"]]
