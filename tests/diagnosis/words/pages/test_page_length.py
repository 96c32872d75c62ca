"""The page of a verdict is short, whatever there is to say; the details say each part in full."""

import copy
from pathlib import Path

import pytest
from made_content import SYSTEMS, confident, full, page, spoken

from pipeline.diagnosis.words.language.sections import shortened
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.pages.verdict import LONG, what_first

LINES, WIDE = 66, 120  # of a printed page
ALONE = {"verdict": "explained", "alternatives": [], "next_run": None}
NOTHING = {"verdict": "parameters", "mechanisms": [], "alternatives": [], "next_run": None, "mismatch": None}
UNDER_ANOTHER = {"next_run__title": "one stroke under half the load", "next_run__fixed_load": True}
SEVERAL = [f"raw/nylon-{number}" for number in range(3, 13)]
COLUMN = {"loop_as_before_mm": 0.3, "loop_half_speed_mm": 0.2, "hold_mm": -0.3, "rest_mm": 0.2}
FORETOLD = {"load": 20.0, "speed_per_s": 2.0, "stand_s": 120.0, "explanations": [
    {"ids": ["friction_hysteresis", "creep"], **COLUMN},
    {"ids": ["friction_hysteresis", "thermal"], **COLUMN, "hold_mm": 0.001, "rest_mm": 0.5},
]}  # fmt: skip
COVERED = {"temperature_c": [17.8, 29.9], "load": [20.0, 20.0], "speed_per_s": [2.0, 2.0], "longest_hold_s": 8.4,
           "longest_rest_s": 13.0}  # fmt: skip


def two(**changes):
    """Two effects, hidden in part, on four dimensions that moved far under one load."""
    diagnosis = confident(0.84, 0.38, evidence__nominal_mm=1.1, **changes)
    for entry, mm in zip(diagnosis["mechanisms"], (2.3, 1.9), strict=True):
        entry["rms_mm"] = {"value": mm, "low": 0.3 * mm, "high": 1.1 * mm}
    for name, nominal, value in (("scale", 1.0, 1.01), ("length_mm", 300.0, 295.0), ("separator_mm", 8.0, 9.4)):
        diagnosis["parameters"][name] = {"nominal": nominal, "value": value, "low": value, "high": value}
    diagnosis["evidence"] |= {
        "beyond_dimensions_mm": {"creep": 0.15, "friction_hysteresis": 0.16}, "calibrated_mm": 0.079,
        "moved_sigma": {"radius_mm": 3.0, "scale": 2.9, "length_mm": 3.0, "separator_mm": 2.8},
        "moved_alone_sigma": {"radius_mm": 1.9, "scale": 0.1, "length_mm": 0.2},
        "tolerance": {"radius_mm": 0.0037, "scale": 0.005, "length_mm": 2.0, "separator_mm": 0.5},
        "loaded": False, "step_s": 0.05, "covered": COVERED, "expected": FORETOLD,
        "tops_mm": {"creep": -0.4, "friction_hysteresis": 0.2}, "probability_of_none": 0.11,
        "pattern": {"location": diagnosis["mismatch"]["location"], "driver": ["time"], "rms_mm": 0.02},
    }  # fmt: skip
    return diagnosis


def missing(**changes):
    """The same, where something is still missing that a regression foretells better."""
    diagnosis = two(**changes)
    diagnosis["fit"]["heldout"] |= {"explained_mm": 0.3, "without_physics_mm": 0.05}
    diagnosis["evidence"]["left_of_unseen"] = {"location": diagnosis["mismatch"]["location"], "driver": "direction"}
    return diagnosis


def near(diagnosis):
    """The same on dimensions that stayed."""
    diagnosis["evidence"]["moved_sigma"] = {"radius_mm": 0.4}
    return diagnosis


def adopted(**changes):
    """A verdict on a simulator with adopted effects, of which others were likely as well."""
    diagnosis = two(**changes)
    run = {"next_experiment": "One stroke under half the load: 30 s in all.", "tied": [["thermal"], ["wear"], ["jam"]]}
    diagnosis["adopted"] = [{"effects": ["jam"], "verdict": "ambiguous", "runs": ["nylon-3"], **run}]
    diagnosis["evidence"]["adopted_effects"] = []
    return diagnosis


def nothing_further():
    """After adopting, nothing further, on dimensions that moved far."""
    diagnosis = adopted(**ALONE) | NOTHING
    diagnosis["evidence"] |= {"explanations": [], "adopted_mm": 0.4}
    return diagnosis | {"simulation": [{"id": "jam", "parameters": {}}]}


def of_several(diagnosis):
    """A diagnosis of ten recordings, each with a zero of its own that moved far."""
    diagnosis["run"] = [Path(folder).name for folder in SEVERAL]
    for number in range(1, 11):
        diagnosis["parameters"][f"angle_turns_{number}"] = {"nominal": 0.0, "value": 0.1, "low": 0.1, "high": 0.1}
        diagnosis["evidence"]["moved_sigma"][f"angle_turns_{number}"] = 2.9
        diagnosis["evidence"]["tolerance"][f"angle_turns_{number}"] = 0.03
    return diagnosis


CASES = {
    "two effects that tie": lambda: two(),
    "two effects alone": lambda: two(**ALONE),
    "two effects, dimensions near": lambda: near(two(**ALONE)),
    "a tie with something missing": lambda: missing(),
    "something missing": lambda: missing(**ALONE),
    "something missing, dimensions near": lambda: near(missing(**ALONE)),
    "beside adopted effects": lambda: adopted(),
    "something missing beside adopted effects": lambda: adopted(**ALONE, fit__heldout__explained_mm=0.5),
    "nothing beside adopted effects": nothing_further,
    "several recordings": lambda: of_several(two()),
    "several recordings, one explanation": lambda: of_several(missing(**ALONE)),
    "several recordings, adopted effects": lambda: of_several(nothing_further()),
    "a run under another load": lambda: two(**UNDER_ANOTHER),
    "several recordings, a run under another load": lambda: of_several(missing(**UNDER_ANOTHER)),
    "unknown": lambda: missing() | {"verdict": "unknown", "mechanisms": [], "alternatives": [], "next_run": None},
}  # fmt: skip


def folders(diagnosis):
    return SEVERAL if isinstance(diagnosis["run"], list) else SEVERAL[:1]


@pytest.mark.parametrize("case", CASES)
def test_the_page_is_short_and_narrow_whatever_there_is_to_say(case):
    diagnosis = CASES[case]()
    text = page(copy.deepcopy(diagnosis), folders=folders(diagnosis))
    lines = text.splitlines()
    assert len(lines) <= LINES, f"{len(lines)} lines:\n{text}"
    assert not [line for line in lines if len(line) > WIDE and "python -m" not in line]
    headline = " ".join(text.partition("\n\n")[0].split())
    assert headline.endswith((".", ")")) and "What" not in headline, "reports show what stands before the empty line"


@pytest.mark.parametrize("case", CASES)
def test_the_page_names_each_effect_with_how_sure_it_is_and_how_large_and_the_details_say_what_it_does(case):
    diagnosis = CASES[case]()
    text, more = (show(copy.deepcopy(diagnosis), folders=folders(diagnosis)) for show in (page, full))
    for entry in spoken(diagnosis, SYSTEMS["mm"])["mechanisms"]:
        rows = text.partition("What acts")[2].splitlines()
        row = next(line for line in rows if line.strip().startswith(f"{entry['id']} "))
        assert f"{round(100 * entry['confidence'])} %" in row and " mm (" in row
        assert entry["sentence"] in " ".join(more.split())
    probabilities = {explanation.get("probability") for explanation in diagnosis["evidence"]["explanations"]} - {None}
    if diagnosis["mechanisms"] and probabilities:
        assert "physics that the library lacks" in more
    assert "unseen strokes" in text or "last 30 % of strokes" in text


def test_a_doubt_is_told_by_its_first_sentences_on_the_page_and_whole_in_the_details():
    line = f"First {40 * 'word '}ends. Second {20 * 'word '}ends. Third ends."
    first, second, _ = line.split(". ")
    assert shortened(line, 10) == f"{first}.", "the first one in any case"
    assert shortened(line, 330) == f"{first}. {second}." and shortened(line, 400) == line
    diagnosis = missing(**ALONE)
    for doubt in what_first(spoken(diagnosis, SYSTEMS["mm"]), Vocabulary.of(SYSTEMS["mm"])):
        assert doubt in " ".join(full(copy.deepcopy(diagnosis)).split())
        assert shortened(doubt, LONG) in " ".join(page(copy.deepcopy(diagnosis)).split())
