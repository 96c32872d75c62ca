"""Recordings that are not ours are looked for where a person says, and nowhere else."""

import downloaded
import pytest


def test_without_a_named_folder_the_tests_of_downloads_are_skipped_with_the_reason(tmp_path, monkeypatch):
    monkeypatch.delenv(downloaded.NAME, raising=False)
    with pytest.raises(pytest.skip.Exception, match=downloaded.NAME):
        downloaded.files("emps", "*")
    monkeypatch.setenv(downloaded.NAME, str(tmp_path))
    with pytest.raises(pytest.skip.Exception, match="wmkouw/NSI-EMPS"):
        downloaded.files("emps", "*")
    (tmp_path / "emps").mkdir()
    (tmp_path / "emps" / "DATA_EMPS.mat").touch()
    assert downloaded.files("emps", "*.mat") == [tmp_path / "emps" / "DATA_EMPS.mat"]
