"""Run folders as a command line names them: `.` is a folder with a name, and none is named twice."""

import json
import sys
from pathlib import Path

import pytest
from made_recording import content, recording

from pipeline import adopt
from pipeline.ground.errors import BadInput
from pipeline.run.run_arguments import refuse_twice, run_dir


def test_a_program_inside_a_run_folder_takes_a_dot_for_it(tmp_path, monkeypatch, capsys):
    folder = tmp_path / "two"
    folder.mkdir()
    (folder / "run.yaml").write_text(json.dumps(content("two")))
    recording(2).to_parquet(folder / "recording.parquet")
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "argv", ["adopt", "--explain", "."])
    with pytest.raises(SystemExit) as ended:
        adopt.main()
    assert ended.value.code == 0
    assert "two/run.yaml holds nothing that was adopted" in " ".join(capsys.readouterr().out.split())


def test_a_path_that_has_a_name_stays_as_it_was_typed(tmp_path, monkeypatch):
    (tmp_path / "raw" / "two").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "raw" / "two")
    assert [run_dir(text) for text in ("raw/two/", "../two")] == [Path("raw/two"), Path("../two")]
    assert run_dir(".") == tmp_path / "raw" / "two" and run_dir("..") == Path("..")


def test_a_folder_that_is_named_by_two_paths_is_refused(tmp_path):
    (tmp_path / "a").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "a")
    refuse_twice([tmp_path / "a", tmp_path / "b"], "why")
    with pytest.raises(BadInput) as error:
        refuse_twice([tmp_path / "a", tmp_path / "link"], "its strokes would count twice")
    assert error.value.problem == "is named twice" and "count twice" in error.value.mend
