"""What a recogniser says of a signature, and whether the library's knows the hand of strangers."""

import json
from pathlib import Path

import numpy as np
import pytest
from first_few import first_few

from pipeline.diagnosis.numerics.judge import judge
from pipeline.diagnosis.numerics.recogniser import DOUBT, Recogniser, read, signs, written
from pipeline.proof.teach.lesson import Lesson, sighted

JUDGES = Path(__file__).resolve().parents[3] / "pipeline" / "proof" / "teach" / "judges"
CLEAR = ("creep", "backlash", "axial_elasticity", "eccentricity", "wear", "slack")


def made() -> Recogniser:
    """A network of two units, each of which answers to one number."""
    return Recogniser(
        ["loop", "rest_top"], ["backlash", "creep", "outside"], np.zeros(2), np.ones(2),
        np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), np.array([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.5]]),
    )  # fmt: skip


def test_likenesses_are_shares_and_a_missing_number_counts_as_nothing() -> None:
    looped, rested, neither = (made().likenesses(signature) for signature in ({"loop": 2.0}, {"rest_top": 2.0}, {}))
    assert sum(looped.values()) == pytest.approx(1.0)
    assert max(looped, key=looped.get) == "backlash" and max(rested, key=rested.get) == "creep"
    assert max(neither, key=neither.get) == "outside"


def test_a_file_keeps_what_a_recogniser_says() -> None:
    again = read(json.loads(json.dumps(written(made()))))
    assert again.likenesses({"loop": 1.234}) == pytest.approx(made().likenesses({"loop": 1.234}), rel=1e-3)


def test_signs_are_of_the_one_effect_that_an_explanation_names_and_of_the_likeliest_other() -> None:
    alike = {"backlash": 0.6, "creep": 0.3, "jam": 0.08, "outside": 0.02}
    single, pair = signs(alike, ("creep",)), signs(alike, ("backlash", "creep"))
    assert single["alike"] == pytest.approx(np.log(0.3 + DOUBT))
    assert single["alike_else"] == pytest.approx(np.log(0.6 + DOUBT))
    assert pair["alike"] == pair["alike_else"] == 0.0 and pair["alike_outside"] == single["alike_outside"]
    assert signs(alike, ("x_clock",))["alike"] == single["alike_outside"] == pytest.approx(np.log(0.02 + DOUBT))
    assert signs(alike, ("thermal",))["alike"] == pytest.approx(np.log(DOUBT))
    assert signs({}, ("creep",)) == {}


@pytest.mark.parametrize("author", first_few(["lattice", "workshop", "kinetics"]))
def test_it_recognises_clear_effects_by_an_author_who_did_not_teach_it(author) -> None:
    recogniser = judge(JUDGES / f"without_{author}.json").recogniser
    assert recogniser
    right = 0
    for number, effect in enumerate(CLEAR):
        alike = recogniser.likenesses(sighted(Lesson(author, 970_000 + number, (effect,), (6.0,), "rich")).signature)
        right += max(alike, key=alike.get) == effect
    assert right >= 4, "of six; by chance it would be one in twenty"
