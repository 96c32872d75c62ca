"""The line that says what an effect does."""

import pytest
from made_content import content, page, parameter

CALCULATED = "the length follows a temperature that is calculated from the motion, not measured."


@pytest.mark.parametrize(("measured", "line"), [(0.0, CALCULATED), (1.0, "the length follows the temperature.")])
def test_a_temperature_that_nobody_measured_is_said_to_be_none(measured, line) -> None:
    known = {"id": "thermal", "rms_mm": parameter(0.2, "mm"), "parameters": {"measured": parameter(measured, "")}}
    made = content(mechanisms=[known], alternatives=[], verdict="explained", next_run=None)
    made["evidence"]["explanations"][-1]["ids"] = ["thermal"]
    assert line in " ".join(page(made).split())
