"""A diagnosis that lacks a part, or holds a text where a number belongs, is still read for what it has."""

import pytest
from made_content import SYSTEMS, content

from pipeline.diagnosis.adoption.before_after import on_unseen, probable
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named.logged import temperature

WORDS = Vocabulary.of(SYSTEMS["mm"])


@pytest.mark.parametrize("error", ["much", None, [0.1]])
def test_errors_that_are_no_numbers_are_not_said(error: object) -> None:
    heldout = {"split": "last 30 % of strokes", "calibrated_mm": 0.3, "explained_mm": error}
    diagnosis = content(verdict="explained") | {"fit": {"heldout": heldout}}
    assert on_unseen(diagnosis, WORDS, str(diagnosis["run"])) == []
    heldout["explained_mm"] = 0.1
    assert "0.10 mm" in on_unseen(diagnosis, WORDS, str(diagnosis["run"]))[0]


def test_a_probability_that_is_a_text_is_not_said() -> None:
    diagnosis = content() | {"evidence": {"explanations": [{"ids": ["creep"], "probability": "high"}]}}
    assert probable(["creep"], diagnosis) == "creep"
    diagnosis["evidence"]["explanations"][0]["probability"] = 0.8
    assert probable(["creep"], diagnosis) == "creep (80 %)"


def test_a_logged_temperature_is_said_of_a_mismatch_that_names_no_driver() -> None:
    diagnosis = content(verdict="unknown", mechanisms=[], alternatives=[])
    diagnosis["evidence"] = diagnosis["evidence"] | {"covered": {"temperature_c": [20.0, 24.0]}}
    diagnosis["mismatch"] = {key: value for key, value in diagnosis["mismatch"].items() if key != "driver"}
    assert "20 to 24 °C" in temperature(diagnosis, WORDS)[0]
