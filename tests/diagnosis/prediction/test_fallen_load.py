"""A plan follows the recording of its own run, and those before it: the load of a later run says nothing of it."""

import json
from collections.abc import Callable
from contextlib import nullcontext
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
    read = Recording.read(folders[simulated])
    with pytest.warns(UserWarning, match=FALLS) if falls else nullcontext():
        answer = read.simulate(diagnosis, pd.DataFrame(corners), late)
    assert list(answer["outside"].astype(int)) == list(pd.read_csv(out)["outside"]), "the Python call says the same"


@pytest.mark.parametrize(
    ("loads_n", "late", "planned_n", "mend", "followed_n"),
    [
        ((20.0, 30.0), True, (20.0, 20.0), "keep load_n at 30, or record", (30.0, 30.0)),  # there is nowhere to rise
        ((20.0, 30.0), False, (30.0, 20.0), "begin at the lowest load_n of the plan and let it rise", (20.0, 30.0)),
        ((20.0, 30.0, 26.0), True, (20.0, 20.0), "keep load_n within 26 to 30, or record", (26.0, 26.0)),
    ],
)
def test_what_is_advised_of_a_load_that_falls_can_be_done(
    make_run: Callable[..., Path], tmp_path: Path, loads_n: tuple[float, ...], late: bool,
    planned_n: tuple[float, float], mend: str, followed_n: tuple[float, float],
) -> None:  # fmt: skip
    """Behind a recording whose last load was the highest it said: let load_n rise only."""
    table = recording(4)
    third = (len(loads_n) * table["time_s"] / (table["time_s"].max() + 1.0)).astype(int)
    folder = make_run("first", table.assign(load_n=third.map(dict(enumerate(loads_n)))))
    diagnosis, plan = tmp_path / "diagnosis.json", tmp_path / "plan.csv"
    diagnosis.write_text(json.dumps({"run": "first", "parameters": {}, "simulation": []}))
    warnings = []
    for begins_n, ends_n in (planned_n, followed_n):
        loads = {"load_n": [begins_n, ends_n, ends_n]}
        pd.DataFrame({"time_s": [0.0, 13.5, 27.0], "motor_turns": [0.0, 27.0, 0.0], **loads}).to_csv(plan, index=False)
        words = ["--simulation", diagnosis, "--motion", plan, *(["--after-recording"] if late else [])]
        done = programs.run("pipeline.simulate", folder, *words, "--out", tmp_path / "out.csv")
        assert done.returncode == 0, done.stderr
        warnings.append(done.stderr)
    assert FALLS in warnings[0] and f"Mend: {mend}" in warnings[0].replace("\n", " "), warnings[0]
    assert FALLS not in warnings[1], f"what was advised does not mend it: {warnings[1]}"
