"""What was read before the plan is taken over whole and of the same word, or not at all."""

import pandas as pd
import pytest
from made_recording import recording

from pipeline.run.read_ahead import READ_OF, SAMPLES, STROKES, WARNINGS, forget, keep, taken_over
from pipeline.run.samples import read_strokes


@pytest.fixture
def kept(make_run, tmp_path):
    """A run, the place where its reading is kept under the word `1 code`, and where ingest writes."""
    folder, place = make_run("a-01", recording(4)), tmp_path / "ahead"
    keep(folder, place, "1 code")
    return folder, place, tmp_path / "samples.parquet"


def test_a_reading_that_is_kept_gives_what_reading_gives(kept):
    folder, place, out = kept
    run, samples, strokes = taken_over(folder, place, "1 code", out)
    read, table, cut = read_strokes(folder)
    assert run == read and samples.frame(0, len(samples)).equals(table[samples.columns])
    pd.testing.assert_frame_equal(strokes, cut, check_dtype=False)
    forget(folder, place)
    assert taken_over(folder, place, "1 code", out) is None and not (place / "a-01").exists()


def test_a_reading_of_another_content_is_not_taken_over(kept):
    assert taken_over(*kept[:2], "2 code", kept[2]) is None
    assert taken_over(*kept[:2], "", kept[2]) is None


@pytest.mark.parametrize("name", [SAMPLES, STROKES, WARNINGS, READ_OF])
def test_a_reading_without_one_of_its_files_is_not_taken_over(kept, name):
    folder, place, out = kept
    (place / "a-01" / name).unlink()
    assert taken_over(folder, place, "1 code", out) is None


@pytest.mark.parametrize("name", [SAMPLES, STROKES])
def test_a_damaged_reading_is_not_taken_over(kept, name):
    folder, place, out = kept
    file = place / "a-01" / name
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    assert taken_over(folder, place, "1 code", out) is None


def test_a_reading_that_fails_half_way_keeps_nothing(kept, monkeypatch):
    folder, place, out = kept
    monkeypatch.setattr("pipeline.run.read_ahead.schemas.write", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        keep(folder, place, "1 code")
    assert taken_over(folder, place, "1 code", out) is None and not (place / "a-01").exists()
