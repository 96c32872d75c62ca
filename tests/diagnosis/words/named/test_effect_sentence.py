"""What acts, in sentences: size, reach, loop, time constants, events."""

import copy
import re

import pytest
from made_content import SYSTEMS, content, parameter, told, weighed

from pipeline.diagnosis.mechanisms.interface import Mechanism
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.system_units import Units
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named import effect_sentence
from pipeline.diagnosis.words.pages.spoken import spoken
from pipeline.systems import systems


def test_sentences_say_size_reach_and_what_was_found():
    diagnosis = spoken(content(), SYSTEMS["mm"])
    friction, creep = (entry["sentence"] for entry in diagnosis["mechanisms"])
    assert friction == (
        "Friction makes the displacement of winding differ from that of unwinding, by 0.20 mm from the lowest to "
        "the highest value (0.082 mm rms): half the loop is 0.101 mm (0.0909 to 0.111)."
    )
    assert "by up to 0.90 mm (0.41 mm rms), best with time constants of 15 s to 60 s of those that were tried" in creep


def test_each_size_comes_with_its_interval_or_with_why_it_has_none():
    diagnosis = content()
    text = told(copy.deepcopy(diagnosis))
    assert "half the loop is 0.101 mm (0.0909 to 0.111)." in text and "its size, rms (90 % interval)" in text
    assert "0.082 mm (0.074 to 0.090 mm)" in text and "All hold if friction_hysteresis + creep is right." in text
    diagnosis["mechanisms"][0]["rms_mm"] |= {"low": 0.0822, "high": 0.0822}
    assert "friction_hysteresis without an interval: the fit gives it one value alone." in told(diagnosis)


def test_every_mechanism_of_the_library_has_a_sentence_on_every_rig(problem):
    for system in systems().values():
        words, units = Vocabulary.of(system), Units.of(system)
        for mechanism in mechanisms().values():
            for nonlinear in mechanism.candidates(problem.drivers)[:40:7]:
                names = [*nonlinear, *(term.name for term in mechanism.terms(problem.drivers, nonlinear))]
                parameters = {units.name(name): parameter(0.21, units.unit("mm")) for name in names}
                entry = {
                    "id": mechanism.id,
                    f"rms_{words.ending}": parameter(0.3, words.unit),
                    "parameters": parameters,
                }
                sentence = effect_sentence.sentence(mechanism, entry, 0.7, words, units)
                assert sentence.endswith(".") and not re.search(r"[{}]|  |\.\.|, \.", sentence), sentence
                assert re.search(rf"0\.(30|70) {words.unit}", sentence), sentence


@pytest.mark.parametrize(
    ("opened", "expected"),
    [
        (
            {"width_mm": 0.058, "motor_turns": 16.2},
            "that of unwinding, by up to 0.058 mm, most near 16 turns (0.030 mm",
        ),
        (None, "that of unwinding, by 0.077 mm from the lowest to the highest value (0.030 mm rms)"),
    ],
)
def test_how_far_winding_and_unwinding_part_is_told_at_one_twist_or_the_span_is_called_what_it_is(opened, expected):
    diagnosis = content(mechanisms=[{"id": "friction_hysteresis", "rms_mm": parameter(0.03, "mm"), "parameters": {}}])
    diagnosis["evidence"]["spans_mm"]["friction_hysteresis"] = 0.077
    diagnosis["evidence"] |= {"loops": {"friction_hysteresis": opened}} if opened else {}
    assert expected in told(diagnosis)


@pytest.mark.parametrize("id_", ["friction_hysteresis", "backlash"])
def test_no_sentence_calls_the_span_of_an_effect_the_difference_between_winding_and_unwinding(id_):
    assert "{loop}" in mechanisms()[id_].sentence and "{span}" not in mechanisms()[id_].sentence


def test_an_effect_far_larger_than_the_mismatch_is_said_to_hide_in_the_dimensions():
    diagnosis = content()
    diagnosis["mechanisms"][1]["rms_mm"]["value"] = 3.52
    rest = "than the 0.44 mm that is missing. Moved dimensions or other effects take the rest back"
    assert f"Mostly hidden: it is far larger {rest}." in told(diagnosis) and "hidden" not in told()
    diagnosis["mechanisms"][1]["rms_mm"]["value"] = 0.6
    text = " ".join(told(diagnosis).split())
    assert f"Partly hidden: it is more {rest}" in text and "0.60 mm" in text and "poorly known" not in text
    diagnosis["evidence"] |= {"moved_sigma": {"radius_mm": 0.7}, "tolerance": {"radius_mm": 0.016}}
    moved = told(diagnosis).partition("\nDimensions\n")[2].partition("\n\n")[0]
    head, row, *rest = moved.splitlines()
    assert head.split("   ")[0].strip() == "dimension" and "calibrated (90 % interval)" in head
    assert re.split(" {2,}", row.strip()) == [
        "radius", "0.55 mm", "0.561 mm (0.56 to 0.563)", "0.016 mm (2.91 %)", "0.70 (+2 %)",
    ]  # fmt: skip
    assert rest == [
        "  `moved by` counts tolerances; in brackets: per cent of the value before.",
        "  Every dimension stays within its tolerance.",
        "  Now in force, as run.yaml writes it: `tolerance: {radius: 0.02909}` (radius is a share of the value: "
        "0.02909 is 2.91 %).",
    ]
    diagnosis["mechanisms"][1]["rms_mm"]["value"] = 0.4
    assert "\nDimensions\n  dimension   as measured" in told(diagnosis), "also where no effect is hidden in them"


def exact(value, unit):
    """A parameter that was chosen from a few: it has no interval."""
    return {"value": value, "low": value, "high": value, "unit": unit}


def test_events_are_told_one_by_one():
    parameters = {"at_s": exact(102.3, "s"), "mm": parameter(0.44, "mm"), "at_s_2": exact(211.0, "s"),
             "mm_2": exact(0.2, "mm")}  # fmt: skip
    entry = {"id": "clamp_slip", "rms_mm": parameter(0.3, "mm"), "parameters": parameters}
    diagnosis = spoken(content(mechanisms=[entry]), SYSTEMS["mm"])
    assert diagnosis["mechanisms"][0]["sentence"].endswith(
        ": by 0.44 mm (0.396 to 0.484) after 102 s and by 0.2 mm after 211 s."
    ), "a value with an interval has it beside it"


def test_events_are_told_in_the_order_of_time():
    """The search finds the largest first: the slips stood as after 8.93 s, 67.9 s, 147 s and 16.3 s."""
    words, units = Vocabulary.of(SYSTEMS["mm"]), Units.of(SYSTEMS["mm"])
    slips = {"": (211.0, 0.4), "_2": (9.5, 0.2), "_3": (67.9, 0.3)}
    for id_, size, unit, by in (("clamp_slip", "mm", "mm", "by "), ("count_slip", "turns", "turns", "")):
        parameters = {f"at_s{end}": exact(at_s, "s") for end, (at_s, _) in slips.items()}
        parameters |= {f"{size}{end}": exact(value, unit) for end, (_, value) in slips.items()}
        assert effect_sentence.details(mechanisms()[id_], parameters, words, units) == (
            f"{by}0.2 {unit} after 9.5 s, {by}0.3 {unit} after 67.9 s and {by}0.4 {unit} after 211 s"
        )


def test_a_mechanism_of_ones_own_may_say_no_more_than_its_size():
    own = Mechanism("x_own", "speed", "", "", "", "", "Air brakes the motion, by {size}.", lambda _: [], lambda *_: [])
    entry = {"id": "x_own", "rms_mm": parameter(0.3, "mm"), "parameters": {}}
    words = Vocabulary.of(SYSTEMS["mm"])
    sentence = effect_sentence.sentence(own, entry, None, words, Units.of(SYSTEMS["mm"]))
    assert sentence == "Air brakes the motion, by 0.30 mm rms."


@pytest.mark.parametrize(
    ("measured", "expected"), [(0.0, "a temperature that is calculated"), (1.0, "the measured temp")]
)
def test_a_calculated_temperature_is_not_told_as_a_measured_one(measured, expected):
    parameters = {"measured": parameter(measured, "1"), "friction_30_s_mm": parameter(0.1, "mm")}
    entry = {"id": "thermal", "rms_mm": parameter(0.018, "mm"), "parameters": parameters}
    changes = {"mismatch__driver": ["temperature"], "mismatch__rms_mm": 0.0068}
    text = told(content(verdict="explained", mechanisms=[entry], alternatives=[], next_run=None, **changes))
    assert f"The length follows {expected}" in text and "The effect is smaller than the noise of one" in text
    assert ("What is missing follows a temperature that is calculated from how fast" in text) == (not measured)
    assert "smaller than the noise" not in told()


@pytest.mark.parametrize(("slowest", "is_bound"), [(60.0, True), (240.0, False)])
def test_a_time_constant_that_is_the_longest_tried_is_told_as_a_bound(slowest, is_bound):
    diagnosis = content()
    diagnosis["mechanisms"][1]["parameters"]["slowest_s"] = parameter(slowest, "s")
    assert (
        "15 s to 60 s or longer (the longest that was tried: a recording of this length" in told(diagnosis)
    ) is is_bound
    assert ("15 s to 60 s of those that were tried" in told(diagnosis)) is not is_bound


def test_effects_that_work_against_each_other_more_are_said_to():
    diagnosis = weighed(0.004, 0.06, 0.26, 0.02, 0.52)
    diagnosis["evidence"]["explanations"][3]["because"] = [{"aspect": "cancels", "log_odds": -0.9, "more": 0.19565}]
    reason = "work against each other more."
    assert f"{reason[:-1]} (no. 2)" in " ".join(told(diagnosis).split())


def test_an_effect_without_a_constant_to_report_says_why() -> None:
    """A page reported a loss without a constant, and no word said why."""
    bare = {"id": "viscous_loss", "sentence": "A loss follows the speed: 114 N s/m."}
    assert effect_sentence.has_constants({"sentence": "A loss follows the speed: 114 N s/m (110 to 118)."}), (
        "a unit of two words"
    )
    parts = {"id": "sensor_lag", "sentence": "The reading is late, which is worth 0.044 mm rms."}
    with_constant = {"id": "friction_hysteresis", "sentence": "A loop: half the loop is 0.108 mm (0.0985 to 0.111)."}
    lines = effect_sentence.no_constants([bare, parts, with_constant])
    assert lines == [
        "Of viscous_loss there is no constant to report: the fit gives its constant no interval.",
        "Of sensor_lag there is no constant to report: the fit knows what its parts do together, not each part.",
    ]
    assert effect_sentence.no_constants([with_constant]) == []
