"""A size and its interval read as one: the ends have one unit."""

import pytest

from pipeline.diagnosis.words.language.sized import sized
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.systems import systems


@pytest.mark.parametrize(
    ("ends", "text"),
    [
        ((0.083, 1.3e-6, 0.18), "0 to 0.18 mm"),
        ((0.02, 8e-4, 0.05), "0.00080 to 0.050 mm"),
        ((4e-4, 2e-4, 6e-4), "0.20 to 0.60 µm"),
        ((15.0, 14.0, 16.0), "14 to 16 mm"),
        ((0.1302, 0.1298, 0.1306), "0.130 to 0.131 mm"),
    ],
)
def test_the_ends_of_an_interval_have_one_unit(ends: tuple[float, float, float], text: str) -> None:
    assert sized(*ends, Vocabulary.of(systems()["separator"]))[1] == text
