"""The words on a rig that has metres, and neither turns nor a load."""

import re

from made_content import SYSTEMS

from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.system_units import Units
from pipeline.diagnosis.words.language import explained_words
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured.dimensions import from_to, likely_range
from pipeline.diagnosis.words.named.effect_sentence import sentence
from pipeline.diagnosis.words.named.own_size import with_interval
from pipeline.diagnosis.words.pages.adoption import columns_of_plan, hung

MASS, STRING = Vocabulary.of(SYSTEMS["n"]), Vocabulary.of(SYSTEMS["mm"])
PITCH = {"value": 0.012192, "low": 0.012192, "high": 0.012192, "unit": "m"}


def test_a_ripple_over_metres_is_told_by_its_length_and_not_by_a_turn() -> None:
    entry = {"id": "eccentricity", "parameters": {"pitch_m": PITCH}}
    assert explained_words.of_effect(entry, MASS) == "a ripple once in every 0.0122 m."
    assert explained_words.of_effect(entry | {"parameters": {}}, STRING) == "a ripple once a turn."
    meant = explained_words.on_rig(explained_words.meaning("eccentricity"), MASS)
    assert meant == "a ripple once in every turn of what drives it (a screw, a motor)."


def test_the_word_named_is_explained_where_it_stands_in_place_of_a_percentage() -> None:
    table = "effect         how sure\neccentricity   named      4.5 N"
    diagnosis = {"verdict": "explained", "mechanisms": [], "alternatives": [], "evidence": {}}
    assert any(
        line.startswith("named: the effect is in the one") for line in explained_words.lines(diagnosis, table, MASS)
    )
    assert not any(line.startswith("named") for line in explained_words.lines(diagnosis, "creep   sure, 90 %", STRING))


def test_the_ends_of_an_interval_differ_as_they_are_printed() -> None:
    mass = {"nominal": 100.0, "value": 92.1, "low": 92.06, "high": 92.14}
    diagnosis = {"parameters": {"mass_kg": mass}, "evidence": {"tolerance": {"mass_kg": 10.0}}}
    low, high = re.findall(r"[0-9.]+(?= to|\))", likely_range(diagnosis, "mass_kg"))
    assert low != high and float(low) < float(high)


def test_a_plan_asks_for_no_load_where_none_was_recorded_and_a_lag_says_how_to_get_seconds() -> None:
    none, loaded = ({"evidence": {"covered": {"load": [0.0, load]}}} for load in (0.0, 20.0))
    assert "load_n" not in columns_of_plan(MASS, hung(none, MASS))
    assert "unless it stands still, load_n" in columns_of_plan(STRING, hung(loaded, STRING))
    assert hung({"evidence": {}}, MASS) == "load_n", "an older file does not say"
    *_, lag = mechanisms()["sensor_lag"].details
    assert "divided by the mass that is the delay in seconds" in lag


def test_the_lag_of_a_mass_that_is_known_is_said_as_a_delay() -> None:
    late = {"value": 0.35, "low": 0.3, "high": 0.4, "unit": "N s^3/m"}
    entry = {"rms_n": {"value": 5.1, "low": 5.0, "high": 5.4}, "parameters": {"late_n_s3_per_m": late}}
    mechanism, units = mechanisms()["sensor_lag"], Units.of(SYSTEMS["n"])
    delay_sentence = sentence(mechanism, entry, None, MASS, units, mass_kg=100.0)
    assert delay_sentence.endswith("the delay of the position is 3.5 ms (3 to 4).")
    assert "divided by the mass" in sentence(mechanism, entry, None, MASS, units)


def test_a_dimension_is_said_with_the_digits_of_its_interval_and_lies_in_it() -> None:
    mass = {"nominal": 100.0, "value": 110.74, "low": 110.66, "high": 110.9}
    diagnosis = {"parameters": {"mass_kg": mass}, "evidence": {"tolerance": {"mass_kg": 10.0}}}
    assert from_to(diagnosis, "mass_kg") == ("100 kg", "110.74 kg")
    assert likely_range(diagnosis, "mass_kg") == " (110.66 to 110.9)"


def test_the_interval_in_the_table_keeps_a_digit_more_where_two_would_hide_an_end() -> None:
    entry = {"rms_n": {"value": 14.8, "low": 14.2, "high": 15.3}, "confidence": 0.0}
    assert with_interval(entry, MASS) == "14.8 N (14.2 to 15.3 N)"
