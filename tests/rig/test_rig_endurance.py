"""Strings that are worked to their end: they age as their equations say, and the truth is what the rig did."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pipeline.ground.kinematics import RAD_PER_TURN, Geometry
from pipeline.rig.effects import friction_hysteresis
from pipeline.rig.endurance import x_fatigue, x_galling
from pipeline.rig.endurance.ageing import made
from pipeline.rig.endurance.life import ENOUGH_LOST, live
from pipeline.rig.endurance.strings_to_wear_out import MOST_STROKES, plan
from pipeline.rig.motion_commands import Motion, commands
from pipeline.rig.string_state import String
from pipeline.run.dimensions import geometry
from pipeline.run.samples import read_samples
from pipeline.run.strokes import segment

ROOT = Path(__file__).parents[2]
GEOMETRY = Geometry("separator", 0.5, 400.0, 15.0, 130.0, 8.0)
STEP_S = 0.05
TOLD = commands(
    Motion.model_validate(
        {
            "rest_s": 1,
            "strokes": [
                {"repeat": 40, "top_turns": 15, "speed_turns_per_s": 5, "hold_s": 1, "rest_s": 1, "load_n": 20}
            ],
        }
    ),
    STEP_S,
)
PLANS = list(plan(2, 100))
COLUMNS = ["run", "stroke", "stroke_mm", "rest_mm", "top_mm", "loop_mm", "drift_mm"]


def drawn(life, strokes=MOST_STROKES):
    """The first string that ages so, to be worked for at most so many strokes; its noise is fresh."""
    return replace(next(planned_life for planned_life in plan(2, 100) if planned_life.life == life), strokes=strokes)


@pytest.fixture(scope="module")
def lives():
    return {life: live(drawn(life), 10.0) for life in ("saturates", "wears", "breaks")}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    out = tmp_path_factory.mktemp("endurance") / "lives"
    command = [sys.executable, "-m", "pipeline.rig.endurance", "--strings", "2", "--seed", "2", "--out", str(out)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return out


def test_every_life_can_be_read_and_has_the_strokes_that_its_truth_tells(folder):
    truth = pd.read_parquet(folder / "truth.parquet")
    assert list(truth.columns) == COLUMNS and not truth.isna().any().any()
    assert sorted(path.name for path in folder.iterdir()) == [*truth.run.unique(), "truth.parquet"]
    for planned in PLANS[:2]:
        run, samples = read_samples(folder / planned.run)
        assert run.run == planned.run and geometry(run) == planned.specimen.measured
        run_truth = truth[truth.run == run.run]
        strokes = segment(samples, "motor_turns", folder)
        windings = strokes[strokes.phase == "winding"]
        assert windings.stroke.tolist() == run_truth.stroke.tolist() == list(range(1, len(run_truth) + 1))
        before = samples.displacement_mm.to_numpy()[windings.first_sample - 2]
        np.testing.assert_allclose(before - before.mean(), run_truth.rest_mm - run_truth.rest_mm.mean(), atol=0.2)
        assert np.std(before - run_truth.rest_mm) < 0.05  # the sensor's noise and quantum


def test_the_same_seed_gives_the_same_lives(folder):
    truth = pd.read_parquet(folder / "truth.parquet")
    for planned in plan(2, 2):
        again = live(planned, 10.0)
        np.testing.assert_array_equal(again.truth, truth[truth.run == planned.run].drop(columns="run"))
        _, samples = read_samples(folder / planned.run)
        np.testing.assert_array_equal(again.samples.displacement_mm, samples.displacement_mm)
    assert [planned_life.ageing for planned_life in plan(2, 5)] == [planned_life.ageing for planned_life in PLANS[:5]]
    assert all(planned_life.ageing != other.ageing for planned_life, other in zip(PLANS, plan(3, 5), strict=False))


def test_the_truth_is_what_the_string_does_in_one_piece():
    planned = drawn("breaks", strokes=40)
    truth = live(planned, 10.0).truth
    stroke, step_s = planned.stroke.model_copy(update={"repeat": 40}), 0.005
    trajectory = commands(Motion(rest_s=3.0, strokes=[stroke]), step_s)
    string = String(planned.specimen.true, made(planned.ageing)[0], step_s)
    pulled_mm = string.pull(trajectory.motor_turns, trajectory.load_n)
    pulled_mm -= pulled_mm[0]
    start, wound, hold_end, end = np.rint(trajectory.strokes_s.T / step_s).astype(int)
    assert len(truth) == 40
    np.testing.assert_allclose(truth.rest_mm, pulled_mm[start], atol=0.02)
    np.testing.assert_allclose(truth.top_mm, pulled_mm[hold_end], atol=0.02)
    np.testing.assert_allclose(truth.stroke_mm, pulled_mm[hold_end] - pulled_mm[start], atol=0.02)
    grid = np.linspace(0.05, 1.0, 39) * planned.stroke.top_turns
    windings, loop_mm = [], []
    for a, b, c, d in zip(start, wound, hold_end, end, strict=True):
        windings.append(np.interp(grid, trajectory.motor_turns[a : b + 1], pulled_mm[a : b + 1]))
        back = np.interp(grid[-1] / 2, trajectory.motor_turns[c : d + 1][::-1], pulled_mm[c : d + 1][::-1])
        loop_mm.append(np.interp(grid[-1] / 2, trajectory.motor_turns[a : b + 1], pulled_mm[a : b + 1]) - back)
    np.testing.assert_allclose(truth.loop_mm, loop_mm, atol=0.02)
    drift_mm = np.sqrt(((np.array(windings) - windings[1]) ** 2).mean(axis=1))
    np.testing.assert_allclose(truth.drift_mm, drift_mm, atol=0.02)
    assert truth.drift_mm[1] == 0.0 < truth.drift_mm[2]


def test_strings_that_fail_only_ever_lose_stroke_when_the_air_stands_still():
    for life in ("wears", "breaks"):
        planned = drawn(life)
        calm = {key: value for key, value in planned.ageing["radius_compaction"].items() if key != "unsteady"}
        truth = live(replace(planned, ageing=planned.ageing | {"radius_compaction": calm}), 10.0).truth
        stroke_mm = truth.stroke_mm.to_numpy()
        assert (np.diff(stroke_mm[5:-1]) < 1e-3).all() and stroke_mm[-2] < 0.9 * stroke_mm[5]
        assert (np.diff(truth.rest_mm[5:]) < 5e-3).all()


def test_a_recording_ends_soon_after_a_quarter_is_lost_and_a_string_that_saturates_never_fails(lives):
    truth = lives["breaks"].truth
    lost = 1.0 - truth.stroke_mm / truth.stroke_mm[1:6].median()
    assert (lost > ENOUGH_LOST).any() and len(truth) <= np.argmax(lost > ENOUGH_LOST) + 9
    lost = 1.0 - lives["saturates"].truth.stroke_mm / lives["saturates"].truth.stroke_mm[1:6].median()
    assert len(lost) == MOST_STROKES and lost.max() < 0.1


def test_some_strings_are_censored_and_some_are_given_up():
    share = {
        life: np.mean([planned_life.life == life for planned_life in PLANS])
        for life in ("saturates", "wears", "breaks")
    }
    assert 0.1 < share["saturates"] < 0.35 and min(share["wears"], share["breaks"]) > 0.25
    given_up = [planned_life.strokes for planned_life in PLANS if planned_life.strokes < MOST_STROKES]
    assert 8 <= len(given_up) <= 35 and min(given_up) >= 100
    assert all(("x_fatigue" in planned_life.ageing) == (planned_life.life == "breaks") for planned_life in PLANS)


def bundle(**parameters):
    return x_fatigue.Model(work_n_mm=1500.0, held_s=1e9, sharing=4.0, **parameters)


def test_the_fibres_follow_their_equation_and_the_end_accelerates():
    even, whole = bundle(), String(GEOMETRY, [], STEP_S).live(TOLD.motor_turns, TOLD.load_n)
    intact_share = even.run(replace(whole, radius_mm=np.full(len(TOLD.time_s), GEOMETRY.radius_mm))) ** 2.0
    turns = np.linspace(0.0, 15.0, 4000)  # one winding's work by another road
    sine = (o := 8.0 + turns * RAD_PER_TURN * 0.5) / np.hypot(o, 130.0)
    damage = 20.0 * np.trapezoid(sine**2 * 0.5, turns * RAD_PER_TURN) / 1500.0
    ends = np.searchsorted(TOLD.time_s, TOLD.strokes_s[:, 3])
    np.testing.assert_allclose(intact_share[ends], (1.0 - damage * np.arange(1, 41)).clip(0.5**4) ** 0.25, rtol=2e-3)
    losses = -np.diff(intact_share[ends][intact_share[ends] > 0.51])
    assert (np.diff(losses) > 0).all() and losses[-1] > 2.0 * losses[0]


def test_fatigue_carries_its_state_however_the_time_is_cut_and_says_when_the_string_is_broken():
    parameters = {"shares": [0.3, 0.2], "periods": [0.1, 0.4], "phases_rad": [0.5, 2.0]}

    def pulled(pieces):
        fatigue = bundle(**parameters)
        friction = x_galling.Model(0.005, 0.1, gain=2.0, rough_turns=500.0)
        string = String(GEOMETRY, [fatigue, x_fatigue.Stretch(fatigue), friction], STEP_S)
        parts = zip(np.array_split(TOLD.motor_turns, pieces), np.array_split(TOLD.load_n, pieces), strict=True)
        return np.concatenate([string.pull(*part) for part in parts]), fatigue

    (whole, fatigue), (cut, _) = pulled(1), pulled(7)
    np.testing.assert_allclose(cut, whole, atol=1e-9)
    assert fatigue.broken and not x_fatigue.Model(work_n_mm=1e9, held_s=1e9, sharing=4.0).broken


def test_galling_makes_the_loop_as_much_wider_as_it_says():
    lived = String(GEOMETRY, [], STEP_S).live(TOLD.motor_turns, TOLD.load_n)
    galled = x_galling.Model(0.005, 0.1, gain=2.0, rough_turns=500.0).run(lived)
    smooth = friction_hysteresis.Model(0.005, 0.1).run(lived)
    at = np.searchsorted(TOLD.time_s, TOLD.strokes_s[:, 1])
    turned = 15.0 * (2.0 * np.arange(40) + 1.0)
    np.testing.assert_allclose(galled[at] / smooth[at], 1.0 + 2.0 * (1.0 - np.exp(-turned / 500.0)), rtol=5e-3)
