"""Where other effects are named without the last strokes: one statement of it, in every place."""

from made_content import confident, content, full, page, told

ALONE = {"verdict": "explained", "alternatives": [], "next_run": None}


def test_the_first_line_says_with_the_probability_that_the_name_is_not_settled() -> None:
    settled = confident(0.93, 0.96, **ALONE)
    assert "not settled" not in page(settled)
    other = confident(0.93, 0.96, **ALONE, evidence__chosen_without_them=["creep"])
    first = " ".join(page(other).split("\n\n")[0].split())
    assert first == (
        "nylon-3: friction_hysteresis + creep explains the whole recording best (52 %). It is not settled: without "
        "the last 30 % of strokes another explanation was found."
    )


def test_the_first_sentence_says_the_outcome_and_the_page_says_once_that_the_other_effects_fail() -> None:
    failing = {"evidence__chosen_without_them": ["slack"], "fit__heldout__explained_mm": 4.3}
    diagnosis = confident(0.93, 0.96, **ALONE, **failing, fit__worse_than_nominal=["explained"])
    text = page(diagnosis)
    first = " ".join(text.split("\n\n")[0].split())
    outcome = "nylon-3: friction_hysteresis + creep explains the whole recording best (52 %). It is not settled: "
    assert first.startswith(outcome) and len(outcome) <= 100
    assert first.endswith("which failed on them (4.3 mm rms; the nominal simulator: 1.9 mm).")
    assert "slack" not in first, "the first names that a reader meets are those of the verdict"
    assert "makes the calibrated simulator worse" not in text and "too short to choose" not in text
    assert "is that of slack, not of friction_hysteresis + creep." in " ".join(text.split())
    assert "misses them by" not in text, "the first line says that it failed"
    why = "Adopt nothing: the names change when the last 30 % of strokes are left out, so none is proved."
    request = "Record the rig once more, with at least 12 strokes, and diagnose all runs together."
    assert f"1. {why} {request} Commands: details.txt, The run to make next." in " ".join(text.split())
    details = " ".join(full(diagnosis).split())
    assert f"The run to make next {request} The commands, in this order; " in details
    assert "python -m pipeline.new_run nylon-3-next --like raw/nylon-3 python -m pipeline.capture PORT" in details
    assert "python -m pipeline.diagnose raw/nylon-3 raw/nylon-3-next --together" in details


def test_what_is_not_proved_is_not_reported_as_at_work() -> None:
    failing = {"evidence__chosen_without_them": ["slack"], "fit__heldout__explained_mm": 4.3}
    details = " ".join(full(confident(0.93, 0.96, **ALONE, **failing)).split())
    named = "friction_hysteresis (probable, 93 %) and creep (probable, 96 %)"
    assert f"- not settled: {named}, for on the unseen strokes slack makes the simulator worse;" in details
    assert "- at work: " not in details


def test_an_effect_that_is_not_named_without_the_last_strokes_is_called_probable_and_the_other_one_sure() -> None:
    diagnosis = confident(0.93, 0.96, **ALONE, evidence__chosen_without_them=["creep"], evidence__moved_sigma={})
    text = told(diagnosis)
    why = "without the last 30 % of strokes other effects are named"
    assert "sure, 96 %" in text and "probable, 93 %" in text
    assert f"friction_hysteresis has 93 %, but is only probable: {why}." in text


def test_of_a_tie_what_is_named_without_the_last_strokes_is_said_to_be_one_of_the_likely_explanations() -> None:
    text = told(content(evidence__chosen_without_them=["friction_hysteresis", "thermal"]))
    other = "the procedure names friction_hysteresis + thermal, another of the 2 likely explanations"
    assert f"{other}, and that misses the unseen strokes by 0.033 mm. friction_hysteresis + " in text
    assert "not settled" not in text


def test_two_errors_in_one_sentence_are_each_of_the_effects_that_they_are_of() -> None:
    text = told(content(fit__heldout__explained_mm=0.3, evidence__chosen_without_them=["creep"]))
    assert "creep, fitted without the unseen strokes, misses them by 9.6 times the noise (1.3 is the limit); " in text
    assert "friction_hysteresis + creep, fitted to all, leaves 1.0 times. So too few strokes were seen, or" in text
    assert "fitted to all strokes, as in the figure" not in text


def test_the_row_of_other_effects_is_no_wider_than_the_page() -> None:
    many = content(evidence__chosen_without_them=["friction_hysteresis", "shaft_windup", "sensor_drift"])
    row = next(line for line in page(many).splitlines() if line.strip().startswith("other effects, see below"))
    assert len(row) <= 112 and "Other effects: friction_hysteresis + sensor_drift + shaft_windup, which" in told(many)


def test_the_recording_to_make_says_how_many_strokes_and_which_load_among_the_first() -> None:
    wider = {"load": [[19.9, 20.1], [19.9, 30.07]], "motion": [[0.0, 20.0], [0.0, 20.0]]}
    failing = {**ALONE, "fit__heldout__explained_mm": 4.3, "evidence__beyond_seen": wider, "evidence__strokes": [1, 5]}
    text = " ".join(page(content(**failing)).split())
    assert "Record the rig once more, with at least 8 strokes (30 N among the first), and diagnose" in text
