"""Of a motion that nobody recorded a diagnosis says how far it may be off, and what each rival says."""

import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.diagnosis.fit.uncertainty import factor
from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.prediction.prediction_band import Foretold, band, curves
from pipeline.diagnosis.prediction.simulation import tared
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.own_rate import at_own_rate
from pipeline.diagnosis.study.rivals import refitted
from pipeline.diagnosis.words.foretold.prediction import in_one_number, of_rivals, of_ties
from pipeline.ground.errors import BadInput
from pipeline.run.samples import read_strokes

LEARNT = 9  # strokes; the band is tried on those after them


def learnt(folder: Path) -> tuple[dict, pd.DataFrame, int]:
    """The diagnosis of a run's first strokes, all of its samples, and how many of them were in those."""
    run, samples, strokes = read_strokes(folder)
    last = int(strokes.loc[strokes["stroke"] == LEARNT, "last_sample"].max())
    content, _ = diagnosed([RecordedRun.cut(run, samples.iloc[: last + 1].reset_index(drop=True), folder=folder)])
    return json.loads(json.dumps(content)), samples, last + 1


@pytest.fixture(scope="module")
def creep(conceal):
    """The run with creep in it, and what was learnt of it."""
    folder = conceal("creep", kappa=3.0)[0]
    return folder, *learnt(folder)


@pytest.mark.long
@pytest.mark.parametrize("kind", ["creep", "friction_hysteresis", "backlash"])
def test_nine_of_ten_readings_that_no_fit_has_seen_lie_in_the_band(conceal, creep, kind):
    folder = conceal(kind, kappa=3.0)[0]
    content, samples, seen = creep[1:] if kind == "creep" else learnt(folder)
    run = read_strokes(folder)[0]
    problem = at_own_rate([RecordedRun.cut(run, samples.assign(displacement_mm=0.0))], thin=False, to_fit=False)
    width = band(problem, content, folder, run.run)
    off = np.abs(samples["displacement_mm"].to_numpy() - tared(problem, content, folder, run.run))[seen:]
    for doubt in (doubt for doubt in content["uncertainty"] if "id" in doubt):
        acting = [entry for entry in content["simulation"] if entry["id"] == doubt["id"]]
        assert doubt["entry"] < len(acting), "each is of something that acts"
    assert np.mean(off <= width.half_width[seen:]) > 0.87
    rows = np.arange(len(samples)) >= seen
    assert np.mean(off <= width.within(rows, [])) > 0.87, "and one number for the whole plan holds as many"
    assert np.mean(width.half_width[seen:]) < 8.0 * 1.645 * np.sqrt(np.mean(off**2)), "it says something"
    assert width.missed >= content["fit"]["noise_floor_mm"]


def test_the_one_number_of_a_plan_holds_nine_of_ten_readings_whichever_explanation_is_right():
    rows, gap = np.arange(4_000) < 3_000, np.full(4_000, 3.0)
    width = Foretold(np.where(rows, 0.6, 50.0), 0.8, True)
    assert width.within(rows, []) == pytest.approx(1.645, abs=1e-3), "what lies outside has no part in it"
    assert width.within(rows, [gap]) == pytest.approx(3.0 + 1.2816, abs=1e-3) == width.within(rows, [-gap, 0.1 * gap])
    rng, mixed = np.random.default_rng(1), np.linspace(-4.0, 4.0, 4_000)
    drawn = np.abs(mixed + np.hypot(0.6, 0.8) * rng.standard_normal(4_000))[rows]
    assert np.mean(drawn <= width.within(rows, [mixed])) == pytest.approx(0.9, abs=0.01)
    assert Foretold(np.zeros(3), 0.0, False).within(np.ones(3, bool), []) < 1e-9


def test_the_one_number_says_over_what_it_holds_and_on_which_condition():
    inside, width = np.arange(100) < 46, Foretold(np.full(100, 0.6), 0.8, True)

    def sentence_of(rows, gaps, tied):
        return " ".join(in_one_number(width, rows, gaps, tied, "displacement_mm", "mm"))

    whole = "to report: nine of ten readings are expected within 1.6 mm of displacement_mm over the whole plan, if the "
    assert sentence_of(np.ones(100, bool), [], 0) == f"{whole}explanation is right"
    assert sentence_of(np.ones(100, bool), [], 1).startswith(f"{whole}best explanation is right, for the file does not")
    gaps = [np.full(100, 3.0), np.zeros(100)]
    assert "within 4.3 mm" in sentence_of(inside, gaps, 2)
    assert "over the 46 % of the plan within what was recorded, whichever of the 3 likely" in sentence_of(
        inside, gaps, 2
    )
    assert not sentence_of(np.zeros(100, bool), gaps, 2)
    few = sentence_of(np.arange(100) < 5, gaps, 2)
    assert few == "nothing to report: the plan is outside what was recorded but for 5 % of it"


def test_by_how_much_another_explanation_differs_is_said_within_what_was_recorded_and_beyond():
    inside, curves = np.arange(10) < 5, {"creep + wear": np.where(np.arange(10) < 5, 0.1, -2.0)}
    (line,) = of_rivals(np.zeros(10), curves, inside, "displacement_mm", "mm")
    reading = (
        "if_creep_and_wear_mm: the reading if the other explanation is right (creep + wear). It differs by at most"
    )
    near = "0.10 mm from displacement_mm within what was recorded and 2.0 mm outside"
    assert line == f"{reading} {near}. Note 1, which is of nine of ten readings, includes it"
    (line,) = of_rivals(np.zeros(10), curves, np.ones(10, bool), "displacement_mm", "mm")
    assert line == f"{reading} 2.0 mm from displacement_mm. Note 1, which is of nine of ten readings, includes it"
    (line,) = of_rivals(np.zeros(10), curves, np.zeros(10, bool), "displacement_mm", "mm")
    assert line == f"{reading} 2.0 mm from displacement_mm", "there is nothing to report"


def test_that_others_are_likely_is_a_warning_only_where_not_each_has_its_column():
    assert not of_ties("creep", 1, ["time_s", "if_wear_mm"]) and not of_ties("creep", 0, ["time_s"])
    assert of_ties("creep", 2, ["if_wear_mm"])[0].startswith("beware: creep is one of 3 likely explanations")
    both = of_ties("creep and wear", 2, ["if_wear_mm"])[0]
    assert both.startswith("beware: the explanation by creep and wear is one of 3 likely explanations")


def test_a_doubt_of_one_dimension_moves_the_band_by_what_that_dimension_moves(creep):
    folder, content, samples, _ = creep
    run = read_strokes(folder)[0]
    problem = at_own_rate([RecordedRun.cut(run, samples)], thin=False, to_fit=False)
    content = content | {"uncertainty": [{"name": "radius_mm", "moves": [0.0, 0.001]}]}
    width = band(problem, content, folder, run.run)
    moved = json.loads(json.dumps(content))
    moved["parameters"]["radius_mm"]["value"] += 0.001
    off = tared(problem, moved, folder, run.run) - tared(problem, content, folder, run.run)
    assert np.ptp(off) > 0.02 and np.allclose(width.sigma, np.abs(off), rtol=0.02, atol=1e-3)
    assert band(problem, content | {"uncertainty": []}, folder, run.run) is None


@pytest.mark.parametrize(
    ("field", "wrong"),
    [
        ("fit", [1]), ("fit", {"noise_floor_mm": 0.01, "heldout": [1]}), ("uncertainty", 5), ("uncertainty", {"a": 1}),
        ("uncertainty", [1]), ("uncertainty", [{"name": "radius_mm", "moves": ["1"]}]),
        ("uncertainty", [{"name": "radius_mm", "moves": [float("nan")]}]),
        ("uncertainty", [{"name": "share", "moves": [0.1], "id": "backlash", "entry": "x"}]),
        ("uncertainty", [{"name": "share", "moves": [0.1], "id": "backlash", "entry": -7}]),
        ("uncertainty", [{"name": "zero_mm", "moves": [1e308]}]), ("alternatives", 5), ("alternatives", [[1]]),
        ("rivals", 5), ("rivals", [1]), ("rivals", [{"ids": ["thermal"]}]),
        ("rivals", [{"ids": ["thermal"], "parameters": 5, "simulation": []}]),
        ("rivals", [{"ids": ["thermal"], "parameters": {}, "simulation": 5}]),
    ],
)  # fmt: skip
def test_a_diagnosis_of_another_form_is_refused_by_its_field(creep, tmp_path, field, wrong):
    folder, content, samples, _ = creep
    run, path = read_strokes(folder)[0], tmp_path / "diagnosis.json"
    problem = at_own_rate([RecordedRun.cut(run, samples)], thin=False, to_fit=False)
    with pytest.raises(BadInput, match=rf"{path}: {field}: .* Mend: give a diagnosis.json as it was made"):
        band(problem, content | {field: wrong}, path, run.run)
        curves(problem, content | {field: wrong}, path, run.run)


def test_all_numbers_of_the_simulator_have_their_doubts(creep):
    _, content, *_ = creep
    dimensions = {doubt["name"] for doubt in content["uncertainty"] if "id" not in doubt}
    assert dimensions == set(content["parameters"])
    acting = {(doubt["id"], doubt["name"]) for doubt in content["uncertainty"] if "id" in doubt}
    for entry in content["simulation"]:
        unsure = {name for id_, name in acting if id_ == entry["id"]}
        assert unsure and unsure & set(entry["parameters"])
    low, high = (content["parameters"]["radius_mm"][end] for end in ("low", "high"))
    moves = next(doubt["moves"] for doubt in content["uncertainty"] if doubt["name"] == "radius_mm")
    assert 0.7 * (high - low) < 2.0 * 1.645 * np.linalg.norm(moves) < 1.001 * (high - low)


def test_a_covariance_that_rounding_spoilt_still_has_a_factor():
    half = np.array([[2.0, 0.0], [1.0, 1e-9]])
    assert np.allclose(factor(half @ half.T) @ factor(half @ half.T).T, half @ half.T)
    assert np.isfinite(factor(np.array([[1.0, 1.0 + 1e-12], [1.0 + 1e-12, 1.0]]))).all()


def test_simulate_gives_the_band_and_the_rivals_of_a_planned_motion_and_says_what_they_are(creep, tmp_path):
    folder, content, samples, _ = creep
    top = float(samples["motor_turns"].max())
    plan, path, out = tmp_path / "plan.csv", tmp_path / "diagnosis.json", tmp_path / "answer.csv"
    motion = {"time_s": [0, 8, 16, 24], "motor_turns": [0, 0.9 * top, 0.9 * top, 0], "load_n": 15.0}
    pd.DataFrame(motion).to_csv(plan, index=False)
    rival = {"ids": ["thermal", "x_fit"], "parameters": content["parameters"], "simulation": []}
    gone = rival | {"ids": ["wear"]}
    path.write_text(json.dumps(content | {"alternatives": [rival["ids"]], "rivals": [rival, gone]}))
    words = ["--simulation", path, "--motion", plan, "--out", out]
    done = programs.run("pipeline.simulate", folder, *words)
    answer = pd.read_csv(out)
    assert done.returncode == 0, done.stderr
    ours = ["time_s", "displacement_mm", "low_mm", "high_mm", "outside", "without_effects_mm"]
    assert list(answer) == [*ours, "if_thermal_and_x_fit_mm", "motor_turns", "load_n"]
    middle = ((answer["low_mm"] + answer["high_mm"]) / 2.0)[answer["outside"] == 0]
    assert np.allclose(middle, answer["displacement_mm"][answer["outside"] == 0], atol=1e-6) and len(middle) > 100
    assert np.allclose(answer["without_effects_mm"], answer["if_thermal_and_x_fit_mm"], atol=1e-6)
    assert np.ptp(answer["without_effects_mm"] - answer["displacement_mm"]) > 0.02, "what creep alone does"
    floor = content["fit"]["noise_floor_mm"]
    assert (answer["high_mm"] - answer["low_mm"]).min() >= 2.0 * 1.6 * floor
    order = [
        "nine of ten readings   ",
        "to report: nine of ten readings are",
        "low_mm and high_mm: nine of ten single",
        "expected error",
    ]
    printed = re.sub(r"\n +", " ", done.stdout)
    places = [printed.index(words_there) for words_there in order]
    assert places == sorted(places) and "Note 1, which is of nine of ten readings, includes it" in printed, (
        "five lines stood before the answer"
    )
    assert "expected error, only to compare" in printed and "They cover no other explanation" in printed
    assert "the reading if the other explanation is right (thermal + x_fit). It differs by at most " in printed
    assert "another may say otherwise" not in printed
    apart = np.abs(answer["if_thermal_and_x_fit_mm"] - answer["displacement_mm"])[answer["outside"] == 0]
    near, share = re.search(r"to report: .* within (\S+) mm of displacement_mm over (.*)", printed).groups()
    assert float(near) > np.quantile(apart, 0.8) > floor, "what another likely explanation says is in it"
    assert "whichever of the 2 likely explanations is right" in share
    path.write_text(json.dumps({key: content[key] for key in content if key != "uncertainty"}))
    done = programs.run("pipeline.simulate", folder, *words)
    without_band = [name for name in ours if name not in ("low_mm", "high_mm")]
    assert list(pd.read_csv(out)) == [*without_band, "motor_turns", "load_n"]
    assert f"no band: {path} does not say" in done.stdout and "Mend: diagnose again: " in done.stdout
    path.write_text(json.dumps(content | {"uncertainty": [{"name": "radius_mm", "moves": "wide"}]}))
    done = programs.run("pipeline.simulate", folder, *words)
    assert done.returncode == 2 and "uncertainty: holds" in done.stderr and "Mend: " in done.stderr


def test_outside_what_was_recorded_there_is_no_band_and_the_expected_error_says_so(creep, tmp_path):
    folder, content, samples, _ = creep
    plan, path, out = (tmp_path / name for name in ("p.csv", "d.json", "a.csv"))
    top = float(samples["motor_turns"].max())
    path.write_text(json.dumps(content))
    words = ["--simulation", path, "--motion", plan, "--out", out]
    motion = {"time_s": [0, 8, 16, 24], "motor_turns": [0, 0.9 * top, 1.3 * top, 0], "load_n": 15.0}
    pd.DataFrame(motion).to_csv(plan, index=False)
    printed = programs.run("pipeline.simulate", folder, *words).stdout
    answer = pd.read_csv(out)
    rows = answer["outside"] == 1
    assert rows.any() and not rows.all() and (answer["low_mm"].isna() == rows).all()
    count = f"{rows.sum()} of {len(answer)} rows are outside (column outside): nothing says how well the simulator does"
    assert count in printed and "an if_ column" not in printed
    assert "rows after one that is outside are inside again, though what is slow may still remember it" in printed
    pd.DataFrame(motion | {"load_n": 90.0}).to_csv(plan, index=False)
    printed = programs.run("pipeline.simulate", folder, *words).stdout
    assert "no expected error: " in printed and "\nexpected error" not in printed
    assert pd.read_csv(out)["high_mm"].isna().all()


def test_after_the_recorded_motion_the_plan_goes_on_from_the_state_that_it_left(creep, tmp_path):
    folder, content, samples, seen = creep
    mine, path, plan, out = (tmp_path / name for name in (folder.name, "d.json", "plan.csv", "a.csv"))
    mine.mkdir()
    (mine / "run.yaml").write_bytes((folder / "run.yaml").read_bytes())
    samples.iloc[:seen].to_parquet(mine / "recording.parquet", index=False)
    surer = [doubt | {"moves": [0.1 * move for move in doubt["moves"]]} for doubt in content["uncertainty"]]
    path.write_text(json.dumps(content | {"uncertainty": surer}))
    later = samples.iloc[seen:].drop(columns="displacement_mm")
    later.assign(time_s=later["time_s"] - later["time_s"].iloc[0]).to_csv(plan, index=False, float_format="%.17g")
    words = [mine, "--simulation", path, "--motion", plan, "--out", out]
    alone = programs.run("pipeline.simulate", *words).stdout
    fresh = pd.read_csv(out)
    done = programs.run("pipeline.simulate", *words, "--after-recording")
    answer = pd.read_csv(out)
    assert done.returncode == 0 and len(answer) == len(later) == len(fresh), done.stderr
    assert answer["time_s"].iloc[0] == 0.0 and answer["low_mm"].notna().any()
    run = read_strokes(folder)[0]
    whole = at_own_rate([RecordedRun.cut(run, samples)], thin=False, to_fit=False)
    truth = tared(whole, content, path, run.run)[seen:]
    expected = float(np.sqrt(np.mean((fresh["displacement_mm"] - truth) ** 2)))
    assert np.abs(answer["displacement_mm"] - truth).max() < 0.1 * expected, "as one simulation of both"
    assert "beware: this is the string as it was before its first stroke. After the recorded motion it" in alone
    again = f"--simulation {path} --motion {plan} --after-recording --out {out}"
    assert "times the expected error). For the string as the recording left it: python -m pipeline.simulate" in alone
    assert f"pipeline.simulate {mine} {again}\n" in alone, "the command can be pasted as it stands"
    assert "beware: this is the string" not in done.stdout and "to be as the recording left it" in done.stdout
    done = programs.run("pipeline.simulate", mine, "--after-recording", "--out", out)
    assert done.returncode == 2 and "--after-recording goes with --motion" in done.stderr
    (mine / "recording.parquet").unlink()
    done = programs.run("pipeline.simulate", *words, "--after-recording")
    assert done.returncode == 2 and "needs a recording, and there is none. Mend: record the run" in done.stderr


def test_what_was_adopted_takes_its_band_from_the_diagnosis_while_that_is_there(creep, tmp_path):
    folder, content, samples, _ = creep
    mine, path, plan, out = (
        tmp_path / folder.name,
        tmp_path / "diagnosis.json",
        tmp_path / "plan.csv",
        tmp_path / "a.csv",
    )
    mine.mkdir()
    for name in ("run.yaml", "recording.parquet"):
        (mine / name).write_bytes((folder / name).read_bytes())
    path.write_text(json.dumps(content))
    samples[["time_s", "motor_turns", "load_n"]].iloc[:3000].to_csv(plan, index=False)
    adopting = programs.run("pipeline.adopt", path, mine)
    assert adopting.returncode == 0 and f"pipeline.simulate {mine} --motion PLAN.csv --out FILE.csv" in adopting.stdout
    printed = " ".join(adopting.stdout.split())
    assert "PLAN.csv is a motion that you plan: time_s, motor_turns and, unless it stands still, load_n;" in printed
    done = programs.run("pipeline.simulate", mine, "--motion", plan, "--out", out)
    assert done.returncode == 0 and "low_mm" in pd.read_csv(out), done.stdout
    path.unlink()
    done = programs.run("pipeline.simulate", mine, "--motion", plan, "--out", out)
    assert "no band: run.yaml does not say" in done.stdout and "low_mm" not in pd.read_csv(out)


@pytest.fixture(scope="module")
def jam(conceal):
    """The run with a jam in it, what was found of it, and how."""
    folder = conceal("jam", kappa=3.0)[0]
    content, study = diagnosed([RecordedRun(*read_strokes(folder))])
    return folder, json.loads(json.dumps(content)), study


@pytest.mark.long
def test_the_curve_of_a_rival_errs_on_its_own_recording_as_the_verdict_says(jam):
    _, _, study = jam
    rival, problem = study.search.explain(("radius_compaction",)), study.problem

    def residual_rms(state) -> float:
        return float(np.sqrt(np.mean(np.square(problem.measured - problem.simulate(state)))))

    expected_rms = float(np.sqrt(rival.energy))
    assert residual_rms(refitted(study, rival)) == pytest.approx(expected_rms, rel=0.05)
    assert residual_rms(study.search.linear.state_of(rival.fit, rival.keys)) > 3.0 * expected_rms, (
        "straight lines miss it here"
    )


@pytest.mark.long
def test_over_its_own_recording_a_fit_is_off_by_no_more_than_the_noise(jam):
    folder, content, study = jam
    width = band(study.problem, content, folder, content["run"])
    assert 0.1 * study.floor < np.sqrt(np.mean(np.square(width.sigma))) < 1.05 * study.floor
