"""On the rig of the paper the traditional model makes the errors of the paper's Tables I and II."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pipeline.ground.kinematics import Array
from pipeline.rig.motion_commands import commands
from pipeline.rig.recorded_at_once import simulate
from pipeline.rig.setup import described, dimensions, read_setup
from pipeline.run.strokes import label
from pipeline.stages.dataset import blocks_from_top, held_out

LOAD_N = 20.0
# Traditional model at n = 1, 5, 9: forward mean, maximum, RMSE in mm, then inverse mean, maximum, RMSE in turns.
PAPER = {
    1: [1.103, 4.382, 1.766, 1.351, 3.861, 1.811],
    5: [1.749, 4.813, 2.094, 2.871, 6.013, 3.140],
    9: [2.101, 4.920, 2.390, 3.239, 6.945, 3.470],
}
BANDS = {"all": (0.04, 0.10), "held out": (0.05, 0.10)}  # rms and worst relative error


def summary(error: Array) -> list[float]:
    return [error.mean(), error.max(), np.sqrt(np.square(error).mean())]


@pytest.fixture(scope="module", params=[1, 2])
def errors(request):
    """Relative errors of the 18 numbers, by which samples they are taken over, each of shape (3, 6)."""
    setup = read_setup("paper")
    simulated = simulate(setup, request.param)
    geometry = dimensions(described(setup, Path("synthetic-01/run.yaml")))
    quanta = {channel.name: channel.scale for channel in simulated.hello.channels}
    turns, measured_mm = (simulated.samples[name] * quanta[name] for name in ("motor_turns", "displacement_mm"))
    stroke_of, phase = label(simulated.time_s, turns)
    resting = (stroke_of == 0) & (phase == "rest")
    model_mm = geometry.contraction_mm(turns, LOAD_N)
    measured_mm = measured_mm + np.median((model_mm - measured_mm)[resting])
    forward_mm = np.abs(model_mm - measured_mm)
    inverse_turns = np.abs(geometry.motor_turns(measured_mm, LOAD_N) - turns)
    summaries: dict[str, list[list[float]]] = {"all": [], "held out": []}
    for stroke in PAPER:
        winding = np.flatnonzero((stroke_of == stroke) & (phase == "winding"))
        block = blocks_from_top(len(winding))
        for name, points in (("all", winding), ("held out", winding[held_out(block, np.array(stroke))])):
            summaries[name].append(summary(forward_mm[points]) + summary(inverse_turns[points]))
    return {name: np.array(rows) / list(PAPER.values()) - 1.0 for name, rows in summaries.items()}


@pytest.mark.parametrize("samples", BANDS)
def test_the_traditional_model_lands_on_the_papers_rows(errors, samples):
    rms, worst = BANDS[samples]
    relative = errors[samples]
    assert np.sqrt(np.square(relative).mean()) <= rms, relative.round(3)
    assert np.abs(relative).max() <= worst, relative.round(3)


def test_there_are_5000_winding_samples_in_nine_strokes():
    setup = read_setup("paper")
    trajectory = commands(setup.motion, 1.0 / setup.rate_hz)
    assert len(trajectory.strokes_s) == 9
    assert trajectory.motor_turns.max() == pytest.approx(27.2) and trajectory.motor_turns.min() == 0
    assert np.diff(trajectory.strokes_s[:, :2]).sum() * setup.rate_hz >= 5000


@pytest.mark.long
def test_the_paper_rig_is_recorded_by_the_real_programs(tmp_path):
    folder = tmp_path / "synthetic-01"
    command = [sys.executable, "-m", "pipeline.rig.record", "paper", str(folder), "--seed", "1"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    info = json.loads((folder / "capture.json").read_text())
    assert info["exit_status"] == "complete" and info["frames"]["lost"] == 0
    assert "run.yaml" not in done.stdout


@pytest.mark.long
def test_record_fails_where_the_capture_program_fails(tmp_path):
    folder = tmp_path / "synthetic-01"
    folder.mkdir()
    (folder / "recording.frames").write_bytes(b"precious")
    command = [sys.executable, "-m", "pipeline.rig.record", "paper", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2 and "never overwritten" in done.stderr
    assert (folder / "recording.frames").read_bytes() == b"precious"
