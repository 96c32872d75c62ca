"""Recordings that are not ours are looked for where a person says, or beside the checkout, and nowhere else."""

from pathlib import Path

import downloaded
import pytest

SKIPPED, FAILED = pytest.skip.Exception, pytest.fail.Exception


@pytest.fixture
def beside(tmp_path, monkeypatch):
    """A folder of recordings beside the checkout, not made yet; no variable is set."""
    monkeypatch.delenv(downloaded.NAME, raising=False)
    monkeypatch.delenv("CI", raising=False)
    monkeypatch.setattr(downloaded, "BESIDE", tmp_path / "shared" / "recordings")
    return tmp_path / "shared" / "recordings"


def recording_in(folder):
    """A recording of a rig, in a folder."""
    path = folder / "emps" / "DATA_EMPS.mat"
    path.parent.mkdir(parents=True)
    path.touch()
    return path


def asked(rig, pattern):
    """Recordings that a test gets, or how it would end, and why: a skip that came through would skip the test here."""
    try:
        return downloaded.files(rig, pattern)
    except (SKIPPED, FAILED) as end:
        return type(end), str(end)


def test_the_folder_beside_the_checkout_is_its_neighbour():
    assert Path(__file__).resolve().parents[3] / "shared" / "recordings" == downloaded.BESIDE


def test_without_any_folder_the_tests_of_downloads_are_skipped_with_the_reason(beside, tmp_path, monkeypatch):
    monkeypatch.setenv("CI", "true")
    end, why = asked("emps", "*")
    assert end is SKIPPED and downloaded.NAME in why
    monkeypatch.setenv(downloaded.NAME, str(tmp_path))
    end, why = asked("emps", "*")
    assert end is SKIPPED and "wmkouw/NSI-EMPS" in why


def test_recordings_beside_the_checkout_are_found_unless_the_variable_names_others(beside, tmp_path, monkeypatch):
    neighbour, named = recording_in(beside), recording_in(tmp_path / "named")
    assert asked("emps", "*.mat") == [neighbour]
    monkeypatch.setenv(downloaded.NAME, str(tmp_path / "named"))
    assert asked("emps", "*.mat") == [named]


def test_in_ci_a_recording_that_is_gone_from_its_rigs_folder_fails(beside, monkeypatch):
    recording_in(beside)
    assert asked("emps", "GONE.mat")[0] is SKIPPED
    monkeypatch.setenv("CI", "true")
    end, why = asked("emps", "GONE.mat")
    assert end is FAILED and "emps has no GONE.mat" in why
    end, why = asked("tsa_haptic", "*.csv.gz")
    assert end is SKIPPED and "FaragSeif/tsa_haptic" in why
