"""Numbers in words: units, sensible digits, no exponents."""

import re

from made_content import told

from pipeline.diagnosis.words.language import quantity


def test_no_number_goes_without_unit_sense_or_in_exponents():
    text = told()
    assert not re.search(r"\de[+-]?\d", text)
    assert "-0.000" not in text and "-0 " not in text
    assert (
        "Over the whole recording 0.44 mm rms is missing after calibration (noise taken off), 15 times the noise."
        in text
    )
    assert "83 % of its energy lies at 0 to 12 turns, in strokes 2 to 9, while winding." in text
    assert "What is missing follows the direction of motion and the load; time under load." in text


def test_numbers_read_well():
    texts = [quantity.number(value) for value in (0.0, 0.0312, 5.02, 120.0, 5330.0, 1.49e-4)]
    assert texts == ["0", "0.031", "5", "120", "5,300", "0.00015"]
    assert quantity.size(0.0000312, "mm") == "0.031 µm" and quantity.size(0.104, "mm") == "0.10 mm"
    assert quantity.at(-0.000488, "turns", 30.0) == "0 turns" and quantity.at(30.671, "turns", 30.0) == "30.7 turns"
    assert quantity.said_unit("mm/10N") == "mm/10 N" and quantity.said_unit("mm/turn^2") == "mm/turn²"
    assert [quantity.duration(s) for s in (0.5, 30.2, 120.0, 150.0)] == ["0.5 s", "30 s", "2 min", "2 min 30 s"]


def test_a_column_has_one_unit_and_numbers_that_are_compared_have_as_many_decimals() -> None:
    """0.82 µm stood under 0.015 mm, and 32 mm above 31.9 mm."""
    assert quantity.of_column(0.00082, "mm", 0.015) == "0.00082 mm"
    assert quantity.of_column(0.00082, "mm", 0.00091) == "0.82 µm", "where all of it are so small"
    assert quantity.to_tell([32.03, 31.93], 0.1, "mm") == ["32.03 mm", "31.93 mm"]
    assert quantity.to_tell([11.6, 11.64], 0.04, "mm") == ["11.60 mm", "11.64 mm"]
    assert quantity.to_tell([0.00032, 0.0003], 2e-5, "mm") == ["0.32 µm", "0.3 µm"]
