"""What an explanation leaves with a discrepancy has one name in new files, and is read of old ones too."""

import pytest

from pipeline.diagnosis.document.content import left_with_discrepancy


def test_a_new_file_and_an_older_one_say_the_same():
    assert left_with_discrepancy({"with_discrepancy_mm": 0.2}, "mm") == 0.2
    assert left_with_discrepancy({"bent_deg": 0.3}, "deg") == 0.3
    with pytest.raises(KeyError):
        left_with_discrepancy({"bent_deg": 0.3}, "mm")
