"""An effect that came out as nothing is no name."""

import re

from made_content import SYSTEMS, content, parameter, to_adopt, told

from pipeline.diagnosis.facts.zero_effects import without_zero_effects
from pipeline.diagnosis.words.pages.spoken import spoken


def test_a_mechanism_that_came_out_as_nothing_says_so():
    diagnosis = content(mechanisms=[{"id": "creep", "rms_mm": parameter(0.0, "mm"), "parameters": {}}])
    sentence = spoken(diagnosis, SYSTEMS["mm"])["mechanisms"][0]["sentence"]
    assert (
        "the exact fit of everything together gives it a strength of 0. So nothing shows that it is at work."
        in sentence
    )


def idle_beside_friction(**changes):
    """A diagnosis that names friction and creep, of which creep came out with no strength."""
    diagnosis = content(**changes)
    diagnosis["mechanisms"][1]["rms_mm"] = parameter(0.0, "mm")
    diagnosis["simulation"] = [{"id": id_, "parameters": {}} for id_ in ("friction_hysteresis", "creep")]
    return without_zero_effects(diagnosis, "mm")


def test_a_mechanism_without_strength_is_not_named_adopted_or_shared_and_the_verdict_says_why():
    diagnosis = idle_beside_friction(alternatives=[["friction_hysteresis", "creep", "wear"], ["friction_hysteresis"]])
    assert [entry["id"] for entry in diagnosis["mechanisms"]] == ["friction_hysteresis"]
    assert [entry["id"] for entry in diagnosis["simulation"]] == ["friction_hysteresis"]
    assert (
        diagnosis["alternatives"] == [["friction_hysteresis", "creep", "wear"]] and diagnosis["verdict"] == "ambiguous"
    )
    text = told(diagnosis)
    assert "creep was tried as well and is not named. The search's first fit" in text
    assert "creep follows" not in text and "What is missing follows the direction of motion and the load." in text
    assert "friction_hysteresis is in both likely explanations" in " ".join(text.split())
    assert re.search(r"\n +1 +friction_hysteresis +0\.030 mm \(1\.0\)", text)


def test_an_explanation_that_is_the_best_one_without_its_idle_part_ties_no_more():
    diagnosis = idle_beside_friction(alternatives=[["friction_hysteresis"]])
    assert diagnosis["verdict"] == "explained" and not diagnosis["alternatives"] and diagnosis["next_run"] is None
    alone = content(mechanisms=[{"id": "creep", "rms_mm": parameter(0.0, "mm"), "parameters": {}}])
    alone["simulation"] = [{"id": "creep", "parameters": {}}]
    assert without_zero_effects(alone, "mm") == alone | {"simulation": []}
    whole = content() | {"simulation": [{"id": "creep", "parameters": {}}]}
    assert without_zero_effects(whole, "mm") == whole
    assert not to_adopt(simulation=[])
