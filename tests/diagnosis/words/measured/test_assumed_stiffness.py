"""A stiffness that nobody measured is not called measured."""

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured.dimensions import table
from pipeline.systems import systems


def test_a_stiffness_that_was_assumed_is_not_called_measured():
    fitted_stiffness = {"nominal": 20.0, "value": 40.0}
    content = {
        "verdict": "explained",
        "evidence": {"moved_sigma": {"stiffness_n_per_mm": 3.3, "radius_mm": 3.0}},
        "parameters": {"stiffness_n_per_mm": fitted_stiffness, "radius_mm": {"nominal": 0.4, "value": 0.5}},
    }
    _, stiffness, radius, *_ = table(content, Vocabulary.of(systems()["separator"]))
    assert "20 N/mm (assumed)" in stiffness and "40 N/mm" in stiffness
    assert radius.split()[:5] == ["radius", "0.4", "mm", "0.5", "mm"] and "assumed" not in radius
