"""After a fault capture reads the run once, whatever it tells of it, also where runs of its string lie beside."""

from collections import Counter
from pathlib import Path

import pandas as pd
import pytest
import ready
import yaml
from made_recording import content, recording

from pipeline.capture.ended_run import tell_of_its_string
from pipeline.run import samples


def test_a_run_that_a_fault_ended_is_read_once(tmp_path, monkeypatch, capsys):
    for number, name in enumerate(("run-1", "run-2")):
        (tmp_path / name).mkdir()
        string = content(name)["string"] | {"id": "spool-3"}
        (tmp_path / name / "run.yaml").write_text(yaml.safe_dump(content(name, string=string)))
        recording(seed=number).to_csv(tmp_path / name / "recording.csv", index=False)
    times_read: Counter[str] = Counter()
    plain = samples.read_recording

    def counting(run, folder: Path):
        times_read[folder.name] += 1
        return plain(run, folder)

    monkeypatch.setattr(samples, "read_recording", counting)
    info = {"samples": {"received": 1}, "exit_status": "fault"}
    tell_of_its_string(tmp_path / "run-2", info)  # type: ignore[arg-type]
    assert times_read == {"run-1": 1, "run-2": 1}
    assert "in 3 strokes; the exit status 1 tells of the fault" in capsys.readouterr().out


def recovered(folder: Path, samples: pd.DataFrame, status: int = 0) -> str:
    """What --recover says of the printed lines of these samples."""
    folder.mkdir()
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1")))
    (folder / "recording.lines").write_text(samples.to_csv(index=False))
    done = ready.run("pipeline.capture", "--recover", folder)
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize(
    ("samples", "strokes"),
    [(-1, "3 strokes"), (-180, "2 strokes"), (1000, "1 stroke"), (150, "0 strokes")],
    ids=["whole", "cut off", "in the second stroke", "in the first stroke"],
)
def test_too_few_strokes_are_said_however_the_recording_ended(tmp_path, samples, strokes):
    """Of one that was ended in its first stroke a diagnosis was advised, which refuses it."""
    words = recovered(tmp_path / "run-1", recording()[:samples])
    assert f"Next: record more of this rig: {strokes} so far" in words and "pipeline.diagnose" not in words, words


@pytest.mark.parametrize(
    ("first", "words"),
    [
        (0, ""),
        (55, ""),
        (150, "a winding, at 8 of 27 turns: stroke 1 holds it from there on, and nothing is left out"),
        (395, "a stroke, at 27 of 27 turns: its first 16.1 s, up to the first winding, belong to no stroke"),
        (500, "a stroke, at 20 of 27 turns: its first 11.9 s, up to the first winding, belong to no stroke"),
    ],
    ids=["at rest", "just begun", "while it winds", "while it holds", "while it unwinds"],
)
def test_a_recording_that_joined_a_rig_amid_a_stroke_says_so(tmp_path, first, words):
    """Nothing told of it, nor which part of the recording no table has."""
    printed = recovered(tmp_path / "run-1", recording()[first:])
    assert (f"warning: the recording began amid {words}" in printed) if words else ("amid" not in printed), printed


def test_a_wrong_sign_of_printed_lines_is_warned_of_when_the_recording_ends(tmp_path):
    """26 s and the end went by without a word; only the diagnosis refused the run."""
    table = recording()
    words = recovered(tmp_path / "run-1", table.assign(displacement_mm=-table["displacement_mm"]), status=2)
    warning = next(line for line in words.splitlines() if line.startswith("warning: "))
    assert "falls while the motor winds" in warning and "set channels.displacement_mm.scale to -1" in warning
