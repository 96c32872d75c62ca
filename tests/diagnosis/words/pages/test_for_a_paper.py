"""What can be reported of a verdict."""

from made_content import content, told


def test_where_nothing_is_missing_no_size_of_it_is_reported() -> None:
    diagnosis = content(mismatch__rms_mm=0.0, verdict="parameters", mechanisms=[], alternatives=[], next_run=None)
    text = told(diagnosis).partition("To report it\n")[2].partition("\n\n")[0]
    assert "after calibration nothing is missing beyond the noise" in text and "0 mm rms" not in text
    assert "- 0.44 mm rms is missing after calibration" in told()


def test_what_is_reported_after_adopting_names_what_was_adopted() -> None:
    """A reader of `nothing is missing` alone reports a clean string, while the simulator holds an effect."""
    diagnosis = content(verdict="parameters", mechanisms=[], alternatives=[], next_run=None, mismatch__rms_mm=0.0)
    diagnosis["simulation"], diagnosis["evidence"]["explanations"] = [{"id": "creep", "parameters": {}}], []
    to_report = told(diagnosis).partition("To report it\n")[2].partition("\n\n")[0]
    assert "after calibration nothing is missing beyond the noise, with creep adopted (in run.yaml);" in to_report
    assert "of creep: what the verdict lets report that was adopted (its details.txt, To report it)." in to_report
    assert "Do not report that this recording shows no effect: creep is in the simulator." in to_report
