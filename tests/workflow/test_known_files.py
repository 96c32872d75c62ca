import os
import time

import pandas as pd
import pytest

from pipeline.ground.stored import schemas
from pipeline.workflow import known_files
from pipeline.workflow.known_files import KnownFiles


@pytest.fixture
def make_known_files(tmp_path, monkeypatch):
    monkeypatch.setattr(known_files, "SETTLED_S", -1.0)  # a test does not wait until a file is old
    return lambda: KnownFiles(tmp_path / "cache" / "known.json")


def write_as_before(path, content, times):
    """Replace a file's content and set its times back."""
    path.write_bytes(content)
    os.utime(path, ns=times)


def test_content_decides_and_time_does_not(tmp_path, make_known_files):
    path = tmp_path / "recording.csv"
    path.write_bytes(b"one")
    stat = path.stat()
    files = make_known_files()
    first = files.digest([str(path)])
    files.save()
    os.utime(path)
    assert make_known_files().digest([str(path)]) == first
    time.sleep(0.02)  # the clock of a file's change ticks in steps of milliseconds
    write_as_before(path, b"two", (stat.st_atime_ns, stat.st_mtime_ns))
    assert make_known_files().digest([str(path)]) != first
    older = tmp_path / "older"
    older.write_bytes(b"old")
    os.utime(older, (1, 1))
    os.replace(older, path)
    assert make_known_files().digest([str(path)]) not in (first, make_known_files().digest([]))


def test_a_file_is_read_once(tmp_path, make_known_files, monkeypatch):
    path = tmp_path / "recording.csv"
    path.write_bytes(b"one")
    files = make_known_files()
    first = files.digest([str(path)])
    files.save()
    monkeypatch.setattr(known_files, "sha256", lambda path: pytest.fail("it was read again"))
    assert make_known_files().digest([str(path)]) == first


def test_a_file_that_has_just_changed_is_read_again(tmp_path):
    path = tmp_path / "recording.csv"
    path.write_bytes(b"one")
    files = KnownFiles(tmp_path / "known.json")
    files.digest([str(path)])
    assert files.facts == {}


@pytest.mark.parametrize("kept", ["", "[1]", '{"facts": 3}', '{"facts": {"x": [[1], 2]}, "notes": []}', "[" * 9000])
def test_a_cache_that_is_none_is_made_again(tmp_path, kept):
    (tmp_path / "known.json").write_text(kept)
    files = KnownFiles(tmp_path / "known.json")
    assert files.digest([str(tmp_path / "absent")]) == files.digest([]) and files.notes == {}


def test_a_damaged_table_is_found_and_looked_for_again_after_a_failure(tmp_path, make_known_files):
    table, path = pd.DataFrame({"point": [1], "displacement_mm": [0.5], "motor_turns": [1.0]}), tmp_path / "t.parquet"
    schemas.write(table, schemas.PREDICTIONS, path)
    files = make_known_files()
    assert files.damaged([str(path), str(tmp_path / "absent.parquet")]) == {}
    files.forget_intact()
    assert files.facts == {}
    path.write_bytes(path.read_bytes()[:-9])
    assert list(files.damaged([str(path)])) == [str(path)]
