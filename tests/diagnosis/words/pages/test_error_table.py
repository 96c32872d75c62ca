"""The table of errors."""

import re

from made_content import content, page, told

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.pages import error_table
from pipeline.systems import systems


def test_each_number_says_what_it_is_of_and_calibration_leaves_the_same_everywhere():
    text = told(content(evidence__calibrated_mm=0.4410, evidence__floor_mm=0.018))
    assert (
        "Over the whole recording 0.44 mm rms is missing after calibration (noise taken off), 24 times the noise."
        in text
    )
    assert "0.018 mm, of averages  " in text
    averaged = told(content(evidence__floor_mm=0.018, evidence__step_s=0.05))
    assert "0.018 mm, of averages of 0.05 s" in averaged
    assert re.search(r"–    calibration alone +0\.44 mm \(25\)", text) and "0.44 mm (25 times the noise)" in text
    assert "0.031 mm, of single samples" in text and "single samples" not in told()
    single = "Of single samples, as pipeline.simulate and pipeline.adopt count, 0.030 mm would be about 0.039 mm."
    noise = "The left column is of averages: their noise is `the noise` elsewhere on this page."
    assert f"{noise} {single}" in averaged


def test_where_nothing_is_named_the_last_error_keeps_its_row_and_says_of_what_it_is():
    """Without the last strokes effects were named, or came closest: what they err by was on no page once."""
    diagnosis = content(verdict="unknown", mechanisms=[], alternatives=[])
    diagnosis["evidence"]["explanations"] = [each for each in diagnosis["evidence"]["explanations"] if not each["ids"]]
    diagnosis["fit"]["heldout"] |= {"calibrated_mm": 0.4, "explained_mm": 0.123}
    words = Vocabulary.of(systems()["separator"])
    diagnosis["evidence"] |= {"chosen_without_them": ["creep"]}
    (row,) = [line for line in error_table.lines(diagnosis, words) if "0.12 mm" in line]
    assert row.startswith("as diagnosed")
    diagnosis["evidence"] |= {"chosen_without_them": [], "closest_without_them": ["creep"]}
    (row,) = [line for line in error_table.lines(diagnosis, words) if "0.12 mm" in line]
    assert row.startswith("closest, no name: creep")


def test_the_named_effects_have_the_ordinary_row_where_they_come_closest_without_the_last_strokes():
    """`other effects, see below` stood above the error of the very effects that are named."""
    diagnosis = content(evidence__chosen_without_them=[])
    diagnosis["fit"]["heldout"]["explained_mm"] = 0.123
    diagnosis["evidence"]["closest_without_them"] = ["creep", "friction_hysteresis"]  # the verdict has the other order
    short, long = page(diagnosis), told(diagnosis)
    for text, called in ((short, "as diagnosed: effects added"), (long, "as diagnosed")):
        (row,) = [line.strip() for line in text.splitlines() if "0.12 mm (" in line and "   " in line.strip()]
        assert re.match(rf"{called}  +0.030 mm \(1.0 times the noise\)  +0.12 mm \(", row)
        assert "other effects, see below" not in text
        same = "the right column has the error of the same effects, fitted without them, which come closest there."
        assert f"Without these strokes the procedure names no effect: {same}" in " ".join(text.split())
    diagnosis["evidence"]["closest_without_them"] = ["creep", "slack"]
    (row,) = [line for line in page(diagnosis).splitlines() if "0.12 mm (" in line and "   " in line.strip()]
    assert row.strip().startswith("creep + slack, see below")


def test_a_rig_that_is_scored_in_averages_says_so_in_both_columns_with_the_noise_of_single_samples():
    """`0.070 deg` of averages stood without a word beside the `0.10 deg` of single samples that adopt counts."""
    averages = {"scored_step_s": 0.02, "step_s": 0.02, "single_floor_mm": 0.095}
    diagnosis = content(**{f"evidence__{key}": value for key, value in averages.items()}, fit__noise_floor_mm=0.03)
    noise = "0.030 mm, of averages of 0.02 s"
    assert re.search(rf"noise +{noise} +{noise}", told(diagnosis))
    single = "count, the noise is 0.095 mm, and 0.030 mm would be about 0.095 mm."
    assert "Both columns are of averages: their noise is `the noise` elsewhere on this page." in told(diagnosis)
    assert single in told(diagnosis)
    short = " ".join(page(diagnosis).split())
    assert "The noise of single samples, which pipeline.simulate and pipeline.adopt count, is 0.095 mm." in short
    assert f"noise: about the least possible {noise} {noise}" in short


def test_noise_above_an_error_is_no_least_possible_one_but_an_estimate_that_is_too_large():
    """0.014 mm on unseen strokes, 0.64 times the noise, stood above "noise: about the least possible 0.022 mm"."""
    diagnosis = content(fit__noise_floor_mm=0.022)
    diagnosis["fit"]["heldout"]["explained_mm"] = 0.014
    short, details = " ".join(page(diagnosis).split()), told(diagnosis)
    assert "noise: an estimate, too large here 0.030 mm" in short and "least possible" not in short
    remark = "An error below the noise: the noise was estimated too large, or these samples have less of it."
    assert remark in details
    diagnosis["fit"]["heldout"]["explained_mm"] = 0.0205
    assert "noise: about the least possible" in page(diagnosis) and remark not in told(diagnosis), "chance"
