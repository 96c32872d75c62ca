"""The line that says what an effect does."""

import pytest
from made_content import content, page, parameter

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named import in_a_line
from pipeline.systems import systems

CALCULATED = "the length follows a temperature that is calculated from the motion, not measured."


@pytest.mark.parametrize(("measured", "line"), [(0.0, CALCULATED), (1.0, "the length follows the temperature.")])
def test_a_temperature_that_nobody_measured_is_said_to_be_none(measured, line) -> None:
    entry = {"id": "thermal", "rms_mm": parameter(0.2, "mm"), "parameters": {"measured": parameter(measured, "")}}
    diagnosis = content(mechanisms=[entry], alternatives=[], verdict="explained", next_run=None)
    diagnosis["evidence"]["explanations"][-1]["ids"] = ["thermal"]
    assert line in " ".join(page(diagnosis).split())


def slip(at_s: float, mm: float) -> dict[str, object]:
    return {"id": "clamp_slip", "parameters": {"at_s": at_s, "within_s": 0.4, "mm": mm}}


def test_of_an_open_effect_that_happens_suddenly_the_page_says_when_and_how_much() -> None:
    """As the explanation that has it holds it; the best one has no size of it."""
    slips = [slip(235.42, -0.0453), slip(30.5, 0.2)]
    rivals = [{"ids": ["clamp_slip", "creep"], "parameters": {}, "simulation": slips}]
    diagnosis = content(alternatives=[["clamp_slip", "creep"]], rivals=rivals)
    line = "the clamp gives way suddenly and for good; if so, by 0.20 mm at 30.5 s and 0.045 mm at 235 s."
    assert line in " ".join(page(diagnosis).split())
    older = content(alternatives=[["clamp_slip", "creep"]])
    assert "the clamp gives way suddenly and for good. " in " ".join(page(older).split())


def test_of_a_named_effect_that_happens_suddenly_the_page_says_the_largest() -> None:
    entry = {"id": "count_slip", "rms_mm": parameter(0.2, "mm"), "parameters": {}}
    steps = [{"id": "count_slip", "parameters": {"at_s": at_s, "turns": -at_s / 100.0}} for at_s in (10, 1234, 20, 30)]
    each = {"id": "count_slip", "parameters": {"at_s": -1.0, "within_s": 0.0, "turns_per_stroke": 0.5}}
    diagnosis = content(
        mechanisms=[entry], alternatives=[], verdict="explained", simulation=[*steps, each], next_run=None
    )
    diagnosis["evidence"]["explanations"][-1]["ids"] = ["count_slip"]
    line = "by 0.50 turns at every stroke, 0.30 turns at 30 s, 12 turns at 1234 s and 2 smaller."
    assert line in " ".join(page(diagnosis).split())


@pytest.mark.parametrize(
    ("sentence", "size", "line"),
    [
        ("Friction opens a loop, by up to 0.57 mm, most near 18 turns (0.18 mm rms).", 0.18, "; here up to 0.57 mm."),
        (
            "Play, by up to 0.56 mm, most near 18 turns (0.18 mm rms): half the play is 0.316 turns (0.305 to 0.327).",
            0.18,
            "; here up to 0.56 mm; half the play is 0.316 turns (0.305 to 0.327).",
        ),
        ("It stays longer, 0.40 mm in all (0.18 mm rms), and no rest.", 0.18, "; here 0.40 mm in all."),
        ("It is late, which is worth 0.18 mm rms at these speeds.", 0.18, ". "),
        ("Friction opens a loop, by up to 0.57 mm, most near 18 turns (0.18 mm rms).", 0.05, ". "),
    ],
)
def test_the_page_says_how_large_an_effect_gets_where_no_dimension_imitates_it(sentence, size, line) -> None:
    """Who designs a rig asks for the largest error, and the page had the rms alone."""
    entry = {"id": "friction_hysteresis", "rms_mm": parameter(0.18, "mm"), "parameters": {}, "sentence": sentence}
    diagnosis = content(mechanisms=[entry], verdict="explained", evidence__moved_sigma={"radius_mm": 0.1})
    diagnosis["evidence"] |= {"beyond_dimensions_mm": {"friction_hysteresis": size}}
    description = in_a_line.of_named(entry, diagnosis, Vocabulary.of(systems()["separator"]))
    assert f"winding and unwinding differ by a rounded loop that grows with load or twist{line}" in f"{description} "


@pytest.mark.parametrize(("id_", "of_what"), [("stick_slip", "of an effect whose every"), ("creep", "on this rig")])
def test_why_no_effect_has_a_percentage_is_said(id_, of_what) -> None:
    """Of jerks on a string it was said that no percentage is known on this rig."""
    diagnosis = content(verdict="explained", alternatives=[], next_run=None)
    diagnosis["mechanisms"] = [{"id": id_, "rms_mm": parameter(0.4, "mm"), "parameters": {}}]
    for entry in diagnosis["evidence"]["explanations"]:
        entry.pop("probability", None)
    assert f"No percentage is known {of_what}" in " ".join(page(diagnosis).split())
