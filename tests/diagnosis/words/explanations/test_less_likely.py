"""Why rivals are less likely than the best explanation."""

from made_content import told, weighed


def test_each_likely_and_each_beaten_explanation_says_why_it_is_less_likely():
    made = weighed(0.004, 0.06, 0.26, 0.02, 0.52)
    made["evidence"]["explanations"][3]["because"] = [{"aspect": "fit", "log_odds": -0.9, "more": -1.2}]
    made["evidence"]["explanations"][2]["because"] = [{"aspect": "more", "log_odds": -0.9, "more": -1.2}]
    text = " ".join(told(made).split())
    likely, beaten = text.split("Why no other explanation")
    assert (
        "times the noise). It is 2.0 times less likely than the best one, chiefly since it fits the recording worse."
        in likely
    )
    assert "friction_hysteresis + sensor_drift 6 % 0.030 mm (1.0) 8.7 " in beaten
    assert "friction_hysteresis + sensor_drift: though a further effect would add less to it: such expl" in beaten
    assert " creep less than 1 % 0.060 mm (2.0) 130 " in beaten


def test_the_reason_that_most_rivals_share_stands_once_and_what_is_hardly_likely_has_its_row_alone():
    """Eight sentences of three lines differed by a name and two numbers."""
    made = weighed(0.004, 0.06, 0.26, 0.02, 0.52)
    shared = [{"aspect": "fit", "log_odds": -0.9, "more": -1.2}]
    for place in (1, 2):
        made["evidence"]["explanations"][place]["because"] = shared
    made["evidence"]["explanations"][4]["because"] = [{"aspect": "size", "log_odds": -0.9, "more": 1.0}]
    beaten = " ".join(told(made).split("Why no other explanation")[1].split())
    assert beaten.count("it fits the recording worse") == 1
    assert "Why less likely, where nothing else is said: chiefly since it fits the recording worse." in beaten
    assert "friction_hysteresis + creep + wear: chiefly since it has more effects." in beaten
    assert "friction_hysteresis + sensor_drift: Weighed sample by sample" in beaten and " creep: W" not in beaten
    made["evidence"]["explanations"][1]["probability"] = None
    beaten = " ".join(told(made).split("Why no other explanation")[1].split())
    assert "+ sensor_drift 6 % 0.030 mm (1.0) 8.7 " in beaten, "one that was not weighed takes the table from no other"
    assert " creep: leaves 0.060 mm rms" in beaten
