"""What stands under a key that is made is read as what it is, and written where it belongs in the file."""

import pytest

from pipeline.diagnosis.document import made_keys
from pipeline.diagnosis.document.explanations import ExplanationEntry, share_of


def test_a_number_is_read_and_a_text_is_none() -> None:
    part = {"left_mm": 0.25, "gap_mm": None, "rms_mm": "a lot"}
    assert made_keys.amount(part, "left_mm") == made_keys.amount_or_none(part, "left_mm") == 0.25
    assert made_keys.amount_or_none(part, "gap_mm") is made_keys.amount_or_none(part, "not_there_mm") is None
    with pytest.raises(TypeError, match="rms_mm"):
        made_keys.amount(part, "rms_mm")
    with pytest.raises(KeyError, match="not_there_mm"):
        made_keys.amount(part, "not_there_mm")


def test_ranges_names_and_intervals_are_told_from_numbers() -> None:
    size = {"value": 0.2, "low": 0.1, "high": 0.3}
    part = {"motor_turns": [0.0, 20.0], "tops_mm": {"creep": 0.1}, "rms_mm": size, "floor_mm": 0.01}
    assert made_keys.extent(part, "motor_turns") == [0.0, 20.0]
    assert made_keys.by_name(part, "tops_mm") == {"creep": 0.1}
    assert made_keys.by_name(part, "spans_mm") == {}  # an older file has none
    assert made_keys.interval(part, "rms_mm") == size
    for read in (made_keys.extent, made_keys.by_name, made_keys.interval):
        with pytest.raises(TypeError, match="floor_mm"):
            read(part, "floor_mm")


def test_made_keys_stand_before_the_entry_that_is_named_or_last() -> None:
    entry: ExplanationEntry = {"ids": ["creep"], "standing": "named"}
    assert list(made_keys.with_made(entry, {"left_mm": 0.1}, "standing")) == ["ids", "left_mm", "standing"]
    assert list(made_keys.with_made(entry, {"left_mm": 0.1}, "probability")) == ["ids", "standing", "left_mm"]
    assert list(entry) == ["ids", "standing"]
    made_keys.put(entry, "left_mm", 0.1)
    assert made_keys.amount(entry, "left_mm") == 0.1


@pytest.mark.parametrize(("probability", "share"), [(0.4, 0.4), (None, 0.0)])
def test_an_explanation_that_nobody_weighed_has_no_share(probability: float | None, share: float) -> None:
    assert share_of({"ids": ["creep"], "standing": "tied", "probability": probability}) == share
    assert share_of({"ids": ["creep"], "standing": "tied"}) == 0.0
