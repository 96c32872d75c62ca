"""The black boxes see no more than the diagnosis, learn what there is, and carry over what they learnt."""

import json

import numpy as np
import pandas as pd
import pytest
from made_recording import content, recording

from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study import heldout
from pipeline.diagnosis.study.engine import make_problem
from pipeline.ground.stored.files import write_text
from pipeline.real import transfer
from pipeline.real.asked_recording import About
from pipeline.real.black_box import Asked, first_held_out, held_out
from pipeline.real.black_boxes import looks
from pipeline.real.features import averaged, features, low_pass, memory, span_of
from pipeline.real.runs_to_make import ALL_OTHERS
from pipeline.run import strokes
from pipeline.run.samples import read_samples, read_strokes
from pipeline.run.strokes import segment
from pipeline.string.from_raw import read


@pytest.fixture
def jaw(make_run):
    """A cable drive of gear 0.9 whose jaw comes late after every turn by half of `play_deg`."""

    def make(name, play_deg=3.0, amplitude_deg=60.0, seed=0, constant_deg=70.0):
        random = np.random.default_rng(seed)
        time_s = np.arange(0.0, 16.0, 0.02)
        motor = amplitude_deg / 2 * (1 - np.cos(np.pi * time_s))
        jaw = 0.9 * (motor - play_deg / 2 * memory(motor, play_deg / 2)) + constant_deg
        jaw += 0.02 * random.standard_normal(len(time_s))
        table = pd.DataFrame({"time_s": time_s, "motor_deg": motor, "jaw_deg": jaw})
        return make_run(name, table, actuator="cable_drive", rig={"gear_ratio": 0.9}, string=None)

    return make


def test_features_do_not_look_at_what_is_to_be_predicted():
    samples = recording(2)
    spoilt = samples.assign(displacement_mm=np.arange(len(samples)) ** 2.0)
    pd.testing.assert_frame_equal(features(samples, 27.0), features(spoilt, 27.0))
    assert "load_n" in features(samples, 27.0)


def test_memory_turns_over_its_width_and_stays():
    motion = np.array([0.0, 1.0, 2.0, 5.0, 4.0, 3.0, 2.0])
    assert memory(motion, 2.0).tolist() == [0.0, 0.5, 1.0, 1.0, 0.5, 0.0, -0.5]


def test_rates_are_those_of_the_motion():
    time_s = np.arange(0.0, 10.0, 0.001)
    samples = pd.DataFrame({"time_s": time_s, "position_m": np.sin(time_s), "force_n": 0.0})
    for smoothed in (True, False):
        table = features(samples, 2.0, smoothed)[500:-500]
        assert np.abs(table["rate"] - np.cos(time_s[500:-500])).max() < 1e-3
        assert np.abs(table["acceleration"] + np.sin(time_s[500:-500])).max() < 1e-2
    quick = np.sin(2 * np.pi * 200 * time_s)
    assert np.abs(low_pass(quick, 0.001, 20.0)[500:-500]).max() < 1e-3
    assert averaged(samples, 4).iloc[1].to_numpy() == pytest.approx(samples.iloc[4:8].mean().to_numpy())


@pytest.mark.parametrize("strokes", [2, 3, 5, 10])
def test_what_is_held_out_is_what_the_diagnosis_holds_out(make_run, strokes):
    run, samples, cut = read_strokes(make_run("a-01", recording(strokes)))
    problem = make_problem([RecordedRun.cut(run, samples)])
    row = heldout.first_held_out(problem)
    ours = first_held_out(samples, cut)
    assert (row is None) == (ours is None)
    if row is not None:
        assert samples["time_s"].iloc[ours] == pytest.approx(problem.record.time_s[row], abs=0.1)


@pytest.mark.long
def test_each_method_learns_play_that_no_straight_line_holds(jaw):
    run, samples, strokes = read_strokes(jaw("a-01"))
    errors = held_out(run, samples, strokes)
    assert set(errors) == set(looks())
    slope, constant = np.polyfit(samples["motor_deg"], samples["jaw_deg"], 1)
    straight = float(np.std(samples["jaw_deg"] - slope * samples["motor_deg"] - constant))
    assert all(error < straight / 4 for error in errors.values()), (errors, straight)
    assert held_out(run, samples, strokes) == errors  # the seeds are fixed
    first = samples.iloc[: len(samples) // 8]  # one stroke teaches nothing about the next
    assert held_out(run, first, segment(first, "motor_deg", "first")) is None


def test_the_reading_is_compared_at_the_rate_at_which_the_diagnosis_works(jaw):
    run, samples = read_samples(jaw("a-01"))
    compared = Asked.of(run, samples, span_of(samples))
    width = 1 if run.system.working_hz is None else max(1, round(50.0 / run.system.working_hz))
    assert len(compared.measured) == len(compared.table) == -(-len(samples) // width)


@pytest.mark.long
def test_what_was_learnt_on_one_recording_predicts_another_but_for_its_zero(jaw, tmp_path):
    folders = [jaw("a-01", seed=1), jaw("a-02", seed=2, amplitude_deg=50.0, constant_deg=20.0)]
    runs = {folder.name: About(read(folder)) for folder in folders}
    diagnoses = {name: tmp_path / name / "diagnosis.json" for name in runs}
    diagnoses["a-01"].parent.mkdir()
    content = {"parameters": {"gear_ratio": {"value": 0.9}}, "simulation": []}
    diagnoses["a-01"].write_text(json.dumps(content))
    rows = pd.DataFrame(transfer.of_group(runs, diagnoses))
    assert set(rows["method"][rows["learnt_from"] == "a-01"]) == {"nominal", "explained", *looks()}
    assert set(rows["method"][rows["learnt_from"] == "a-02"]) == set(looks())  # which has no diagnosis
    own = rows.set_index(["learnt_from", "method"])["rms"]
    assert own["a-01", "explained"] == own["a-01", "nominal"]  # the gear is right, and nothing else was found
    assert own["a-01", "explained"] > 0.9  # half of 3 deg of play, by 0.9, and the first second's zero
    assert all(own["a-01", method] < own["a-01", "nominal"] / 2 for method in looks()), own
    assert (rows["centred_rms"] <= rows["rms"] + 1e-9).all() and set(rows["unit"]) == {"deg"}


@pytest.mark.long
def test_all_others_together_teach_what_a_recording_left_out_shows(jaw, tmp_path, monkeypatch):
    shown = {"a-01": (60.0, 70.0), "a-02": (50.0, 20.0), "a-03": (40.0, -30.0)}
    folders = {name: jaw(name, amplitude_deg=top, constant_deg=zero) for name, (top, zero) in shown.items()}
    runs = {name: About(read(folder)) for name, folder in folders.items()}
    calls = []

    def ask(others, out, reader, beside):
        assert all(reader(folder) is runs[folder.name].recorded for folder in others)  # none is read again
        calls.append(([folder.name for folder in others], out.name))
        out.mkdir(parents=True)
        gear = 0.5 if out.name == "a-01" else 0.91
        content = {"parameters": {"gear_ratio": {"value": gear}}, "simulation": []}
        (out / "diagnosis.json").write_text(json.dumps(content))

    monkeypatch.setattr(transfer, "ask", ask)
    rows = pd.DataFrame(transfer.left_out(runs, tmp_path / "others"))
    assert calls == [(["a-02", "a-03"], "a-01"), (["a-01", "a-03"], "a-02"), (["a-01", "a-02"], "a-03")]
    assert set(rows["learnt_from"]) == {ALL_OTHERS} and len(rows) == 3 * (2 + len(looks()))
    of_run = rows.pivot(index="asked_about", columns="method", values="rms")
    assert of_run["explained"]["a-01"] == of_run["nominal"]["a-01"], "a gear that fails on the first stroke is left out"
    assert (of_run["explained"] != of_run["nominal"])[["a-02", "a-03"]].all(), "one that holds there is taken as said"
    errors = rows.groupby("method")["rms"].max()
    assert all(errors[method] < errors["nominal"] / 2 for method in looks()), errors
    assert transfer.left_out({name: runs[name] for name in ("a-01", "a-02")}, tmp_path / "none") == []
    assert (tmp_path / "none").is_dir()  # which the workflow waits for


@pytest.mark.long
@pytest.mark.parametrize("kind", ["jaw", "string"])
def test_transfer_reads_and_cuts_each_recording_once(jaw, make_run, tmp_path, monkeypatch, kind):
    """For every pair, for the diagnoses of all but one, and for the zeros of a string's runs that lie beside."""
    names, cuts, cut = ("a-01", "a-02", "a-03"), [], strokes._stretches
    described = {"string": {**content("a-01")["string"], "id": "a"}}
    folders = [jaw(name, seed=seed) if kind == "jaw" else make_run(name, recording(seed=seed), **described)
               for seed, name in enumerate(names)]  # fmt: skip
    for folder in folders:
        write_text(tmp_path / "verdicts" / folder.name / "diagnosis.json", '{"parameters": {}, "simulation": []}')
    words = ["--group", "a", "--diagnoses", tmp_path / "verdicts", "--others", tmp_path / "others"]
    monkeypatch.setattr("sys.argv", ["transfer", *map(str, [*folders, *words, "--out", tmp_path / "a.csv"])])
    monkeypatch.setattr(strokes, "_stretches", lambda motion: cuts.append(motion) or cut(motion))
    monkeypatch.setattr(transfer, "looks", list)  # which cut nothing
    with pytest.raises(SystemExit) as ended:
        transfer.main()
    assert not ended.value.code
    assert len(cuts) == 3
    assert all((tmp_path / "others" / name / "diagnosis.json").is_file() for name in names)


def test_recordings_joined_keep_the_columns_that_all_have_and_a_zero_each():
    compared, other = (Asked(pd.DataFrame({"motion": [0.0, 1.0], name: 0.0}), np.ones(2), np.ones(2), np.zeros(2, int))
                  for name in ("load_n", "x"))  # fmt: skip
    assert list(Asked.joined([compared, other], True).table) == ["motion"]
    assert Asked.joined([compared, other], True).zero.tolist() == [0, 0, 1, 1]
    assert Asked.joined([compared, other], False).zero.tolist() == [0, 0, 0, 0]


def test_the_zero_is_set_on_the_first_second_alone():
    time_s = np.arange(0.0, 4.0, 0.5)
    measured = np.where(time_s <= 1.0, 5.0, 7.0)
    first, best = transfer.errors(np.zeros(8), measured, time_s, tared=True)
    assert first == pytest.approx(2.0 * np.sqrt(5 / 8)) and best == pytest.approx(measured.std())
    whole, same = transfer.errors(np.zeros(8), measured, time_s, tared=False)
    assert whole == same == pytest.approx(np.sqrt(np.mean(measured**2)))
