"""What can be reported of a verdict."""

from made_content import content, told


def test_where_nothing_is_missing_no_size_of_it_is_reported() -> None:
    made = content(mismatch__rms_mm=0.0, verdict="parameters", mechanisms=[], alternatives=[], next_run=None)
    text = told(made).partition("To report it\n")[2].partition("\n\n")[0]
    assert "after calibration nothing is missing beyond the noise" in text and "0 mm rms" not in text
    assert "- 0.44 mm rms is missing after calibration" in told()
