"""Why rivals are less likely than the best explanation."""

import re

from made_content import told, weighed

HEADING = "\nHow probable each explanation is\n"


def section(diagnosis):
    """The table of the explanations and what stands below it, on one line."""
    return " ".join(told(diagnosis).partition(HEADING)[2].partition("\n\n")[0].split())


def test_each_likely_and_each_beaten_explanation_says_why_it_is_less_likely():
    diagnosis = weighed(0.004, 0.06, 0.26, 0.02, 0.52)
    diagnosis["evidence"]["explanations"][3]["because"] = [{"aspect": "fit", "log_odds": -0.9, "more": -1.2}]
    diagnosis["evidence"]["explanations"][2]["because"] = [{"aspect": "more", "log_odds": -0.9, "more": -1.2}]
    text = section(diagnosis)
    assert "2 friction_hysteresis + thermal 26 % 0.070 mm (2.3) 0.070 mm" in text
    assert "3 friction_hysteresis + sensor_drift 6 % 0.030 mm (1.0) 0.070 mm" in text
    assert (
        "Why less likely than no. 1: chiefly since it fits the recording worse (no. 2); though a further effect" in text
    )
    assert "would add less to it: such explanations were right less often" in text and "judge (no. 3)." in text
    assert "5 creep less than 1 % 0.060 mm (2.0)" in text


def test_the_reason_that_most_rivals_share_stands_once_and_what_is_hardly_likely_has_its_row_alone():
    """Eight sentences of three lines differed by a name and two numbers."""
    diagnosis = weighed(0.004, 0.06, 0.26, 0.02, 0.52)
    shared = [{"aspect": "fit", "log_odds": -0.9, "more": -1.2}]
    for place in (1, 2):
        diagnosis["evidence"]["explanations"][place]["because"] = shared
    diagnosis["evidence"]["explanations"][4]["because"] = [{"aspect": "size", "log_odds": -0.9, "more": 1.0}]
    text = section(diagnosis)
    assert text.count("it fits the recording worse") == 1
    assert "chiefly since it fits the recording worse (no. 3 and 5)" in text
    assert "chiefly since it has more effects (no. 4)" in text
    assert "By the noise of the samples alone, explanation 1 fits better than 3 by 20 standard deviations." in text
    assert not re.search(r"[^0-9]5 by", text), "hardly likely: its row alone"
    diagnosis["evidence"]["explanations"][1]["probability"] = None
    text = section(diagnosis)
    assert "+ sensor_drift 6 % 0.030 mm (1.0)" in text, "one that was not weighed takes the table from no other"
    assert "5 creep – 0.060 mm (2.0)" in text
