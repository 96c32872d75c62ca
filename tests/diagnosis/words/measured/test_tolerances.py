"""Tolerances, as run.yaml writes them."""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml
from made_content import CONTENT, content, full, page, told
from made_recording import content as described

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured import in_run_yaml, tolerances
from pipeline.ground.input.strict_yaml import parse_yaml
from pipeline.run.description import parse_run
from pipeline.systems import systems


def test_a_value_that_run_yaml_does_not_hold_was_assumed_and_a_tolerance_is_shown():
    gain = {"nominal": 1.0, "value": 0.9861, "low": 0.98, "high": 0.99}
    turned = {"nominal": 0.0, "value": 0.15, "low": 0.1, "high": 0.2}
    changes = {
        "parameters": {"scale": gain, "angle_turns": turned, "radius_mm": CONTENT["parameters"]["radius_mm"]},
        "evidence__moved_sigma": {"scale": -2.78, "angle_turns": 3.0, "radius_mm": 2.9},
        "evidence__tolerance": {"scale": 0.005, "angle_turns": 0.05, "radius_mm": 0.0165},
    }
    text = told(content(**changes))
    rows = text.partition("\nDimensions\n")[2].splitlines()
    assert [re.split(" {2,}", row.strip()) for row in rows[1:4]] == [
        ["zero of the motor", "0 turns (assumed)", "0.15 turns (0.1 to 0.2)", "0.05 turns", "3.0"],
        ["radius", "0.55 mm", "0.561 mm (0.56 to 0.563)", "0.017 mm (3 %)", "2.9 (+2 %)"],
        ["gain of the displacement sensor", "1 (assumed)", "0.986 (0.98 to 0.99)", "0.5 %", "2.8 (-1.4 %)"],
    ]
    step = " ".join(full(content(**changes)).partition("Measure again what calibration moved far:")[2].split())
    for name, exactly in (
        ("gain of the displacement", "0.0046"),
        ("zero of the", "0.05 turns"),
        ("radius", "0.0037 mm"),
    ):
        assert re.search(rf"{name}[^:]* {exactly} or better", step)
    assert "Intervals are those of the fit: they may reach beyond what calibration may do." in text
    bare = {"verdict": "parameters", "mechanisms": [], "alternatives": [], "next_run": None}
    text = told(content(**changes, **bare))
    assert "zero of the motor" in text and text.count("or better") == 3, "how exactly to measure stands once"
    changes["evidence__moved_sigma"] = {"scale": -1.2, "angle_turns": 1.5, "radius_mm": 0.5}
    text = told(content(**changes, **bare))
    row = next(line for line in text.partition("\nDimensions\n")[2].splitlines() if "zero of the motor" in line)
    assert " ".join(row.split()).endswith("0 turns (assumed) 0.15 turns (0.1 to 0.2) 0.05 turns 1.5")


def test_a_zero_that_uneven_friction_moves_is_to_be_written_where_it_is_sure():
    """The page said to measure a zero again that was exact: friction differed between both ways."""
    turned = {"angle_turns": {"nominal": 0.0, "value": -0.15, "low": -0.2, "high": -0.1}}
    diagnosis = content(parameters=turned, evidence__moved_sigma={"angle_turns": -3.0})
    uneven = "friction_hysteresis that is stronger in winding than in unwinding moves the zero of the motor as well."
    sure = f"{uneven} Where that zero is sure, write so (`tolerance: {{angle_turns: 0.01}}`), and diagnose again."
    for text in (page(diagnosis), full(diagnosis)):
        assert sure in " ".join(text.split())
    diagnosis["mechanisms"] = diagnosis["mechanisms"][1:]
    assert "stronger in winding" not in page(diagnosis), "no friction is named"
    of_radius = content(evidence__moved_sigma={"radius_mm": 2.9})
    assert of_radius["mechanisms"] and "stronger in winding" not in page(of_radius)


def test_how_run_yaml_says_a_tolerance_and_a_gain_is_told():
    again = ["scale", "separator_mm_2", "stiffness_n_per_mm"]
    fits = {"scale": {"nominal": 1.0, "value": 0.985}}
    (gain,) = in_run_yaml.lines({"evidence": {}, "parameters": fits}, again)
    assert "`tolerance: {scale: …, separator_mm: …}` (docs/import.md). If you measured the sensor's gain" in gain
    written = re.search(r"then write `(channels: .*?}})`", gain)[1]
    assert yaml.safe_load(written) == {"channels": {"displacement_mm": {"scale": 1.015}}}, "the inverse of what fits"
    assert in_run_yaml.lines({}, ["stiffness_n_per_mm"]) == [], "a stiffness has no tolerance"


def test_the_details_say_how_to_write_all_that_the_page_asks_to_measure():
    diagnosis = content(evidence__moved_sigma={"radius_mm": 2.9, "length_mm": -2.2, "scale": 1.0})
    diagnosis["parameters"] |= {name: {"nominal": 300.0, "value": 295.6} for name in ("length_mm", "scale")}
    assert "a tolerance is written as `tolerance: {radius: …, length_mm: …}` (docs/import.md)." in told(diagnosis)


def test_tolerances_stand_in_the_keys_and_units_of_run_yaml_and_a_length_in_place_of_a_share_is_told():
    parameters = {"radius_mm": {"nominal": 0.4, "value": 0.436}, "scale": {"nominal": 1.0, "value": 1.01}}
    parameters |= {"separator_mm": {"nominal": 8.0, "value": 8.2}}
    sigmas = {"radius_mm": 0.012, "separator_mm": 0.5, "scale": 0.005}
    diagnosis = content(parameters=parameters, evidence__tolerance=sigmas)
    block = "`tolerance: {radius: 0.03, separator_mm: 0.5, scale: 0.005}`"
    text = told(diagnosis)
    assert (
        f"Now in force, as run.yaml writes it: {block} (radius and scale are shares of the value: 0.03 is 3 %)." in text
    )
    assert yaml.safe_load(block.strip("`")) == {"tolerance": {"radius": 0.03, "separator_mm": 0.5, "scale": 0.005}}
    assert "takes care to measure by hand" not in text
    assert "All are defaults: run.yaml gives no other." in " ".join(text.split())
    diagnosis["evidence"]["tolerance"]["radius_mm"] = 0.012 * 0.4
    first = told(diagnosis).partition("\nWhat is missing\n")[0]
    assert "That is a share: 1.2 % of 0.4 mm, or 0.0048 mm, which takes care to measure by hand." in first
    assert "If 0.012 mm was meant, write radius: 0.03 and diagnose again." in first
    assert "separator_mm and scale are defaults: run.yaml gives no other." in " ".join(told(diagnosis).split())
    thin = {"radius_mm": {"nominal": 0.1, "value": 0.1}}
    near = content(parameters=thin, evidence__tolerance={"radius_mm": 0.003}, evidence__moved_sigma={})
    assert "by hand" not in told(near), "the default"


def test_the_line_in_force_is_one_that_run_yaml_takes_and_an_assumed_stiffness_is_told_in_words():
    """It had a stiffness, and pasted it was refused: `tolerance.stiffness_n_per_mm: is not a known key`."""
    parameters = {"radius_mm": {"nominal": 0.4, "value": 0.41}, "stiffness_n_per_mm": {"nominal": 12.7, "value": 14.0}}
    sigmas = {"radius_mm": 0.012, "stiffness_n_per_mm": 3.817}
    path = Path("raw/run-1/run.yaml")

    def run_with(printed: str):
        return parse_run({**described("run-1"), **parse_yaml(printed, path)}, path)

    text = " ".join(told(content(parameters=parameters, evidence__tolerance=sigmas)).split())
    assert run_with(re.search(r"as run.yaml writes it: `(.*?)`", text)[1]).tolerance == {"radius": 0.03}
    key, section = re.search(
        r"The stiffness is assumed .* write `(.*?): VALUE` under `(\w+)` in run.yaml", text
    ).groups()
    string = described("run-1")[section] | {key: 12.0}
    assert parse_run({**described("run-1"), section: string}, path).string.stiffness_n_per_mm == 12.0
    alone = told(content(parameters=parameters, evidence__tolerance={"stiffness_n_per_mm": 3.817}))
    assert "Now in force" not in alone and "The stiffness is assumed" in alone
    assert "The stiffness is assumed" not in told(content(parameters=parameters, evidence__tolerance={"radius_mm": 1}))


@pytest.mark.parametrize("name", sorted(systems()))
def test_a_tolerance_is_a_share_exactly_where_a_rig_takes_it_for_one(name):
    system = systems()[name]
    string = SimpleNamespace(radius_mm=0.4, length_mm=400.0, stiffness_n_per_mm=15.0)
    run = SimpleNamespace(string=string, rig={key: 7.0 for key in {**system.rig, **system.optional_rig}}, tolerance={})
    shares = Vocabulary.of(system).shares
    for parameter in system.parameters(run):
        key = tolerances.key_of(parameter.name)
        if key in system.tolerance:
            usual = system.tolerance[key]
            assert parameter.sigma == pytest.approx(usual * abs(parameter.nominal) if key in shares else usual), (
                parameter.name
            )
