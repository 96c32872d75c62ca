"""Tolerances, as run.yaml writes them."""

import re
from types import SimpleNamespace

import pytest
import yaml
from made_content import CONTENT, content, told

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured import in_run_yaml, tolerances
from pipeline.systems import systems


def test_a_value_that_run_yaml_does_not_hold_was_assumed_and_a_tolerance_is_shown():
    known = {"nominal": 1.0, "value": 0.9861, "low": 0.98, "high": 0.99}
    turned = {"nominal": 0.0, "value": 0.15, "low": 0.1, "high": 0.2}
    changes = {
        "parameters": {"scale": known, "angle_turns": turned, "radius_mm": CONTENT["parameters"]["radius_mm"]},
        "evidence__moved_sigma": {"scale": -2.78, "angle_turns": 3.0, "radius_mm": 2.9},
        "evidence__tolerance": {"scale": 0.005, "angle_turns": 0.05, "radius_mm": 0.0165},
    }
    text = told(content(**changes))
    for name, exactly, values, away in (
        ("gain of the displacement sensor", "0.0046", "1 was assumed, but 0.986", "2.8 times its tolerance of 0.5 %"),
        (
            "zero of the motor",
            "0.05 turns",
            "0 turns was assumed, but 0.15 turns",
            "3.0 times its tolerance of 0.05 tu",
        ),
        (
            "radius again",
            "0.0037 mm",
            "run.yaml says 0.55 mm, but 0.561 mm",
            "2.9 times its tolerance of 0.017 mm (3 %)",
        ),
    ):
        assert re.search(
            re.escape(f"Measure the {name}, to {exactly} or better: {values} fits best (90 % interval "), text
        )
        assert f"), {away}" in text
    assert "Intervals are those of the fit: they may reach beyond what calibration may do." in text
    assert "run.yaml says 1," not in text and "run.yaml says 0 turns" not in text
    bare = {"verdict": "parameters", "mechanisms": [], "alternatives": [], "next_run": None}
    text = told(content(**changes, **bare))
    assert "zero of the motor" in text and "(assumed) to" not in text, "told once: measure it"
    changes["evidence__moved_sigma"] = {"scale": -1.2, "angle_turns": 1.5, "radius_mm": 0.5}
    text = told(content(**changes, **bare))
    turned = "zero of the motor: from 0 turns (assumed) to 0.15 turns (90 % interval 0.1 to 0.2 turns), 1.5 times its"
    assert f"{turned} tolerance of 0.05 turns." in text


def test_how_run_yaml_says_a_tolerance_and_a_gain_is_told():
    again = ["scale", "separator_mm_2", "stiffness_n_per_mm"]
    fits = {"scale": {"nominal": 1.0, "value": 0.985}}
    (gain,) = in_run_yaml.lines({"evidence": {}, "parameters": fits}, again)
    assert "`tolerance: {scale: …, separator_mm: …}` (docs/import.md). If you measured the sensor's gain" in gain
    written = re.search(r"then write `(channels: .*?}})`", gain)[1]
    assert yaml.safe_load(written) == {"channels": {"displacement_mm": {"scale": 1.015}}}, "the inverse of what fits"
    assert in_run_yaml.lines({}, ["stiffness_n_per_mm"]) == [], "a stiffness has no tolerance"


def test_the_details_say_how_to_write_all_that_the_page_asks_to_measure():
    made = content(evidence__moved_sigma={"radius_mm": 2.9, "length_mm": -2.2, "scale": 1.0})
    made["parameters"] |= {name: {"nominal": 300.0, "value": 295.6} for name in ("length_mm", "scale")}
    assert "a tolerance is written as `tolerance: {radius: …, length_mm: …}` (docs/import.md)." in told(made)


def test_tolerances_stand_in_the_keys_and_units_of_run_yaml_and_a_length_in_place_of_a_share_is_told():
    known = {"radius_mm": {"nominal": 0.4, "value": 0.436}, "scale": {"nominal": 1.0, "value": 1.01}}
    known |= {"separator_mm": {"nominal": 8.0, "value": 8.2}}
    sigmas = {"radius_mm": 0.012, "separator_mm": 0.5, "scale": 0.005}
    made = content(parameters=known, evidence__tolerance=sigmas)
    block = "`tolerance: {radius: 0.03, separator_mm: 0.5, scale: 0.005}`"
    text = told(made)
    assert (
        f"Now in force, as run.yaml writes it: {block} (radius and scale are shares of the value: 0.03 is 3 %)." in text
    )
    assert yaml.safe_load(block.strip("`")) == {"tolerance": {"radius": 0.03, "separator_mm": 0.5, "scale": 0.005}}
    assert "takes care to measure by hand" not in text
    assert "All are defaults, taken where run.yaml says nothing." in " ".join(text.split())
    made["evidence"]["tolerance"]["radius_mm"] = 0.012 * 0.4
    first = told(made).partition("What is missing")[0]
    assert "That is a share: 1.2 % of 0.4 mm, or 0.0048 mm, which takes care to measure by hand." in first
    assert "If 0.012 mm was meant, write radius: 0.03 and diagnose again." in first
    assert "separator_mm and scale are defaults, taken" in " ".join(told(made).split())
    thin = {"radius_mm": {"nominal": 0.1, "value": 0.1}}
    near = content(parameters=thin, evidence__tolerance={"radius_mm": 0.003}, evidence__moved_sigma={})
    assert "by hand" not in told(near), "the default"


@pytest.mark.parametrize("name", sorted(systems()))
def test_a_tolerance_is_a_share_exactly_where_a_rig_takes_it_for_one(name):
    system = systems()[name]
    string = SimpleNamespace(radius_mm=0.4, length_mm=400.0, stiffness_n_per_mm=15.0)
    run = SimpleNamespace(string=string, rig={key: 7.0 for key in {**system.rig, **system.optional_rig}}, tolerance={})
    shares = Vocabulary.of(system).shares
    for one in system.parameters(run):
        key = tolerances.key_of(one.name)
        if key in system.tolerance:
            usual = system.tolerance[key]
            assert one.sigma == pytest.approx(usual * abs(one.nominal) if key in shares else usual), one.name
