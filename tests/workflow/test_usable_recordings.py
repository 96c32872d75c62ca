"""New recordings are read once before the plan, and what their reading program dies of costs no other."""

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
import ready
from made_recording import recording

from pipeline.run.folder import recording_path
from pipeline.workflow import usable_recordings
from pipeline.workflow.usable_recordings import answers, refusals

ROOT = Path(__file__).parents[2]


@pytest.fixture
def quick(monkeypatch):
    """The program that reads has its imports made; the first test and those in which it dies start it bare."""

    def run(command, **_):
        assert command[:2] == [sys.executable, "-m"]
        return ready.run(*command[2:], cwd=Path.cwd())

    monkeypatch.setattr(usable_recordings, "subprocess", SimpleNamespace(run=run))


def test_each_recording_is_read_once_and_again_when_it_or_the_code_is_new(make_run, tmp_path, capsys, monkeypatch):
    make_run("a-01")
    make_run("b-01", recording(4).assign(displacement_mm=1.0))
    raw, contents = tmp_path / "raw", {"a-01": "1", "b-01": "2"}
    refused, kept = refusals(raw, contents, "code", None)
    assert list(refused) == ["b-01"] and "never changes" in refused["b-01"].why
    assert "2 (a-01, b-01)" in capsys.readouterr().err

    read_folders = []
    monkeypatch.setattr(usable_recordings, "answers", lambda folders, place: read_folders.extend(folders) or {})
    assert refusals(raw, contents, "code", kept) == (refused, kept) and not read_folders
    assert capsys.readouterr().err == ""
    refusals(raw, {**contents, "b-01": "3"}, "code", kept)
    assert [folder.name for folder in read_folders] == ["b-01"]
    refusals(raw, contents, "other code", kept)
    assert len(read_folders) == 3


@pytest.mark.parametrize("kept", [None, [], {"a-01": 5}, {"a-01": ["1", "code", "[{"]}, {"a-01": ["1", "code", 5]}])
def test_what_was_kept_and_is_damaged_is_read_again(make_run, tmp_path, quick, kept):
    make_run("a-01")
    refused, kept_answers = refusals(tmp_path / "raw", {"a-01": "1"}, "code", kept)
    assert refused == {} and kept_answers == {"a-01": ["1", "code", "[]"]}


def test_a_recording_at_which_the_reader_dies_has_no_answer_and_the_others_do(make_run, tmp_path, monkeypatch):
    folders = [make_run(name) for name in ("a-01", "b-01", "c-01")]
    python = tmp_path / "python"
    python.write_text(
        f"#!{sys.executable}\n"
        "import os, sys\nfrom pipeline.run import samples\nfrom pipeline.workflow import usable_recordings\n"
        "read = samples.stored_strokes\n"
        "samples.stored_strokes = lambda folder, out: os._exit(9) if folder.name == 'b-01' else read(folder, out)\n"
        "sys.argv = sys.argv[2:]\nusable_recordings.main()\n"
    )
    python.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(python))
    monkeypatch.setattr(usable_recordings, "AT_ONCE", 2)  # programs of two runs each
    assert answers(dict.fromkeys(folders, "")) == {"a-01": [], "c-01": []}


def ingested(place, run, *words) -> str:
    """Ingest a run, as its rule does; what it says."""
    files = ["--out", f"processed/{run}/samples.parquet", "--out-strokes", f"processed/{run}/strokes.parquet"]
    done = ready.run("pipeline.stages.ingest", f"raw/{run}", *files, *words, cwd=place)
    assert done.returncode == 0, done.stderr
    return done.stdout + done.stderr


def made(place, run) -> list[bytes]:
    return [(place / "processed" / run / f"{name}.parquet").read_bytes() for name in ("samples", "strokes")]


WILD = recording(4)
WILD.loc[777, "displacement_mm"] = 1e6  # a warning of the reading


@pytest.mark.long
def test_what_the_plan_read_is_taken_over_and_the_recording_is_not_read_again(make_run, tmp_path, quick, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder, ahead = make_run("a-01", WILD), tmp_path / "processed" / ".read_ahead"
    plain = ingested(tmp_path, "a-01")
    files = made(tmp_path, "a-01")
    assert "warning" in plain
    words = ["--read-ahead", "processed/.read_ahead", "--of", "1", "code"]

    refusals(Path("raw"), {"a-01": "1"}, "code", None, ahead)
    file = recording_path(folder)
    content = file.read_bytes()
    file.write_bytes(b"no table\n")  # whoever decodes it again fails
    assert ingested(tmp_path, "a-01", *words) == plain and made(tmp_path, "a-01") == files
    assert not list(ahead.iterdir()), "it is kept until ingest has it"

    file.write_bytes(content)
    for other in (words, [*words[:-2], "code"]):  # what a rule records has no digest of its content
        assert ingested(tmp_path, "a-01", *other) == plain and made(tmp_path, "a-01") == files


def test_a_refused_recording_and_one_that_is_gone_leave_nothing_behind(make_run, tmp_path, quick):
    ahead = tmp_path / "processed" / ".read_ahead"
    make_run("a-01")
    make_run("b-01", recording(4).assign(displacement_mm=1.0))
    refused, kept = refusals(tmp_path / "raw", {"a-01": "1", "b-01": "2"}, "code", None, ahead)
    assert list(refused) == ["b-01"] and [folder.name for folder in ahead.iterdir()] == ["a-01"]
    refusals(tmp_path / "raw", {}, "code", kept, ahead)
    assert not list(ahead.iterdir())


def test_no_recording_is_refused_because_nothing_can_be_kept(make_run, tmp_path, quick):
    make_run("a-01")
    (tmp_path / "processed").write_text("a file, not a folder")
    refused, _ = refusals(tmp_path / "raw", {"a-01": "1"}, "code", None, tmp_path / "processed" / ".read_ahead")
    assert refused == {}
