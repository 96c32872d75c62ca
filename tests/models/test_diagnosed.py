"""The diagnosed simulator foresees a made string whose effects a diagnosis can find, and is plain where it cannot."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from first_few import first_few
from made_dataset import LOAD_N, STRING, ZONE, made_dataset

from pipeline.diagnosis.recording.working_samples import PHASES
from pipeline.ground.kinematics import Geometry
from pipeline.models.diagnosed import SAMPLES, Diagnosed, run_of
from pipeline.models.interface import make_model
from pipeline.models.parts.diagnosed.diagnosed_problem import along, holed, plain
from pipeline.models.parts.diagnosed.filled_motion import Motion, one_way
from pipeline.models.parts.saved import read_json
from pipeline.models.traditional import Traditional
from pipeline.run import strokes

NOISE_MM = 0.03  # of made_dataset
QUICK = ("clamp_slip", "count_slip", "load_swing", "overtwist", "stick_slip", "thermal")


def rmse(error: pd.Series) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def packed(per_phase: int = 60) -> pd.DataFrame:
    """A string of which nothing is hidden but that its bundle is pressed thinner the steeper its strands run."""
    points = made_dataset(per_phase, 5)
    open_mm = ZONE["separator_mm"] + 2.0 * np.pi * STRING["radius_mm"] * points["motor_turns"].to_numpy()
    steepness = np.arctan2(open_mm, ZONE["torsion_zone_mm"])
    string = Geometry("separator", **{**STRING, "radius_mm": STRING["radius_mm"] * np.cos(steepness) ** 1.5}, **ZONE)
    noise_mm = np.random.default_rng(5).normal(0.0, NOISE_MM, len(points))
    return points.assign(displacement_mm=string.contraction_mm(points["motor_turns"], LOAD_N) + noise_mm)


@pytest.fixture(scope="module", params=first_few(["within", "later"]))
def case(request: pytest.FixtureRequest) -> tuple[Diagnosed, pd.DataFrame, pd.DataFrame]:
    """The model of the made string with a play, a bundle that compacts and a growth; training and held-out points."""
    points = made_dataset(per_phase=150)
    train, test = (points[points[request.param] == part] for part in ("train", "test"))
    model = Diagnosed()
    model.fit(train, 0)
    return model, train, test


@pytest.mark.long
def test_it_is_five_times_better_than_better_dimensions(case: tuple[Diagnosed, pd.DataFrame, pd.DataFrame]) -> None:
    model, train, test = case
    calibrated = make_model("calibrated")
    calibrated.fit(train, 0)
    for column, map_ in (("displacement_mm", "forward"), ("motor_turns", "inverse")):
        hidden = test.assign(**{column: np.nan})
        error, plain = (rmse(getattr(candidate, map_)(hidden) - test[column]) for candidate in (model, calibrated))
        assert error < plain / 5.0, (map_, error, plain)


def test_at_points_with_holes_between_drivers_are_those_of_the_whole_motion() -> None:
    points = made_dataset(per_phase=60)
    seen = points[points["within"] == "train"].sort_values("time_s").drop_duplicates("time_s").reset_index(drop=True)
    run, motion = run_of(seen), Motion.of(seen[SAMPLES])
    whole = along(run, motion.evenly(motion.step_s), float(motion.time_s[0])).drivers
    drivers = holed(run, seen[SAMPLES], frozenset()).drivers
    for name in ("rate", "moved", "path"):
        expected = np.interp(drivers.elapsed_s, whole.elapsed_s, getattr(whole, name))
        np.testing.assert_array_equal(getattr(drivers, name), expected, err_msg=name)


def test_events_are_timed_from_the_start_that_is_given() -> None:
    points = made_dataset(per_phase=60).sort_values("time_s").drop_duplicates("time_s").reset_index(drop=True)
    started_s = float(points["time_s"].iloc[0]) - 100.0
    drivers = plain(run_of(points), points[SAMPLES], started_s).drivers
    np.testing.assert_array_equal(drivers.elapsed_s, points["time_s"] - started_s)
    assert drivers.time_s[0] == 0.0


@pytest.mark.long
def test_it_predicts_its_training_points_as_its_fit_did(case: tuple[Diagnosed, pd.DataFrame, pd.DataFrame]) -> None:
    """The fit sees motion with holes, and the forward map does not: what acts must not feel the difference."""
    model, train, _ = case
    assert rmse(model.forward(train) - train["displacement_mm"]) < 1.15 * NOISE_MM


def test_its_inverse_undoes_its_forward(case: tuple[Diagnosed, pd.DataFrame, pd.DataFrame]) -> None:
    model, _, test = case
    predicted = test.assign(displacement_mm=model.forward(test), motor_turns=np.nan)
    error = model.inverse(predicted) - test["motor_turns"]
    assert rmse(error) < 0.003 and np.abs(error).max() < 0.03  # turns


def test_what_it_names_and_what_acts_is_in_the_file(tmp_path: Path) -> None:
    points = packed()
    model = Diagnosed(without=QUICK)
    model.fit(points, 0)
    model.save(tmp_path / "model.json")
    content = read_json(tmp_path / "model.json")
    (simulator,) = content["simulators"]
    assert simulator["verdict"] == "explained" and simulator["named"] == [["radius_compaction"]]
    assert "radius_compaction" in [act["id"] for act in simulator["acts"]]
    assert content["without"] == list(QUICK)
    assert rmse(model.forward(points) - points["displacement_mm"]) < 1.1 * NOISE_MM


def test_a_run_that_was_never_seen_is_nominal(case: tuple[Diagnosed, pd.DataFrame, pd.DataFrame]) -> None:
    model, _, test = case
    stranger = test.assign(run="stranger")
    mixed = pd.concat([stranger, test], ignore_index=True)
    for map_ in ("forward", "inverse"):
        nominal = getattr(Traditional(), map_)(stranger)
        np.testing.assert_array_equal(getattr(model, map_)(stranger), nominal)
        both = [nominal, getattr(model, map_)(test)]
        np.testing.assert_array_equal(getattr(model, map_)(mixed), np.concatenate(both))


def test_where_nothing_is_missing_nothing_acts(pair_points: pd.DataFrame) -> None:
    model = Diagnosed(without=QUICK)
    model.fit(pair_points, 0)
    (simulator,) = model.simulators.values()
    assert simulator.verdict in ("consistent", "parameters") and not simulator.acts and not simulator.named
    assert rmse(model.forward(pair_points) - pair_points["displacement_mm"]) < 1.1 * NOISE_MM


def test_too_few_points_for_a_diagnosis_are_calibrated_and_hardly_any_are_nominal() -> None:
    points, model = made_dataset(60, 1), Diagnosed()
    model.fit(points.iloc[:12], 0)
    np.testing.assert_array_equal(model.forward(points), Traditional().forward(points))
    model.fit(points.iloc[:40], 0)
    (simulator,) = model.simulators.values()
    assert "cannot be told from what comes with the motion" in simulator.verdict and not simulator.acts
    seen = points.iloc[:40]
    error, nominal = (rmse(candidate.forward(seen) - seen["displacement_mm"]) for candidate in (model, Traditional()))
    assert error < 0.5 * nominal and np.isfinite(model.inverse(points)).all()


def test_points_without_any_noise_are_calibrated() -> None:
    points, model = made_dataset(60, 4), Diagnosed()
    exact = points.assign(displacement_mm=Traditional().forward(points))
    model.fit(exact, 0)
    assert rmse(model.forward(exact) - exact["displacement_mm"]) < 1e-3
    assert rmse(model.inverse(exact) - exact["motor_turns"]) < 1e-2


def test_a_reversal_where_a_play_has_no_slope_does_not_throw_the_inverse() -> None:
    points, model = made_dataset(51, 2), Diagnosed(without=QUICK[:2])
    model.fit(points, 0)
    error = np.abs(model.inverse(points) - points["motor_turns"])
    assert error[points["motor_turns"] > 4.0].max() < 1.0 and error.max() < 2.0  # the first turns hardly contract


def test_a_mechanism_that_does_not_exist_is_refused() -> None:
    with pytest.raises(ValueError, match="gremlins is no mechanism"):
        Diagnosed(without=("gremlins",))


def test_a_motion_through_a_long_pause_stays_short() -> None:
    time_s = np.concatenate([np.arange(0.0, 10.0, 0.1), 36000.0 + np.arange(0.0, 10.0, 0.1)])
    stroke, phase = np.repeat([1, 2], 100), np.repeat(["unwinding", "winding"], 100).astype(object)
    even = Motion(time_s, np.sin(time_s), np.full(len(time_s), 20.0), stroke, phase).evenly(0.1)
    assert len(even.time_s) < 500 and even.time_s[0] == 0.0 and even.time_s[-1] == time_s[-1]
    near = np.interp(time_s, even.time_s, even.motor_turns)
    np.testing.assert_allclose(near[5:95], np.sin(time_s[5:95]), atol=2e-3)
    second = even.time_s >= time_s[100]  # a pause belongs to the stroke that it follows
    assert set(even.stroke[second]) == {2} and set(even.stroke[~second]) == {1}
    assert set(even.phase[second]) == {"winding"} and set(even.phase[~second]) == {"unwinding"}


def test_points_are_in_the_strokes_that_the_recording_was_cut_into_and_are_never_cut_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of a string's second run the strokes go on, one was lost, and no point of a hold or a rest is there."""
    points = made_dataset(per_phase=60)
    points = points[points["stroke"] != 4].assign(stroke=lambda table: table["stroke"] + 10)
    points = points.sort_values("time_s").drop_duplicates("time_s").reset_index(drop=True)

    def never(motion: object) -> None:
        raise AssertionError("the recording was cut into strokes before")

    monkeypatch.setattr(strokes, "_stretches", never)
    run = run_of(points)
    drivers = [holed(run, points[SAMPLES], frozenset()).drivers, plain(run, points[SAMPLES], 0.0).drivers]
    for each in drivers:
        np.testing.assert_array_equal(each.stroke, points["stroke"])
        assert [PHASES[place] for place in each.phase] == points["phase"].tolist()
    whole = along(run, Motion.of(points).evenly(0.1), 0.0).drivers
    assert sorted(set(whole.stroke)) == sorted(set(points["stroke"]))
    model = Diagnosed(without=QUICK)
    model.fit(points, 0)
    assert np.isfinite(model.forward(points)).all() and np.isfinite(model.inverse(points)).all()


@pytest.mark.parametrize("rising", [True, False])
def test_a_way_goes_evenly_through_noisy_estimates(rising: bool) -> None:
    time_s = np.linspace(0.0, 10.0, 400)
    true = 2.0 * time_s if rising else -2.0 * time_s
    noisy = true + np.random.default_rng(1).normal(0.0, 0.1, 400)
    way = one_way(time_s, noisy, np.ones(400), rising)
    assert rmse(pd.Series(way - true)) < 0.05 and rmse(pd.Series(noisy - true)) > 0.09
