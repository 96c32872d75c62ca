"""New recordings are read once before the plan, and what their reading program dies of costs no other."""

import sys

import pytest
from made_recording import recording

from pipeline.workflow import usable
from pipeline.workflow.usable import answers, refusals


def test_each_recording_is_read_once_and_again_when_it_or_the_code_is_new(make_run, tmp_path, capsys, monkeypatch):
    make_run("a-01")
    make_run("b-01", recording(4).assign(displacement_mm=1.0))
    raw, contents = tmp_path / "raw", {"a-01": "1", "b-01": "2"}
    refused, kept = refusals(raw, contents, "code", None)
    assert list(refused) == ["b-01"] and "never changes" in refused["b-01"].why
    assert "2 (a-01, b-01)" in capsys.readouterr().err

    asked = []
    monkeypatch.setattr(usable, "answers", lambda folders: asked.extend(folders) or {})
    assert refusals(raw, contents, "code", kept) == (refused, kept) and not asked
    assert capsys.readouterr().err == ""
    refusals(raw, {**contents, "b-01": "3"}, "code", kept)
    assert [folder.name for folder in asked] == ["b-01"]
    refusals(raw, contents, "other code", kept)
    assert len(asked) == 3


@pytest.mark.parametrize("kept", [None, [], {"a-01": 5}, {"a-01": ["1", "code", "[{"]}, {"a-01": ["1", "code", 5]}])
def test_what_was_kept_and_is_damaged_is_read_again(make_run, tmp_path, kept):
    make_run("a-01")
    refused, known = refusals(tmp_path / "raw", {"a-01": "1"}, "code", kept)
    assert refused == {} and known == {"a-01": ["1", "code", "[]"]}


def test_a_recording_at_which_the_reader_dies_has_no_answer_and_the_others_do(make_run, tmp_path, monkeypatch):
    folders = [make_run(name) for name in ("a-01", "b-01", "c-01")]
    python = tmp_path / "python"
    python.write_text(
        f"#!{sys.executable}\n"
        "import os, sys\nfrom pipeline.run import samples\nfrom pipeline.workflow import usable\n"
        "read = samples.stored_strokes\n"
        "samples.stored_strokes = lambda folder, out: os._exit(9) if folder.name == 'b-01' else read(folder, out)\n"
        "sys.argv = sys.argv[2:]\nusable.main()\n"
    )
    python.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(python))
    assert answers(folders) == {"a-01": [], "c-01": []}
