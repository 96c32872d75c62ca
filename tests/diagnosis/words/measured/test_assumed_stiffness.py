"""A stiffness that nobody measured is not called measured."""

from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.measured.dimensions import remeasured
from pipeline.systems import systems


def test_a_stiffness_that_was_assumed_is_not_called_measured():
    known = {"nominal": 20.0, "value": 40.0}
    content = {
        "evidence": {"moved_sigma": {"stiffness_n_per_mm": 3.3, "radius_mm": 3.0}},
        "parameters": {"stiffness_n_per_mm": known, "radius_mm": {"nominal": 0.4, "value": 0.5}},
    }
    stiffness, radius, *_ = remeasured(content, Vocabulary.of(systems()["separator"]), [])
    assert "20 N/mm was assumed" in stiffness and "again" not in stiffness
    assert radius.startswith("Measure the radius again") and "run.yaml says 0.4" in radius
