"""The words and units of other rigs."""

import re

import pytest
from made_content import content, told

from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.words.language.explained_words import tells
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.systems import systems


def others(system, ending, driver, channel_unit, load):
    """The same verdict on a rig that is no string."""
    text = repr(content(run="rig-1"))
    text = text.replace("_mm'", f"_{ending}'").replace("'mm'", f"'{channel_unit}'").replace("motor_turns", driver)
    return told(eval(text.replace("load_n", load or "none")), ["raw/rig-1"], system)


@pytest.mark.parametrize(
    ("ending", "driver", "unit", "load"), [("deg", "motor_deg", "deg", "torque_nm"), ("n", "position_m", "N", "load_n")]
)
def test_other_rigs_have_their_own_words_and_units(ending, driver, unit, load):
    text = others(ending, ending, driver, unit, load)
    assert not re.search(r"\b(string|twist|twisted|wind|winding|unwinding|turns|mm|displacement)\b", text), text
    reading, motion = {"deg": ("jaw angle", "deg"), "n": ("force", "m")}[ending]
    forward, back = "the way forward", "the way back"
    assert (
        f"Friction makes the {reading} of {forward} differ from that of {back}, by 0.20 {unit} from the lowest" in text
    )
    assert f"2. Go to 30.7 {motion} in 16 s" in text and f"4. Go back to 0 {motion}" in text


def test_the_test_of_an_effect_speaks_of_no_twist_and_no_string_on_another_rig():
    mass = Vocabulary.of(systems()["moving_mass"])
    for id_, mechanism in mechanisms().items():
        if not mechanism.twisted and not id_.startswith("x_"):
            assert not re.search(r"\b(twists?|string)\b", tells(id_, mass)), id_
    assert tells("viscous_loss", mass) == "three speeds and small strokes at low position"
    assert "load steps at two positions" in tells("axial_elasticity", mass)
