"""`simulate --residual`: a black box beside the physics, named apart, that says its worth and where it is blind."""

import json
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.diagnosis.prediction.residual import BlackBox, Lesson, told_of
from pipeline.run.samples import read_samples

DIRECTED = ("friction_hysteresis", "backlash", "viscous_loss", "sensor_lag", "stick_slip", "x_clock", "load_swing")
LACKING = (*DIRECTED, "shaft_windup", "radius_compaction", "overtwist")  # nothing comes closer than dimensions do
COLUMNS = ["residual_mm", "residual_low_mm", "residual_high_mm"]


def diagnosed(folders, out: Path, *words: object) -> Path:
    """A `diagnosis.json` of runs, as the program writes it."""
    done = programs.run("pipeline.diagnose", *folders, "--out", out, *words)
    assert done.returncode == 0, done.stderr
    return next(out.rglob("diagnosis.json"))


@pytest.fixture(scope="module")
def unexplained(conceal, remembered, tmp_path_factory) -> tuple[Path, Path]:
    """A run with friction, and its diagnosis by a library that has nothing like it."""
    folder = conceal("friction_hysteresis")[0]
    lacking = [word for id_ in LACKING for word in ("--without", id_)]
    with remembered():
        return folder, diagnosed([folder], tmp_path_factory.mktemp("out"), *lacking)


def simulated(folder: Path, diagnosis: Path, out: Path, *words: object) -> tuple[pd.DataFrame, str]:
    """What `simulate` wrote and said."""
    done = programs.run("pipeline.simulate", folder, "--simulation", diagnosis, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return pd.read_csv(out), " ".join(done.stdout.split())


@pytest.mark.long
def test_it_stands_beside_the_reading_and_says_what_it_was_worth_on_unseen_strokes(unexplained, tmp_path):
    folder, diagnosis = unexplained
    bare, _ = simulated(folder, diagnosis, tmp_path / "bare.csv")
    table, printed = simulated(folder, diagnosis, tmp_path / "more.csv", "--residual")
    assert list(table) == ["time_s", "displacement_mm", *COLUMNS]
    pd.testing.assert_frame_equal(table[list(bare)], bare)
    heldout = json.loads(diagnosis.read_text())["fit"]["heldout"]
    with_it = float(printed.partition("rms without it and ")[2].partition(" mm with it: it helps.")[0])
    assert f"the error was {heldout['explained_mm']:.2g} mm rms without it" in printed
    assert heldout["without_physics_mm"] * 0.6 < with_it < 0.67 * heldout["explained_mm"]
    recorded = read_samples(folder)[1]["displacement_mm"]
    residual = recorded - table["displacement_mm"]
    assert (residual - table["residual_mm"]).std() < 0.6 * residual.std()
    between = residual.between(table["residual_low_mm"], table["residual_high_mm"])
    assert between.mean() > 0.85 and (table["residual_high_mm"] - table["residual_low_mm"]).max() < 4.0 * residual.std()
    assert "no physics" in printed and f"of the strokes of {folder.name}" in printed


@pytest.mark.long
def test_what_it_adds_is_in_no_diagnosis(unexplained):
    content = json.loads(unexplained[1].read_text())
    assert not [key for key in content if "residual" in key] and content["mechanisms"] == []
    assert set(content["without_last_strokes"]) == {"seen_s", "parameters", "simulation"}


@pytest.mark.long
def test_where_physics_explains_all_it_says_that_it_does_not_help(conceal, tmp_path):
    folder = conceal("creep")[0]
    diagnosis = diagnosed([folder], tmp_path / "out")
    _, printed = simulated(folder, diagnosis, tmp_path / "more.csv", "--residual")
    assert "it does not help: leave it out" in printed and "it helps" not in printed


@pytest.mark.long
def test_it_adds_nothing_to_what_was_not_recorded_and_says_so(unexplained, tmp_path):
    folder, diagnosis = unexplained
    recorded = read_samples(folder)[1]
    top, plan = float(recorded["motor_turns"].max()), tmp_path / "plan.csv"
    load = float(recorded["load_n"].median())
    motion = {"time_s": [0, 10, 25, 40], "motor_turns": [0, 0.9 * top, 1.4 * top, 0.9 * top]}
    pd.DataFrame(motion).assign(load_n=load).to_csv(plan, index=False)
    table, printed = simulated(folder, diagnosis, tmp_path / "far.csv", "--residual", "--motion", plan)
    time_s = table["time_s"]
    far = np.interp(time_s, motion["time_s"], motion["motor_turns"]) > 1.06 * top
    assert far.sum() > 500 and (table["residual_mm"][far] == 0.0).all()
    assert table[COLUMNS[1:]][far].isna().all(axis=None)
    near = time_s.between(1.0, 9.0)
    assert (table["residual_mm"][near] != 0.0).mean() > 0.5
    rows = int((table["residual_low_mm"].isna()).sum())
    assert (
        f"{rows} of {len(table)} rows lie beyond the drivers that it was fitted to: residual_mm is 0 there" in printed
    )


@pytest.mark.long
def test_of_the_strokes_that_it_is_scored_on_it_has_learnt_nothing(unexplained, tmp_path):
    folder, diagnosis = unexplained
    seen_s = json.loads(diagnosis.read_text())["without_last_strokes"]["seen_s"][0]
    spoiled = Path(shutil.copytree(folder, tmp_path / folder.name))
    samples = pd.read_parquet(spoiled / "recording.parquet")
    later = samples["time_s"] - samples["time_s"].iloc[0] >= seen_s
    samples["displacement_mm"] += 1.0 * later
    samples.to_parquet(spoiled / "recording.parquet")
    _, printed = simulated(spoiled, diagnosis, tmp_path / "more.csv", "--residual")
    assert "it does not help: leave it out" in printed, "a shift of those strokes alone could be learnt from them alone"


def test_a_black_box_knows_nothing_of_the_rows_that_it_may_not_see(problem):
    rows, names = len(problem.record), list(told_of(problem.drivers, 1.0))
    residual = np.sin(problem.drivers.motion)
    seen = np.arange(rows) < 0.7 * rows
    honest, spoiled = (
        BlackBox.fitted([Lesson(problem, values)], [seen], names)
        for values in (residual, np.where(seen, residual, 1e3))
    )
    np.testing.assert_array_equal(honest.added(problem.drivers)[0], spoiled.added(problem.drivers)[0])


@pytest.mark.parametrize(
    ("seen", "query_range"),
    [(((0.0, 0.25), (0.75, 1.0)), (0.46, 0.54)), (((0.0, 0.9),), (0.96, 1.0))],
    ids=["between", "just beyond"],
)
def test_it_adds_nothing_where_the_recording_was_not(problem, seen, query_range):
    share = problem.drivers.motion / problem.drivers.motion.max()
    rows = np.logical_or.reduce([(share >= low) & (share <= high) for low, high in seen])
    names = list(told_of(problem.drivers, 1.0))
    added, inside = BlackBox.fitted([Lesson(problem, 1.0 + share)], [rows], names).added(problem.drivers)
    away = (share > query_range[0]) & (share <= query_range[1])
    assert away.sum() > 20 and not inside[away].any() and (added[away] == 0.0).all()
    assert inside[rows].mean() > 0.9 and np.abs(added - 1.0 - share)[rows & inside].max() < 0.2, (
        "it has learnt the rest"
    )


@pytest.mark.long
def test_of_runs_together_it_learns_from_all_and_names_the_one_that_is_not_there(conceal, tmp_path):
    folders = []
    for seed in (7, 8):
        run_folder = tmp_path / "raw" / f"pair-{seed}"
        shutil.copytree(conceal("friction_hysteresis", seed=7)[0], run_folder)
        text = (run_folder / "run.yaml").read_text()
        (run_folder / "run.yaml").write_text(
            text.replace(conceal("friction_hysteresis", seed=7)[0].name, run_folder.name)
        )
        folders.append(run_folder)
    diagnosis = diagnosed(folders, tmp_path / "out", "--together", "--without", "friction_hysteresis")
    _, printed = simulated(folders[1], diagnosis, tmp_path / "more.csv", "--residual")
    assert "of the strokes of pair-7 and pair-8" in printed
    shutil.rmtree(folders[0])
    words = (folders[1], "--simulation", diagnosis, "--residual", "--out", tmp_path / "less.csv")
    done = programs.run("pipeline.simulate", *words)
    assert done.returncode == 2 and "run: names pair-7, whose recording is not at" in done.stderr
    assert "put that run's folder beside the one that is simulated" in done.stderr
    assert not (tmp_path / "less.csv").exists()


@pytest.mark.long
@pytest.mark.parametrize(
    ("without_last", "field"),
    [
        (None, "without_last_strokes: is not in it"),
        ({"seen_s": [1.0]}, "without_last_strokes: holds"),
        ({"seen_s": [], "parameters": {}, "simulation": []}, "without_last_strokes.seen_s: holds 0 numbers for 1 runs"),
    ],
)
def test_a_diagnosis_that_cannot_say_what_it_is_worth_is_refused_with_the_mend(
    unexplained, tmp_path, without_last, field
):
    folder, diagnosis = unexplained
    content = json.loads(diagnosis.read_text()) | {"without_last_strokes": without_last}
    (tmp_path / "old.json").write_text(json.dumps(content))
    words = (folder, "--simulation", tmp_path / "old.json", "--residual", "--out", tmp_path / "out.csv")
    done = programs.run("pipeline.simulate", *words)
    assert done.returncode == 2 and field in done.stderr
    assert "Mend: diagnose again, python -m pipeline.diagnose" in done.stderr and not (tmp_path / "out.csv").exists()


@pytest.mark.long
def test_without_a_diagnosis_it_is_refused_with_the_mend(unexplained, tmp_path):
    done = programs.run("pipeline.simulate", unexplained[0], "--residual", "--out", tmp_path / "out.csv")
    assert done.returncode == 2 and "--residual: needs the diagnosis.json that was adopted" in done.stderr
