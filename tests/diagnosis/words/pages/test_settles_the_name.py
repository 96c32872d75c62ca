"""A name that changes without the last strokes: which recording settles it, and how often the page says so."""

from made_content import confident, full, page

CHANGED = {"verdict": "explained", "alternatives": [], "next_run": None, "evidence__moved_sigma": {"radius_mm": 1.3},
           "evidence__chosen_without_them": ["slack"]}  # fmt: skip
STEP = "To settle the name, record 12 strokes again in the same way, and diagnose the runs together."


def joined(text):
    return " ".join(text.split())


def test_the_first_step_settles_the_name_and_its_commands_stand_where_it_says():
    """What to do lacked it, and the details said that no run is needed."""
    diagnosis = confident(0.93, 0.96, **CHANGED)
    assert f"1. {STEP} Commands: details.txt, The run to make next." in joined(page(confident(0.93, 0.96, **CHANGED)))
    run = full(diagnosis).partition("The run to make next\n")[2].partition("\n\n")[0]
    assert STEP in run and "None is needed" not in run
    assert "pipeline.diagnose raw/nylon-3 raw/nylon-3-next --together" in run
    same = page(confident(0.93, 0.96, **CHANGED | {"evidence__chosen_without_them": ["creep", "friction_hysteresis"]}))
    assert "To settle the name" not in same
    missed = page(confident(0.93, 0.96, fit__heldout__explained_mm=0.1, **CHANGED))
    assert missed.count("strokes again") == 1, "one recording does both"


def test_the_page_says_in_its_first_line_and_at_its_table_that_other_effects_were_named():
    """It stood there four times."""
    text, more = (joined(show(confident(0.93, 0.96, **CHANGED))) for show in (page, full))
    assert "without the last 30 % of strokes another explanation was found." in text
    assert "Other effects: slack, which the procedure names without these strokes." in text
    for again in ("Without the last 30 % of strokes the procedure names slack", "but both are only probable"):
        assert again not in text and again in more
    in_part = CHANGED | {"evidence__chosen_without_them": ["creep"]}
    assert "has 93 %, but is only probable" in joined(page(confident(0.93, 0.96, **in_part))), "of one alone"
