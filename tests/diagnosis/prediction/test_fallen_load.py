"""A plan follows the recording of its own run, and those before it: the load of a later run says nothing of it."""

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pandas as pd
import programs
import pytest
from made_recording import recording

from pipeline.notebook.recording import Recording

FALLS = "it asks for load_n that falls from"


@pytest.mark.parametrize(
    ("first_n", "second_n", "simulated", "late", "planned_n", "falls"),
    [
        ((20.0, 20.0), (30.0, 30.0), "first", True, 20.0, False),  # it was outside, as if it followed the second run
        ((20.0, 20.0), (30.0, 30.0), "first", False, 20.0, False),
        ((20.0, 20.0), (30.0, 30.0), "second", True, 20.0, True),
        ((20.0, 20.0), (30.0, 30.0), "second", False, 20.0, False),
        ((20.0, 30.0), (30.0, 30.0), "second", False, 20.0, True),  # it was inside, though the first run had 30 N
        ((30.0, 30.0), (20.0, 20.0), "first", True, 20.0, False),  # such a fall was recorded
    ],
)
def test_the_load_before_a_plan_is_that_of_the_recordings_it_follows(
    make_run: Callable[..., Path], tmp_path: Path, first_n: tuple[float, float], second_n: tuple[float, float],
    simulated: str, late: bool, planned_n: float, falls: bool,
) -> None:  # fmt: skip
    table = recording(4)
    early = table["time_s"] < table["time_s"].median()
    folders = {
        name: make_run(name, table.assign(load_n=early.map({True: early_n, False: late_n})))
        for name, (early_n, late_n) in {"first": first_n, "second": second_n}.items()
    }
    content = {"run": ["first", "second"], "parameters": {}, "simulation": []}
    diagnosis, plan, out = tmp_path / "diagnosis.json", tmp_path / "plan.csv", tmp_path / "out.csv"
    diagnosis.write_text(json.dumps(content))
    top, lasts_s = 27.0, 13.5  # as the strokes that were recorded
    corners = {"time_s": [0.0, lasts_s, 2.0 * lasts_s], "motor_turns": [0.0, top, 0.0], "load_n": [planned_n] * 3}
    pd.DataFrame(corners).to_csv(plan, index=False)
    words = ["--simulation", diagnosis, "--motion", plan, *(["--after-recording"] if late else []), "--out", out]
    done = programs.run("pipeline.simulate", folders[simulated], *words)
    assert done.returncode == 0, done.stderr
    assert (FALLS in done.stderr) is falls, done.stderr
    assert set(pd.read_csv(out)["outside"]) == {int(falls)}, done.stderr
    diagnosis = SimpleNamespace(content=content, recorded=())  # read from a file: the runs lie in folders
    answer = Recording.read(folders[simulated]).simulate(diagnosis, pd.DataFrame(corners), late)
    assert list(answer["outside"].astype(int)) == list(pd.read_csv(out)["outside"]), "the Python call says the same"
