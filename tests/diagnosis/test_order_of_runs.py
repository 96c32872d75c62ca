"""Runs that are diagnosed together are taken in the order in which they were recorded, not in that of the command."""

import json
from pathlib import Path

import pytest
from made_recording import content, recording
from programs import run
from stages.nine_strokes import string

from pipeline import diagnose
from pipeline.notebook import diagnosis as in_a_notebook


def folders(place: Path) -> list[Path]:
    """Two runs of one string, the later one first, as a shell sorts `r-10` before `r-9`."""
    run_folders = []
    for name, later_s in (("r-10", 400.0), ("r-9", 0.0)):
        folder = place / name
        folder.mkdir()
        (folder / "run.yaml").write_text(json.dumps(content(name, string=string(id="a"))))
        table = recording(2)
        table.assign(time_s=table["time_s"] + later_s).to_parquet(folder / "recording.parquet")
        run_folders.append(folder)
    return run_folders


def test_runs_together_are_taken_in_the_order_of_their_recording(tmp_path, monkeypatch, capsys):
    taken = []

    def diagnosed(recorded, *others):
        taken.extend(each.run.run for each in recorded)
        raise InterruptedError

    monkeypatch.setattr(in_a_notebook, "diagnosed", diagnosed)
    with pytest.raises(InterruptedError):
        diagnose.decide(folders(tmp_path), tmp_path / "out", diagnose.Options(together=True))
    assert taken == ["r-9", "r-10"]
    assert "taken in the order in which they were recorded: r-9, r-10" in capsys.readouterr().err


def test_one_run_is_not_diagnosed_together_with_itself(tmp_path):
    later, _ = folders(tmp_path)
    done = run("pipeline.diagnose", later, later, "--together", "--out", tmp_path / "out")
    assert done.returncode == 2 and "is named twice" in done.stderr and not (tmp_path / "out").exists()
