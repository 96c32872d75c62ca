"""The words that a verdict explains last."""

from pathlib import Path

from made_content import SYSTEMS, told

from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.words.language.explained_words import meaning, on_rig
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.ground.words.glossary import MEANING


def test_the_verdict_explains_its_own_words_last_a_line_each():
    text = told()
    last = text.split("\n\n")[-1].splitlines()
    assert last[0] == "What the words mean"
    meanings = dict(line.strip().split(": ", 1) for line in last[1:])
    assert next(iter(meanings)) == "ambiguous" and meanings["wear"] == MEANING["wear"]
    assert {"wear", "sensor_drift", "calibrated", "rms"} <= set(meanings)
    assert not {"jam", "explained"} & set(meanings), "they stand nowhere on the page"
    assert not {"friction_hysteresis", "creep", "thermal"} & set(meanings), "their rows say what they do"
    assert "the length follows the temperature." in text


def test_every_mechanism_and_every_verdict_is_in_the_glossary_and_in_the_docs():
    docs = Path(__file__).parents[4] / "docs"
    page, physics = ((docs / name).read_text(encoding="utf-8") for name in ("diagnose.md", "physics.md"))
    for word in ["consistent", "parameters", "explained", "ambiguous", "unknown"]:
        assert f"- `{word}`: {MEANING[word]}" in page, word
    for id_, mechanism in mechanisms().items():
        definition = MEANING[id_]
        assert (
            definition == mechanism.meaning and f"## {id_}\n\n{definition[:1].upper()}{definition[1:]}\n" in physics
        ), id_
    assert "no physics is missing" not in MEANING["parameters"]


def test_an_offset_is_of_what_the_rig_reads():
    """`a constant force or angle is added` stood on the page of a rig that reads a force."""
    for ending, reading in (("n", "force"), ("deg", "jaw angle")):
        words = Vocabulary.of(SYSTEMS[ending])
        assert on_rig(meaning("sensor_offset"), words) == f"a constant {reading} is added."
