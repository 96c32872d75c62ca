"""Dimensions that calibration moved."""

import re

from made_content import CONTENT, LEFT, adopted, content, told

from pipeline.diagnosis.document.bounds import at_bound


def corrected(value, sigma):
    """The words where only the radius moved."""
    parameters = {"radius_mm": {"nominal": 0.55, "value": value, "low": value, "high": value}}
    verdict_fields = {
        "verdict": "parameters",
        "mechanisms": [],
        "alternatives": [],
        "next_run": None,
        "parameters": parameters,
    }
    changes = {"evidence__moved_sigma": {"radius_mm": sigma}, "evidence__explanations": []}
    return told(content(**verdict_fields, **changes, evidence__nominal_mm=0.45, evidence__calibrated_mm=0.033))


def test_moved_dimensions_are_listed_with_the_misfit_before_and_after():
    text = corrected(0.5612, 2.1)
    errors = " ".join(text.partition("\nHow far the simulator is off, rms\n")[2].split())
    assert "nominal 0.45 mm (15 times the noise)" in errors and "calibrated 0.033 mm (1.1 times the noise)" in errors
    assert re.search(r"\n  radius +0\.55 mm +0\.5612 mm +– +2\.1 \(\+2 %\)\n", text)
    assert "Only a dimension that moves by more than 2.5 tolerances is to be measured again." in text
    assert "stays within its tolerance" not in text
    assert re.search(r"radius +0\.55 mm +0\.55001 mm +– +0\.020 \(\+0\.0018 %\)\n", corrected(0.55001, 0.02))
    assert "Every dimension stays within its tolerance: nothing says that one was measured wrong." in corrected(
        0.551, 0.2
    )
    assert "only the zero of the reading did" in corrected(0.55, 1e-4)


def test_a_dimension_at_the_bound_of_its_tolerance_is_called_suspicious_before_all_else():
    for sigma, which in ((3.0, "upper"), (-2.96, "lower")):
        text = " ".join(told(content(evidence__moved_sigma={"radius_mm": sigma})).split())
        doubts = text.partition("What to know first ")[2].partition("What is missing")[0]
        assert (
            f"Suspicious: calibration moved a dimension as far as it may, three times the tolerance: radius, {which}"
            in (doubts)
        )
        assert "bound 0.5612 mm (run.yaml says 0.55 mm). The best value may lie beyond." in doubts
        assert f"radius 0.55 mm 0.5612 mm (0.56 to 0.563) – {abs(sigma):.1f} " in text
    assert "Suspicious" not in told() and "as far as it may" not in told()
    both = {"radius_mm": 3.0, "scale": -3.0}
    parameters = CONTENT["parameters"] | {"scale": {"nominal": 1.0, "value": 0.985, "low": 0.98, "high": 0.99}}
    text = " ".join(told(content(evidence__moved_sigma=both, parameters=parameters)).split())
    assert (
        "moved 2 dimensions as far as it may" in text
        and "gain of the displacement sensor, lower bound 0.985 (1 w" in text
    )
    assert at_bound(both | {"length_mm": 2.9}) == {"radius_mm": "upper", "scale": "lower"}


def test_dimensions_that_move_in_vain_explain_nothing():
    text = adopted("parameters", **LEFT)
    assert "Moving them explains next to nothing" in text
    again = "Measure the radius again before you believe any of these values."
    assert again in text and again not in adopted("parameters", **LEFT | {"evidence__nominal_mm": 0.4})
    bare = {"verdict": "parameters", "mechanisms": [], "alternatives": [], "next_run": None}
    for before, in_vain in ((0.0302, True), (0.06, False)):
        text = told(content(**bare, evidence__nominal_mm=before, evidence__calibrated_mm=0.03))
        assert ("moving dimensions adds" in text) == ("Moving them explains next to nothing" in text) == in_vain
        assert ("once its measured dimensions move" in text) == ("the dimensions alone explain" in text) != in_vain


def test_what_the_simulation_misses_may_bend_dimensions_and_so_may_another_rig():
    diagnosis = content()
    diagnosis["evidence"]["explanations"][-1]["left_mm"] = 0.05
    warning = (
        "What the simulation still misses bends dimensions as well. Do not copy calibrated values into run.yaml: meas"
    )
    assert warning in told(diagnosis) and warning not in told()
    many = {f"{name}_mm": 3.0 for name in ("radius", "length", "separator", "torsion_zone")}
    values = dict.fromkeys(many, CONTENT["parameters"]["radius_mm"])
    text = told(content(parameters=values, evidence__moved_sigma=many))
    warning = (
        "where measuring again changes none, physics that the library lacks may have moved them, or run.yaml describes"
    )
    assert warning in text


def test_a_dimension_that_stayed_is_in_the_list_too():
    unmoved = {"nominal": 100.0, "value": 100.001}
    moved = {"radius_mm": 0.9, "torsion_zone_mm": -0.006, "length_mm": 0.001}
    diagnosis = content(evidence__moved_sigma=moved, parameters__torsion_zone_mm=unmoved, parameters__length_mm=unmoved)
    stayed = "Stayed (moved by less than a hundredth of the tolerance): torsion zone and length."
    assert stayed in told(diagnosis) and "Stayed" not in told(content(evidence__moved_sigma={"radius_mm": 0.9}))
