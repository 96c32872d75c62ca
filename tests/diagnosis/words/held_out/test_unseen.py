"""The error on unseen strokes, beside the noise."""

import pytest
from made_content import CONTENT, adopted, content, told


def table(text):
    """The rows of the table of errors, and what is said below it."""
    return [
        line[2:]
        for line in text.partition("\nHow far the simulator is off, rms\n")[2].partition("\n\n")[0].splitlines()
    ]


def test_the_error_on_unseen_strokes_stands_beside_the_noise():
    text = told()
    assert table(text) == [
        "simulator      whole recording (seen by the fit)   last 30 % of strokes (seen by no fit)",
        "nominal        –                                   1.9 mm (62 times the noise)",
        "calibrated     –                                   0.81 mm (26 times the noise)",
        "as diagnosed   0.030 mm (1.0 times the noise)      0.033 mm (1.1 times the noise)",
        "noise          0.030 mm                            0.031 mm",
        "For the right column all was fitted anew without those strokes.",
    ]
    both = {"evidence__nominal_mm": 1.1, "evidence__calibrated_mm": 0.441, "evidence__floor_mm": 0.018}
    rows = table(told(content(**both, evidence__step_s=0.05)))
    assert rows[1].split("  ")[-1].strip() == "1.9 mm (62 times the noise)" and "1.1 mm (61 times the noise)" in rows[1]
    assert "0.44 mm (25 times the noise)" in rows[2]
    assert "0.018 mm, of averages of 0.05 s" in rows[4] and rows[4].endswith("0.031 mm, of single samples")
    alone = table(told(content(fit__heldout=None)))
    assert alone[0].split("   ")[-1].strip() == "whole recording (seen by the fit)" and alone[-1].startswith(
        "Too few strokes to hold"
    )
    bare = {"verdict": "parameters", "mechanisms": [], "alternatives": [], "next_run": None, "fit__heldout": None}
    bare = table(told(content(**bare, evidence__explanations=[])))
    assert [row.split()[0] for row in bare] == ["simulator", "nominal", "calibrated", "noise", "Too"]
    none = table(adopted(fit__heldout__explained_mm=0.81, evidence__calibrated_mm=0.03))
    assert [row.split()[0] for row in none] == ["simulator", "nominal", "calibrated", "noise", "Perhaps"]


@pytest.mark.parametrize(
    ("calibrated", "expected"),
    [
        (0.039, "Something systematic is still missing: the last strokes are missed by 1.33 times the noise (1.3 is"),
        (0.030, "Something changes from stroke to stroke that the fit does not foresee: the last strokes are missed"),
    ],
)
def test_strokes_change_only_where_unseen_ones_are_missed_by_more_than_seen_ones(calibrated, expected):
    heldout_errors = {"fit__heldout__explained_mm": 0.0415, "fit__heldout__calibrated_mm": 0.0415}
    text = adopted(**heldout_errors, evidence__calibrated_mm=calibrated)
    assert expected in text
    assert ("from stroke to stroke" in text) == (calibrated < 0.035)
    assert ("So it is in what the fit has seen as well." in text) == (calibrated > 0.035)


def test_a_verdict_says_that_its_zero_is_fitted_and_that_of_the_programs_is_not():
    zero = {"zero_mm": {"nominal": 0.0, "value": 0.1, "low": 0.1, "high": 0.1}}
    sentence = "pipeline.simulate of another run takes the zero of the reading from its first second. A verdict fits"
    assert sentence in told(content(parameters=CONTENT["parameters"] | zero)) and sentence not in told()
