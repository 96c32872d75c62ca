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
    said = [quantity.number(value) for value in (0.0, 0.0312, 5.02, 120.0, 5330.0, 1.49e-4)]
    assert said == ["0", "0.031", "5", "120", "5,300", "0.00015"]
    assert quantity.size(0.0000312, "mm") == "0.031 µm" and quantity.size(0.104, "mm") == "0.10 mm"
    assert quantity.at(-0.000488, "turns", 30.0) == "0 turns" and quantity.at(30.671, "turns", 30.0) == "30.7 turns"
    assert quantity.said_unit("mm/10N") == "mm/10 N" and quantity.said_unit("mm/turn^2") == "mm/turn²"
    assert [quantity.duration(s) for s in (0.5, 30.2, 120.0, 150.0)] == ["0.5 s", "30 s", "2 min", "2 min 30 s"]
