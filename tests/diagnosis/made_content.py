"""A diagnosis as `diagnosis.json` holds it before its words, for the tests of the words; and these words of it."""

import copy
import re
from pathlib import Path

from pipeline.diagnosis.words.pages.details import details_text
from pipeline.diagnosis.words.pages.spoken import spoken
from pipeline.diagnosis.words.pages.verdict import verdict_text
from pipeline.systems import systems

SYSTEMS = {"mm": systems()["separator"], "deg": systems()["cable_drive"], "n": systems()["moving_mass"]}


def leg(seconds, to, load, driver="motor_turns", load_name="load_n"):
    return {"seconds": seconds, driver: to, load_name: load}


def explanation(ids, standing, left_mm, bent=None, worse=100.0, driver="time", place=(0.0, 12.2)):
    entry = {"ids": ids, "standing": standing, "left_mm": left_mm, "with_discrepancy_mm": bent or left_mm}
    if standing in ("tied", "beaten"):
        box = {"motor_turns": list(place), "strokes": [2, 4], "phase": "rest", "share": 0.82}
        entry |= {"worse": worse, "gap_mm": 0.07, "location": box, "driver": driver}
    return entry


def parameter(value, unit):
    return {"value": value, "low": 0.9 * value, "high": 1.1 * value, "unit": unit}


CONTENT = {
    "run": "nylon-3", "verdict": "ambiguous",
    "mismatch": {
        "rms_mm": 0.44, "driver": ["direction x load", "time under load"],
        "location": {"motor_turns": [0.002, 12.04], "strokes": [2, 9], "phase": "winding", "share": 0.834},
    },
    "mechanisms": [
        {"id": "friction_hysteresis", "rms_mm": parameter(0.0822, "mm"), "parameters": {
            "half_loop_mm": parameter(0.101, "mm"), "sharp_mm": parameter(0.1, "mm")}},
        {"id": "creep", "rms_mm": parameter(0.41, "mm"), "parameters": {
            "load_15_s_mm_per_10_n": parameter(0.3, "mm/10N"), "load_60_s_mm_per_10_n": parameter(0.2, "mm/10N")}},
    ],
    "alternatives": [["friction_hysteresis", "thermal"]],
    "next_experiment": None,
    "next_run": {
        "title": "a hold at full twist, then a rest", "from": 4.0, "load": 20.0, "fixed_load": False,
        "legs": [leg(2.0, -0.000488, 20.02), leg(0.5, -0.000488, 19.9), leg(16.5, 30.671, 19.9),
                 leg(60.0, 30.671, 19.9), leg(16.5, -0.000488, 19.9), leg(120.0, -0.000488, 19.9)],
        "parts": [["friction_hysteresis", "creep"], ["friction_hysteresis", "thermal"]],
        "gap_now": 5.02, "gap_then": 5330.0,
    },
    "parameters": {"radius_mm": {"nominal": 0.55, "value": 0.5612, "low": 0.56, "high": 0.563}},
    "fit": {
        "noise_floor_mm": 0.0312, "detectable_mm": {"creep": 0.02, "backlash": 0.004},
        "heldout": {"split": "last 30 % of strokes", "nominal_mm": 1.92, "calibrated_mm": 0.81, "explained_mm": 0.033},
    },
    "evidence": {
        "floor_mm": 0.03, "motor_turns": [-0.0005, 30.7], "strokes": [1, 12], "loaded": True,
        "spans_mm": {"friction_hysteresis": 0.2, "creep": 0.9}, "moved_sigma": {"radius_mm": 2.9},
        "explanations": [
            explanation([], "nothing", 0.45),
            explanation(["creep"], "beaten", 0.06),
            explanation(["friction_hysteresis", "sensor_drift"], "beaten", 0.0304, worse=400.0, driver=None),
            explanation(["friction_hysteresis", "thermal"], "tied", 0.07, bent=0.0305),
            explanation(["friction_hysteresis", "creep", "wear"], "not needed", 0.0299),
            explanation(["friction_hysteresis", "creep"], "named", 0.03),
        ],
    },
}  # fmt: skip


def content(**changes):
    """A diagnosis before its words; `changes` by dotted path, a double underscore for each dot."""
    diagnosis = copy.deepcopy(CONTENT)
    for path, value in changes.items():
        *parents, last = path.split("__")
        place = diagnosis
        for key in parents:
            place = place[key]
        place[last] = value
    return diagnosis


def told(diagnosis=None, folders=("raw/nylon-3",), system="mm"):
    """The details as a person reads them, with their lines joined again where they were wrapped."""
    diagnosis = spoken(diagnosis or content(), SYSTEMS[system])
    return re.sub(
        r"\n {4,}(?=\S)(?!\d\. |python)", " ", details_text(diagnosis, SYSTEMS[system], [Path(f) for f in folders])
    )


def page(diagnosis=None, folders=("raw/nylon-3",), system="mm", out="reports/nylon-3", doubts=()):
    """The page of the verdict, line by line as it is printed."""
    diagnosis = spoken(diagnosis or content(), SYSTEMS[system])
    return verdict_text(diagnosis, SYSTEMS[system], [Path(f) for f in folders], Path(out) if out else None, doubts)


def full(diagnosis=None, folders=("raw/nylon-3",), system="mm", out="reports/nylon-3", doubts=()):
    """The details, line by line as they are printed: each part of the page in full, and its reasons."""
    diagnosis = spoken(diagnosis or content(), SYSTEMS[system])
    return details_text(diagnosis, SYSTEMS[system], [Path(f) for f in folders], Path(out) if out else None, doubts)


def weighed(*shares, none=0.041, **changes):
    """A verdict with the probability of each explanation of CONTENT from the second on, the best one last."""
    diagnosis = content(**changes)
    for entry, share in zip(diagnosis["evidence"]["explanations"][1:], shares, strict=True):
        entry["probability"] = share
    diagnosis["evidence"]["probability_of_none"] = none
    return diagnosis


def confident(friction, creep, **changes):
    """A verdict with the confidence of both of its effects."""
    diagnosis = weighed(0.004, 0.06, 0.31, 0.02, 0.52, **changes)
    for entry, share in zip(diagnosis["mechanisms"], (friction, creep), strict=True):
        entry["confidence"] = share
    return diagnosis


def adopted(verdict="parameters", **changes):
    """The words on a run that has adopted creep, whose dimensions alone were then asked."""
    diagnosis = content(verdict=verdict, mechanisms=[], alternatives=[], next_run=None, mismatch=None, **changes)
    diagnosis["simulation"] = [{"id": "creep", "parameters": {}}]
    diagnosis["evidence"]["explanations"] = []
    return told(diagnosis)


def to_adopt(**changes):
    """What is said of adopting, from the JSON that lies in reports/nylon-3."""
    diagnosis = spoken(content(**changes), SYSTEMS["mm"])
    text = details_text(diagnosis, SYSTEMS["mm"], [Path("raw/nylon-3")], Path("reports/nylon-3"))
    return text.partition("To use it\n")[2].partition("\n\n")[0]


LEFT = {
    "evidence__floor_mm": 0.0203, "evidence__nominal_mm": 0.0529, "evidence__calibrated_mm": 0.0517,
    "fit__noise_floor_mm": 0.0203, "fit__heldout__nominal_mm": 0.0596, "fit__heldout__calibrated_mm": 0.0576,
    "fit__heldout__explained_mm": 0.0576, "fit__detectable_mm": {"clamp_slip": 0.0057, "slack": 0.107},
    "evidence__moved_sigma": {"radius_mm": -3.0}, "evidence__tolerance": {"radius_mm": 0.0165},
}  # fmt: skip
