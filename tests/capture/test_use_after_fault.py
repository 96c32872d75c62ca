"""After a fault capture reads the run once, whatever it tells of it, also where runs of its string lie beside."""

from collections import Counter
from pathlib import Path

import yaml
from made_recording import content, recording

from pipeline.capture.__main__ import tell_of_its_string
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
