"""What a person reads of a moving mass: its page, its planned motion, its adopted numbers; no word of a string."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.rig.others import cases
from pipeline.rig.others.made import write_run

RUBS, TIES = ("mass-coulomb", 801), ("mass-three", 802)


def program(*words):
    """Run a module of the package; it must succeed."""
    done = programs.run(*words)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def diagnosed_case(place: Path, case: tuple[str, int]) -> Path:
    """The run folder of a case that was made and diagnosed; its verdict lies beside it, under `dia`."""
    folder = place / "raw" / case[0]
    write_run(cases.make(*case), folder)
    program("pipeline.diagnose", folder, "--out", place / "dia")
    return folder


@pytest.fixture(scope="module")
def rubbing(tmp_path_factory):
    return diagnosed_case(tmp_path_factory.mktemp("rubs"), RUBS)


def softly(share):
    return share**3 * (10.0 - 15.0 * share + 6.0 * share**2)


def planned(path: Path, step_s: float) -> Path:
    """A stroke of 0.2 m that starts and ends softly, a row every `step_s`."""
    time_s = np.arange(0.0, 8.0, step_s)
    way = np.where(time_s < 4.0, softly(np.clip(time_s / 4.0, 0.0, 1.0)), softly(np.clip(2.0 - time_s / 4.0, 0.0, 1.0)))
    pd.DataFrame({"time_s": time_s, "position_m": 0.2 * way}).to_csv(path, index=False)
    return path


def simulated(folder: Path, motion: Path, out: Path, *options: str):
    diagnosis_path = folder.parents[1] / "dia" / folder.name / "diagnosis.json"
    command = ["pipeline.simulate", folder, "--simulation", diagnosis_path, "--motion", motion, "--out", out, *options]
    return programs.run(*command)


def test_the_loop_that_is_foretold_is_that_of_the_friction_without_what_accelerates_the_mass(rubbing):
    content = json.loads((rubbing.parents[1] / "dia" / rubbing.name / "diagnosis.json").read_text())
    best, *_ = content["evidence"]["expected"]["explanations"]
    assert best["loop_half_speed_n"] == pytest.approx(30.0, abs=2.0), "half the loop is 15 N"
    assert best["loop_as_before_n"] == pytest.approx(best["recorded"]["loop_n"], rel=0.1)


def test_its_pages_ask_for_rows_and_not_corners_and_know_no_up_no_down_and_no_effect_of_strings(rubbing):
    place = rubbing.parents[1] / "dia" / rubbing.name
    verdict, details = (" ".join((place / f"{name}.txt").read_text().split()) for name in ("verdict", "details"))
    for text in (verdict, details):
        assert "at your controller's rate; the force needs the acceleration" in text and "corners will do" not in text
        assert "half the usual speed, and compare its loop with" in text
        assert "the way forward" in text and "the way back" in text and "the way up" not in text
    assert "the way forward and the way back differ by a rounded loop" in verdict
    assert "No percentage is known on this rig." in verdict
    assert "overtwist" not in details and "jam" not in details and "shaft_windup" not in details
    assert "at the far end" in details and "rig without a drive" not in details


def test_a_smooth_plan_gets_no_warning_of_a_jump_and_no_load(rubbing, tmp_path):
    done = simulated(rubbing, planned(tmp_path / "plan.csv", 0.01), tmp_path / "out.csv")
    assert done.returncode == 0, done.stderr
    assert "beware" not in done.stdout and "string" not in done.stdout
    alone = pd.read_csv(tmp_path / "out.csv")
    assert "load_n" not in alone
    after = simulated(rubbing, tmp_path / "plan.csv", tmp_path / "after.csv", "--after-recording")
    assert after.returncode == 0, after.stderr
    gone_on = pd.read_csv(tmp_path / "after.csv")
    assert np.abs(gone_on["force_n"] - alone["force_n"]).max() < 5.0, "the way to the plan adds no force of its own"


def test_a_corner_of_a_plan_is_outside_for_no_recorded_stroke_was_accelerated_so_hard(rubbing, tmp_path):
    time_s = np.arange(0.0, 6.0, 0.001)
    cornered = 0.1 * np.clip(np.minimum(time_s - 0.4, 5.7 - time_s), 0.0, 2.45)
    pd.DataFrame({"time_s": time_s, "position_m": cornered}).to_csv(tmp_path / "plan.csv", index=False)
    done = simulated(rubbing, tmp_path / "plan.csv", tmp_path / "out.csv")
    assert re.search(
        r"it asks for accelerations of up to [0-9.]+ m/s² \(inside up to [0-9.]+: the hardest that", done.stderr
    )
    assert "round the corners, so that nothing accelerates by more than" in done.stderr
    table = pd.read_csv(tmp_path / "out.csv")
    assert (table.loc[table["force_n"].abs() > 500.0, "outside"] == 1.0).all() and 0.0 < table["outside"].mean() < 0.05
    smooth = simulated(rubbing, planned(tmp_path / "soft.csv", 0.01), tmp_path / "out.csv")
    assert "accelerations" not in smooth.stderr


def test_the_plan_of_the_page_is_smooth_enough_and_nothing_of_it_is_outside(rubbing, tmp_path, monkeypatch):
    page = (Path(__file__).parents[2] / "docs/simulate.md").read_text()
    lines = re.search(r"```python\n(.*?)```", page, re.S)[1]
    monkeypatch.chdir(tmp_path)
    exec(lines, {})
    done = simulated(rubbing, tmp_path / "plan.csv", tmp_path / "out.csv")
    assert done.returncode == 0 and not done.stderr, done.stderr
    assert (pd.read_csv(tmp_path / "out.csv")["outside"] == 0.0).all()


def test_a_plan_that_begins_in_motion_is_no_trace_of_an_effect(rubbing, tmp_path):
    time_s = np.arange(0.0, 6.0, 0.001)
    swing = 0.03 * (1.0 - np.cos(2.0 * np.pi * time_s / 2.0))
    pd.DataFrame({"time_s": time_s, "position_m": swing}).to_csv(tmp_path / "plan.csv", index=False)
    done = simulated(rubbing, tmp_path / "plan.csv", tmp_path / "out.csv")
    assert done.returncode == 0 and "leaves its trace" not in done.stdout
    table = pd.read_csv(tmp_path / "out.csv")
    assert table["force_n"][1000] < 0.0 < table["force_n"][0] < 0.7 * table["force_n"][2000], "its first row is halved"


def test_the_loop_of_a_plan_stands_beside_what_the_acceleration_takes(rubbing, tmp_path):
    samples = pd.read_parquet(rubbing / "recording.parquet")
    samples[["time_s", "position_m"]].to_csv(tmp_path / "plan.csv", index=False)
    printed = simulated(rubbing, tmp_path / "plan.csv", tmp_path / "out.csv").stdout
    assert re.search(r"the way back +difference +loop without the acceleration$", printed, re.M)
    loops = [float(loop) for loop in re.findall(r"\+([0-9.]+) N$", printed, re.M)]
    assert len(loops) > 5 and max(loops) - min(loops) < 1.0, "dry friction has the same loop everywhere"


def test_an_error_of_a_mass_stands_beside_the_noise_and_what_no_effect_would_leave(rubbing, tmp_path):
    diagnosis = rubbing.parents[1] / "dia" / rubbing.name / "diagnosis.json"
    fit = json.loads(diagnosis.read_text())["fit"]
    words = ("--simulation", diagnosis, "--out", tmp_path / "own.csv")
    printed = program("pipeline.simulate", rubbing, *words)
    assert "force_n is computed of position_m. The recorded force_n is read only to compare:" in printed
    rows = dict(re.findall(r"^  (\S.*?\S) {2,}([0-9.]+) N$", printed, re.M))
    assert float(rows["the noise of the readings"]) == pytest.approx(fit["noise_floor_n"], rel=0.05)
    unseen = rows[f"strokes of {rubbing.name} that no fit had seen"]
    assert float(unseen) == pytest.approx(fit["heldout"]["explained_n"], rel=0.05)
    assert float(rows["without friction_hysteresis, same dimensions"]) > 5.0 * float(unseen)
    assert f"so its error on {rubbing.name} is no test of it" in " ".join(printed.split())
    other = tmp_path / "raw" / "other-day"
    write_run(cases.make(*RUBS, take=1), other)
    printed = " ".join(program("pipeline.simulate", other, *words).split())
    assert re.search(
        rf"the error is [01]\.[0-9] times .*: the diagnosis of {rubbing.name} holds in other-day too", printed
    )


@pytest.mark.parametrize("step_s", [2.0, 0.3])
def test_corners_of_a_mass_are_refused_with_what_to_give(rubbing, tmp_path, step_s):
    done = simulated(rubbing, planned(tmp_path / "plan.csv", step_s), tmp_path / "out.csv")
    assert done.returncode == 2 and "at your controller's rate" in done.stderr, done.stderr


def test_the_numbers_that_it_adopted_are_explained_without_a_string(rubbing):
    output = program("pipeline.adopt", rubbing.parents[1] / "dia" / rubbing.name / "diagnosis.json", rubbing)
    assert "another run of the rig" in " ".join(output.split())
    printed = program("pipeline.adopt", "--explain", rubbing)
    assert not re.search(r"^ *$", printed.rstrip("\n"), re.M), (
        "a formula whose letters need no words left an empty line"
    )
    explained = " ".join(printed.split())
    program("pipeline.adopt", "--remove", rubbing)
    assert "it multiplies the direction of motion, from -1 to 1" in explained and "twist" not in explained
    assert re.search(r"h 1[0-9.]* N half the loop s calculated the direction of motion", explained)


def test_an_error_of_a_mass_is_of_averages_on_every_page_and_says_so(rubbing, tmp_path):
    diagnosis = rubbing.parents[1] / "dia" / rubbing.name / "diagnosis.json"
    evidence = json.loads(diagnosis.read_text())["evidence"]
    assert evidence["scored_step_s"] == 0.01 and "single_floor_n" not in evidence
    pages = [(diagnosis.parent / name).read_text() for name in ("verdict.txt", "details.txt")]
    assert all("of averages of 0.01 s" in page and "single samples" not in page for page in pages)
    printed = program("pipeline.simulate", rubbing, "--simulation", diagnosis, "--out", tmp_path / "own.csv")
    assert re.search(r"rms error against the recording: [0-9.]+ N, of averages of 0.01 s\n", printed)
    printed = program("pipeline.adopt", diagnosis, shutil.copytree(rubbing, tmp_path / rubbing.name))
    assert "on this recording, rms of averages of 0.01 s" in printed
    assert "On unseen ones the verdict says " in " ".join(printed.split()), "its keys end in n, and its unit is N"


def test_nine_of_ten_averages_of_a_mass_lie_in_the_band_of_the_recorded_motion(rubbing, tmp_path):
    samples, plan, out = pd.read_parquet(rubbing / "recording.parquet"), tmp_path / "plan.csv", tmp_path / "band.csv"
    samples[["time_s", "position_m"]].to_csv(plan, index=False)
    done = simulated(rubbing, plan, out)
    assert done.returncode == 0, done.stderr
    assert "nine of ten readings, averaged over 0.01 s, lie between them" in " ".join(done.stdout.split())
    band = pd.read_csv(out).assign(measured_n=samples["force_n"])
    means = band.groupby(np.arange(len(band)) // 10).mean()
    assert np.mean((means["measured_n"] - means["force_n"]).abs() <= 0.5 * (means["high_n"] - means["low_n"])) > 0.85


@pytest.mark.long
def test_a_tie_without_percentages_lists_its_explanations(tmp_path):
    folder = diagnosed_case(tmp_path, TIES)
    place = tmp_path / "dia" / folder.name
    content, lines = (
        json.loads((place / "diagnosis.json").read_text()),
        (place / "verdict.txt").read_text().splitlines(),
    )
    assert content["verdict"] == "ambiguous"
    head = lines.index("Explanations, the best one first")
    sets = [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]
    for ids, line in zip(sets, lines[head + 1 :], strict=False):
        assert line.strip().startswith(f"{' + '.join(ids)} ") and " leaves " in line
    assert lines[head + 1 + len(sets)].strip() == "No percentages on this rig: they were learnt on strings."
    assert "mm:" not in " ".join((place / "details.txt").read_text().split()).partition("most near")[2][:12]
