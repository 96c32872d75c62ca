"""A recording of a synthetic rig that does not come about says why."""

import pytest

from pipeline.rig import record


@pytest.mark.parametrize(
    ("change", "value", "message"),
    [
        ("PATIENCE_S", -1.0, "small: the rig was not there within -1 s; run the command again"),
        ("__package__", "pipeline.no_such_rig", "small: the rig ended with status 1 before it was there; run it alone"),
    ],
)
def test_a_rig_that_is_not_there_is_said_and_the_folder_holds_no_recording(
    monkeypatch, capsys, tmp_path, change, value, message
) -> None:
    monkeypatch.setattr(record, change, value)
    assert record.record("small", tmp_path, 1) == 1
    assert f"error: {message}" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
