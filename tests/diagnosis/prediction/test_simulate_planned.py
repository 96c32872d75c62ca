"""A motion that nobody has recorded is simulated: the run's own gives what its recording gives, one stroke will do."""

import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
import yaml
from made_content import SYSTEMS, content
from made_recording import recording

from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.proposal.legs import Rig
from pipeline.diagnosis.recording.covered import covered, paces, pauses, reversals
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.own_rate import at_own_rate
from pipeline.diagnosis.words.foretold import loop_table
from pipeline.diagnosis.words.foretold.answered import within
from pipeline.diagnosis.words.foretold.prediction import of_half_speed
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.rig.others import cases
from pipeline.rig.others.made import write_run
from pipeline.run.description import Run
from pipeline.run.planned_motion.motion_course import Recorded
from pipeline.run.planned_motion.outside import outside
from pipeline.run.samples import read_samples, read_strokes


@pytest.fixture
def folder(conceal) -> Path:
    """A run with nothing in it but its dimensions."""
    return conceal("creep")[0]


@pytest.fixture
def diagnosis(folder: Path, tmp_path: Path) -> Path:
    """A diagnosis of the run that moves a dimension and has a zero of the reading."""
    path, radius_mm = (
        tmp_path / "diagnosis.json",
        yaml.safe_load((folder / "run.yaml").read_text())["string"]["radius_mm"],
    )
    parameters = {"radius_mm": {"value": 1.02 * radius_mm}, "zero_mm": {"value": 0.7}}
    path.write_text(json.dumps({"run": folder.name, "parameters": parameters, "simulation": []}))
    return path


def simulated(folder: Path, diagnosis: Path, out: Path, *words: object) -> programs.Done:
    done = programs.run("pipeline.simulate", folder, "--simulation", diagnosis, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return done


def test_the_runs_own_motion_planned_gives_what_its_recording_gives(folder, diagnosis, tmp_path):
    _, samples = read_samples(folder)
    plan = tmp_path / "plan.csv"
    samples.drop(columns="displacement_mm").to_csv(plan, index=False, float_format="%.17g")
    simulated(folder, diagnosis, tmp_path / "own.parquet")
    done = simulated(folder, diagnosis, tmp_path / "planned.parquet", "--motion", plan)
    own, planned = (pd.read_parquet(tmp_path / f"{name}.parquet") for name in ("own", "planned"))
    assert np.allclose(own, planned[own.columns], rtol=0.0, atol=1e-9)
    assert (planned["outside"] == 0.0).all()
    assert f"its zero is that of the recording of {folder.name}" in done.stdout and "rms error" not in done.stdout
    assert not done.stderr, "it stays inside what was recorded"
    samples.assign(motor_turns=1.5 * samples["motor_turns"], load_n=40.0).to_csv(plan, index=False)
    most = samples["motor_turns"].max()
    far = simulated(folder, diagnosis, tmp_path / "far.csv", "--motion", plan).stderr
    assert f"to {1.5 * most:.4g} (" in far and "Nothing says how well the simulator does there" in far
    assert "load_n of 40 to 40" in far and "a second (inside up to " in far and "a hold" not in far
    assert (pd.read_csv(tmp_path / "far.csv")["outside"] == 1).all(), "the load is too high everywhere"
    top = samples["motor_turns"].max()
    pd.DataFrame({"time_s": [0, 20, 140, 160], "motor_turns": [0, 0.9 * top, 0.9 * top, 0], "load_n": 15.0}).to_csv(
        plan, index=False
    )
    hold_warning = simulated(folder, diagnosis, tmp_path / "held.csv", "--motion", plan).stderr
    assert (
        "it asks for a hold of 120 s (inside for its first " in hold_warning
        and "Mend: end each hold after " in hold_warning
    )
    answer = pd.read_csv(tmp_path / "held.csv")
    assert set(answer["time_s"][answer["outside"] == 1].between(22.0, 140.2)) == {True}, "the hold's end alone"
    assert (answer["outside"] == 1).sum() > 2000


def test_one_stroke_will_do_and_a_name_that_ends_in_csv_is_text(folder, diagnosis, tmp_path):
    time_s = np.arange(0.0, 12.0, 0.02)
    plan = pd.DataFrame({"time_s": time_s, "motor_turns": 8.0 * np.minimum(time_s / 8.0, 1.0), "note": "x"})
    plan["load_n"] = 15.0
    plan.to_csv(tmp_path / "plan.csv", index=False)
    other = json.loads(diagnosis.read_text()) | {"run": "another"}
    diagnosis.write_text(json.dumps(other))
    done = simulated(folder, diagnosis, tmp_path / "answer.csv", "--motion", tmp_path / "plan.csv")
    columns = ["time_s", "displacement_mm", "outside", "without_effects_mm", "motor_turns", "load_n"]
    assert f"{tmp_path / 'answer.csv'} holds {', '.join(columns[:-1])} and load_n" in done.stdout
    assert f"its zero is that of the recording of {folder.name}, as its first second gives it" in done.stdout
    answer = pd.read_csv(tmp_path / "answer.csv")
    assert list(answer) == columns and len(answer) == len(plan)
    assert np.allclose(answer[["motor_turns", "load_n"]], plan[["motor_turns", "load_n"]])
    assert np.allclose(answer["without_effects_mm"], answer["displacement_mm"]), "no effect acts"
    wound = answer["displacement_mm"].iloc[-1]
    assert wound > 1.0 and answer["displacement_mm"][time_s > 8.0].std() < 1e-6, "the motor stands, the string too"
    _, samples = read_samples(folder)
    begins = samples["displacement_mm"][samples["time_s"] < 1.0].median()
    assert abs(answer["displacement_mm"].iloc[0] - begins) < 0.1 * (wound - begins)


STEP = pd.DataFrame({"time_s": [0.0, 0.0, 5.0], "motor_turns": [0.0, 10.0, 0.0], "load_n": 15.0})


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda plan: plan.drop(columns="motor_turns"), "motor_turns: there is no such column, only time_s"),
        (
            lambda plan: plan.rename(columns={"motor_turns": "turns", "time_s": "t"}),
            "time_s, motor_turns: there are no such columns, only t, turns, load_n",
        ),
        (lambda plan: plan.assign(motor_turns=np.nan), "motor_turns: is not a number in 600 of 600 rows"),
        (lambda plan: plan.assign(motor_turns="fast"), "motor_turns: is not a number in 600 of 600 rows"),
        (lambda plan: plan[::-1], "time_s: runs backwards"),
        (
            lambda plan: plan[:3],
            "holds 3 samples, too few for a stroke. Mend: give corners that lie more than 0.2 s apart",
        ),
        (
            lambda plan: STEP,
            "time_s: is 0 s in row 1 and row 2: a motor takes time for a step. Mend: give row 2 ",
        ),
        (
            lambda plan: STEP.assign(time_s=[0.0, 5.0, 2.0]),
            "time_s: runs backwards from 5 s to 2 s in row 2 and row 3. Mend: put the rows in the order of their times",
        ),
        (
            lambda plan: STEP.assign(time_s=[0.0, 5.0, 10.0], load_n=[15.0, np.nan, 15.0]),
            "load_n: is not a number in 1 of 3 rows, first in row 2",
        ),
        (
            lambda plan: plan.drop(columns="load_n"),
            "load_n: there is no such column, and the load of run-",
        ),
    ],
)
def test_what_is_no_plan_is_refused_in_words_and_nothing_written(folder, diagnosis, tmp_path, change, says):
    time_s = np.arange(0.0, 12.0, 0.02)
    plan = pd.DataFrame({"time_s": time_s, "motor_turns": np.minimum(time_s, 8.0), "load_n": 15.0})
    change(plan).to_csv(tmp_path / "plan.csv", index=False)
    words = ["--simulation", diagnosis, "--motion", tmp_path / "plan.csv", "--out", tmp_path / "answer.csv"]
    done = programs.run("pipeline.simulate", folder, *words)
    assert done.returncode == 2 and says in done.stderr and "Mend: " in done.stderr, done.stderr
    assert not (tmp_path / "answer.csv").exists()


def test_corners_of_a_motion_are_joined_by_straight_lines(folder, diagnosis, tmp_path):
    corners = pd.DataFrame({"time_s": [0.0, 6.0, 26.0, 32.0], "motor_turns": [0.0, 8.0, 8.0, 0.0], "load_n": 15.0})
    fine = pd.DataFrame({"time_s": np.arange(0.0, 32.0001, 0.02)})
    for name in ("motor_turns", "load_n"):
        fine[name] = np.interp(fine["time_s"], corners["time_s"], corners[name])
    for name, plan in (("corners", corners), ("fine", fine)):
        plan.to_csv(tmp_path / f"{name}.csv", index=False)
        simulated(folder, diagnosis, tmp_path / f"{name}-answer.csv", "--motion", tmp_path / f"{name}.csv")
    few, many = (pd.read_csv(tmp_path / f"{name}-answer.csv") for name in ("corners", "fine"))
    at_s = np.linspace(0.0, 32.0, 50)
    answers = [np.interp(at_s, answer["time_s"], answer["displacement_mm"]) for answer in (few, many)]
    assert np.allclose(*answers, atol=1e-3) and np.ptp(answers[0]) > 1.0


def test_a_load_that_hangs_still_need_not_be_planned(make_run, tmp_path):
    folder = make_run("still", recording(4).assign(load_n=lambda table: 20.0 + 0.1 * np.sin(table["time_s"])))
    content = {"run": "still", "parameters": {}, "simulation": []}
    (tmp_path / "diagnosis.json").write_text(json.dumps(content))
    for name, more in (("without", {}), ("with", {"load_n": 20.0})):
        pd.DataFrame({"time_s": [0.0, 5.0, 10.0], "motor_turns": [0.0, 20.0, 0.0]} | more).to_csv(
            tmp_path / f"{name}.csv", index=False
        )
        done = simulated(
            folder, tmp_path / "diagnosis.json", tmp_path / f"{name}-answer.csv", "--motion", tmp_path / f"{name}.csv"
        )
        words = "The plan has no column load_n: its load is 20.0"
        assert (words in done.stdout) is (name == "without"), "it was taken without a word"
    without, with_load = (pd.read_csv(tmp_path / f"{name}-answer.csv") for name in ("without", "with"))
    assert np.allclose(without["load_n"], 20.0, atol=0.01)
    assert np.allclose(without.drop(columns="load_n"), with_load.drop(columns="load_n"), atol=1e-4)


def test_a_load_that_varied_must_be_planned_whatever_run_yaml_says_of_the_load(make_run, tmp_path):
    """The channel wins over rig.load_n, which was taken without a word."""
    (tmp_path / "diagnosis.json").write_text(json.dumps({"run": "varied", "parameters": {}, "simulation": []}))
    plan, out = tmp_path / "plan.csv", tmp_path / "answer.csv"
    pd.DataFrame({"time_s": [0.0, 5.0, 10.0], "motor_turns": [0.0, 20.0, 0.0]}).to_csv(plan, index=False)
    rig = {"torsion_zone_mm": 150, "separator_mm": 8}
    varied = recording(4).assign(load_n=lambda table: 20.0 + 10.0 * np.sin(table["time_s"] / 6.0))
    for name, load in (("free", {}), ("given", {"load_n": 20})):
        folder = make_run(name, varied, rig=rig | load)
        words = ["--simulation", tmp_path / "diagnosis.json", "--motion", plan, "--out", out]
        done = programs.run("pipeline.simulate", folder, *words)
        assert done.returncode == 2 and not out.exists(), name
        says = (
            f"load_n: there is no such column, and the load of {name} was not always the same. Mend: add it: 10.01 to"
        )
        assert says in done.stderr, done.stderr
    cell = 20.0 + 0.2 * np.random.default_rng(0).standard_normal(len(varied))  # a cell's noise: 6 % from end to end
    noisy = make_run("noisy", recording(4).assign(load_n=cell), rig=rig)
    simulated(noisy, tmp_path / "diagnosis.json", out, "--motion", plan)
    assert set(pd.read_csv(out)["load_n"].round(1)) == {20.0}
    other = make_run("still", recording(4).assign(load_n=20.0), rig=rig | {"load_n": 35})
    done = simulated(other, tmp_path / "diagnosis.json", out, "--motion", plan)
    assert "its load is 20 N throughout, the median of the recording of still." in " ".join(done.stdout.split())
    assert set(pd.read_csv(out)["load_n"]) == {20.0}
    only_there = make_run("hung", recording(4).drop(columns="load_n"), rig=rig | {"load_n": 35})
    done = simulated(only_there, tmp_path / "diagnosis.json", out, "--motion", plan)
    assert set(pd.read_csv(out)["load_n"]) == {35.0}
    assert "its load is 35 N throughout, rig.load_n of run.yaml." in " ".join(done.stdout.split())


@pytest.mark.parametrize(
    "entry",
    [
        {"id": "viscous_loss", "parameters": {"loaded": 0.0, "steepest": 0.5, "straight_mm_per_turn_s": 0.1}},
        {"id": "sensor_lag", "parameters": {"filter_0.1_s": 1.0}},
        {"id": "sensor_lag", "parameters": {"clock_skew": 0.01}},
    ],
)
def test_nothing_moves_before_the_motor_does(folder, diagnosis, tmp_path, entry):
    diagnosis.write_text(json.dumps(json.loads(diagnosis.read_text()) | {"simulation": [entry]}))
    corners = {"time_s": [0.0, 6.0, 25.56, 32.0], "motor_turns": [0.0, 8.0, 8.0, 0.0], "load_n": 15.0}
    pd.DataFrame(corners).to_csv(tmp_path / "plan.csv", index=False)
    simulated(folder, diagnosis, tmp_path / "answer.csv", "--motion", tmp_path / "plan.csv")
    answer = pd.read_csv(tmp_path / "answer.csv").set_index("time_s")["displacement_mm"]
    assert np.diff(answer.index).min() > 0.001, "no corner is there twice"
    assert np.ptp(answer[(answer.index > 9.0) & (answer.index <= 25.56)]) < 1e-9
    assert abs(answer[25.66] - answer[25.56]) > 1e-4


def four_strokes(make_run) -> tuple[Path, pd.DataFrame]:
    """A run of triangles between 0 and one twist at one speed, and its recording."""
    table = recording(4).assign(load_n=20.0)
    return make_run("triangles", table), table


def acting(tmp_path: Path, entry: dict) -> Path:
    """A diagnosis of another run in which one effect acts."""
    (tmp_path / "diagnosis.json").write_text(json.dumps({"run": "other", "parameters": {}, "simulation": [entry]}))
    return tmp_path / "diagnosis.json"


SLOWED = {"id": "viscous_loss", "parameters": {"loaded": 0.0, "steepest": 0.5, "straight_mm_per_turn_s": 0.1}}
BACKLASH = {"id": "backlash", "parameters": {"half_width_turns": 0.001, "share": 0.1}}
LOOP = {"id": "backlash", "parameters": {"half_width_turns": 0.5, "share": 0.8}}


def test_slower_than_recorded_and_reversals_inside_are_outside(make_run, tmp_path):
    folder, table = four_strokes(make_run)
    top, plan = float(table["motor_turns"].max()), tmp_path / "plan.csv"
    speed = float(np.abs(np.diff(table["motor_turns"])).max() / np.diff(table["time_s"]).min())
    slow_s = top / (0.2 * speed)

    def simulate_plan(corners: dict, entry: dict) -> tuple[str, pd.DataFrame]:
        pd.DataFrame(corners).to_csv(plan, index=False)
        done = simulated(folder, acting(tmp_path, entry), tmp_path / "a.csv", "--motion", plan)
        return done.stderr, pd.read_csv(tmp_path / "a.csv")

    warning, answer = simulate_plan({"time_s": [0.0, slow_s, 1.2 * slow_s], "motor_turns": [0.0, top, 0.0]}, LOOP)
    assert (
        "motor_turns that change by only" in warning
        and ". Recorded was one speed, " in warning
        and "a reversal" not in warning
    )
    assert ". Nothing that was recorded says what another speed does. " in warning
    rows = answer["outside"] == 1
    assert rows[answer["time_s"] < 0.95 * slow_s].all() and not rows[answer["time_s"] > 1.05 * slow_s].any()

    legs = np.cumsum([0.0, top, 0.5 * top, 0.3 * top, 0.8 * top]) / speed
    inner = {"time_s": legs, "motor_turns": [0.0, top, 0.5 * top, 0.8 * top, 0.0]}
    warning, answer = simulate_plan(inner, LOOP)
    assert f"2 reversals inside the range, the first at motor_turns of {0.5 * top:.4g}" in warning
    rows = answer["outside"] == 1
    assert rows[answer["time_s"] > legs[2] + 0.1].all() and not rows[answer["time_s"] < legs[2] - 0.1].any()
    warning, answer = simulate_plan(inner, SLOWED)
    assert not warning and not answer["outside"].any(), "no effect at work remembers where the motion turned"


def test_another_speed_is_outside_where_it_matters_or_nobody_knows_whether_it_does(make_run, tmp_path):
    folder, plan = four_strokes(make_run)[0], tmp_path / "plan.csv"
    one_speed, two = recording(4).assign(load_n=20.0), recording(4).assign(load_n=20.0)
    two["time_s"] = np.where(
        two.index < len(two) / 2, two["time_s"], two["time_s"].median() + (two["time_s"] - two["time_s"].median()) / 2
    )
    folders = {"one": folder, "two": make_run("two-speeds", two)}
    top = float(one_speed["motor_turns"].max())
    speed = float(np.abs(np.diff(one_speed["motor_turns"])).max() / np.diff(one_speed["time_s"]).min())

    def plan_warning(kind: str, share: float, entry: dict, **more: object) -> str:
        lasts_s = top / (share * speed)
        corners = {"time_s": [0.0, lasts_s, 2.0 * lasts_s], "motor_turns": [0.0, top, 0.0]}
        pd.DataFrame(corners).to_csv(plan, index=False)
        path = acting(tmp_path, entry)
        path.write_text(json.dumps(json.loads(path.read_text()) | more))
        return simulated(folders[kind], path, tmp_path / "a.csv", "--motion", plan).stderr

    assert not plan_warning("one", 1.0, SLOWED) and not plan_warning("one", 0.85, SLOWED), "the recorded speed, nearly"
    for share in (0.5, 0.7):
        assert ". So near, since viscous_loss follows speed or time. " in plan_warning("one", share, SLOWED)
        assert "Nothing that was recorded says what another speed does. " in plan_warning("one", share, BACKLASH)
        warning = plan_warning("two", share, SLOWED)
        assert (
            ". The slowest stroke that was recorded had " in warning
            and "on: four fifths of it, less 5 %. So" in warning
        )
    assert not plan_warning("two", 0.7, BACKLASH), "two speeds were seen, and the effect follows none"
    open_one = plan_warning("two", 0.7, BACKLASH, alternatives=[["creep", "sensor_lag"]])
    assert "since creep and sensor_lag follow speed or time. " in open_one
    assert not plan_warning("two", 1.5, SLOWED), "between two speeds that were recorded"


def two_speeds(make_run) -> tuple[Run, Recorded, float]:
    """A run of two triangles at one speed and two at twice that, what it holds, and the slower speed."""
    table = recording(4).assign(load_n=20.0)
    late = table["time_s"] > table["time_s"].median()
    table["time_s"] = table["time_s"].where(~late, 0.5 * (table["time_s"] + table["time_s"].median()))
    run, samples, strokes = read_strokes(make_run("two-speeds", table))
    recorded = Recorded([samples], [strokes], "motor_turns")
    return run, recorded, min(recorded.speeds)


def triangle(top: float, speed: float, hold_s: float = 0.0) -> pd.DataFrame:
    """A stroke of 0 to `top` and back, at one speed, with a hold."""
    corners_s = np.cumsum([0.0, top / speed, max(hold_s, 0.02), top / speed])
    time_s = np.arange(0.0, corners_s[-1], 0.02)
    turns = np.interp(time_s, corners_s, [0.0, top, top, 0.0])
    return pd.DataFrame({"time_s": time_s, "motor_turns": turns, "load_n": 20.0})


def test_a_load_that_stood_still_has_two_per_cent_of_room_and_no_range_of_its_noise(make_run):
    """A plan under 18 N was outside from its first row on, where noise about 18.2 N had been recorded."""
    run, recorded, slowest = two_speeds(make_run)
    noise = np.random.default_rng(1).normal(0.0, 0.04, len(recorded.samples[0]))
    recorded.samples[0]["load_n"] = 18.2 + noise
    still = Recorded([recorded.samples[0]], recorded.strokes[:1], "motor_turns")
    for load_n, is_out in ((18.0, False), (18.5, False), (17.0, True), (36.0, True)):
        answer = outside(run, triangle(0.95 * recorded.ends[1], slowest).assign(load_n=load_n), still)
        asks = [demand for demand in answer.asks if demand.startswith("load_n")]
        assert bool(asks) is is_out
    assert asks == ["load_n of 36 to 36 (18.2 was recorded, and it stood still: inside are 2 % more or less)"]
    assert "keep load_n at 18.2" in answer.mends
    ranges = {"load": [18.15, 18.25], "speed_per_s": [1.0, 1.0], "longest_hold_s": 1.0, "longest_rest_s": 1.0}
    sentence = within(content(evidence__covered=ranges), Vocabulary.of(SYSTEMS["mm"]))
    assert " 18.2 N, " in sentence and "to 18.2" not in sentence


@pytest.mark.parametrize(("paced", "share"), [((), 0.5), (("creep",), 0.8)])
def test_a_speed_at_a_limit_is_inside_however_it_was_rounded_and_so_is_the_limit_that_is_said(make_run, paced, share):
    run, recorded, slowest = two_speeds(make_run)
    top = 0.95 * recorded.ends[1]
    for speed in (share * slowest, 0.97 * share * slowest):
        assert not outside(run, triangle(top, speed), recorded, paced=paced).asks
    answer = outside(run, triangle(top, 0.93 * share * slowest), recorded, paced=paced)
    assert answer.rows.mean() > 0.9 and "less 5 %" in answer.asks[0]
    (mend,) = answer.mends
    least_speed = float(re.fullmatch("move at (.*) turns/s or faster", mend)[1])
    assert f". Inside from {least_speed:g} on: " in answer.asks[0] and least_speed == pytest.approx(
        0.95 * share * slowest, rel=0.01
    )
    assert not outside(run, triangle(top, least_speed), recorded, paced=paced).asks, "what is said to be inside is"


@pytest.mark.parametrize("paced", [(), ("creep",)])
def test_a_plan_that_does_what_each_mend_says_is_inside(make_run, paced):
    run, recorded, _ = two_speeds(make_run)
    top, fast = 0.95 * recorded.ends[1], 3.0 * max(recorded.speeds)
    quick = outside(run, triangle(top, fast, hold_s=30.0), recorded, paced=paced)
    slower, shorter = (re.search(r"(?:at|after) ([0-9.]+) ", mend)[1] for mend in quick.mends)
    assert not outside(run, triangle(top, float(slower), float(shorter)), recorded, paced=paced).asks


def test_half_the_speed_that_a_verdict_foretells_a_loop_at_is_inside(make_run):
    run, recorded, _ = two_speeds(make_run)
    (samples,) = recorded.samples
    half = 0.5 * Rig(at_own_rate([RecordedRun.cut(run, samples)], thin=True, to_fit=False).record).speed
    assert not outside(run, triangle(0.95 * recorded.ends[1], half), recorded).asks


@pytest.mark.parametrize("id_", ["friction_hysteresis", "creep"])
def test_a_plan_at_the_ends_of_the_range_that_the_page_says_has_a_band_everywhere(make_run, id_):
    run, recorded, _ = two_speeds(make_run)
    first_run = RecordedRun(run, recorded.samples[0], recorded.strokes[0])
    ranges = covered(at_own_rate([first_run], thin=True, to_fit=False).record) | pauses([first_run])
    evidence = {"covered": ranges, "motor_turns": [float(end) for end in recorded.ends]}
    verdict = content(mechanisms=[entry for entry in content()["mechanisms"] if entry["id"] == id_], alternatives=[])
    sentence = within(verdict | {"evidence": evidence}, Vocabulary.of(SYSTEMS["mm"]))
    ranges |= reversals([first_run])
    assert reversals([first_run])["turned"]["top"][-1][-1] == pytest.approx(recorded.ends[1], rel=0.01)
    slow, fast, holds_s = map(
        float, re.search(r", ([0-9.]+) to ([0-9.]+) turns/s, .*holds of up to (.*?) s", sentence).groups()
    )
    paced = [id_] if id_ == "creep" else []
    assert slow == pytest.approx((0.8 if paced else 0.5) * min(recorded.speeds), rel=0.03)
    for speed in (slow, fast):
        assert not outside(run, triangle(recorded.ends[1], speed, holds_s), recorded, True, paced).asks
    ranges |= paces([first_run])
    sentence = within(verdict | {"evidence": evidence}, Vocabulary.of(SYSTEMS["mm"]))
    slow, fast = re.search(
        r"a speed of (\S+) to (\S+) turns/s in each stroke \(its median; recorded: ", sentence
    ).groups()
    asks = outside(run, triangle(recorded.ends[1], 0.9 * float(slow)), recorded, True, paced).asks
    assert f"Inside from {slow} on" in asks[0], "the page and the warning give one limit"
    for speed in (slow, fast):
        assert not outside(run, triangle(recorded.ends[1], float(speed), holds_s), recorded, True, paced).asks


def test_where_half_the_speed_is_outside_what_the_verdict_foretells_of_it_is_said():
    first = {"ids": ["creep"], "loop_half_speed_mm": 0.09, "plus_minus": {"loop_half_speed_mm": 0.02}}
    content = {"evidence": {"expected": {"speed_per_s": 1.382, "explanations": [first]}}}
    (sentence,) = of_half_speed(content, 1.05, "mm", "turns", "mm")
    assert (
        "foretells a loop of 0.09 ± 0.02 mm at 0.69 turns/s, half the usual speed, if the explanation is right"
        in sentence
    )
    assert not of_half_speed(content, 0.656, "mm", "turns", "mm"), "half the speed is inside"
    assert not of_half_speed({"evidence": {}}, 1.05, "mm", "turns", "mm"), "an older file"
    content["evidence"]["expected"] |= {"recorded": {"loop_mm": 0.1}, "speed_per_s": 2.0}
    assert "at 1 turn/s, half the usual speed, if" in of_half_speed(content, 1.05, "mm", "turns", "mm")[0]
    first["plus_minus"]["loop_half_speed_mm"] = 4.0
    assert not of_half_speed(content, 1.05, "mm", "turns", "mm"), "0 ± 4 mm says nothing beside a loop of 0.1 mm"


def strokes_table(last: float = 0.0) -> pd.DataFrame:
    """The answer of three strokes of 10 turns at one speed, with a loop of 0.2 mm; the first begins without memory."""
    time_s = np.arange(0.0, 60.01, 0.02)
    turns = 10.0 * (1.0 - np.abs(time_s / 10.0 % 2.0 - 1.0))
    up = time_s % 20.0 < 10.0
    table = pd.DataFrame({"time_s": time_s, "motor_turns": turns})
    loop = np.where(up, np.where(time_s < 3.0, 0.0, -0.1), 0.1)
    return table.assign(displacement_mm=turns**2 / 10.0 + loop + last * (time_s > 40.0))


def test_both_ways_of_each_stroke_that_differs_stand_in_the_printed_answer_and_like_strokes_once():
    words = Vocabulary.of(SYSTEMS["mm"])
    table = strokes_table()
    _, head, *rows = [re.split(r" {2,}", line) for line in loop_table.lines(table, words, "displacement_mm")]
    assert head == ["stroke", "motor_turns", "displacement_mm, winding", "unwinding", "difference"]
    assert [row[0] for row in rows] == ["1", "", "", "2 and 3", "", ""]
    assert [float(row[1]) for row in rows[:3]] == [2.5, 5.0, 7.5]
    assert rows[0][4] == "-0.10 mm", "the first way up has no memory yet"
    for row in rows[1:]:
        assert float(row[3]) - float(row[2]) == pytest.approx(0.2, abs=1e-3) and row[4] == "-0.20 mm"
        assert float(row[2]) == pytest.approx(float(row[1]) ** 2 / 10.0 - 0.1, abs=1e-3)
    other = loop_table.lines(strokes_table(0.05).assign(outside=1.0), words, "displacement_mm")
    far = [
        re.split(r" {2,}", line)[-4:-1]
        for line in loop_table.lines(strokes_table(1 / 3).assign(outside=1.0), words, "displacement_mm")[2:]
    ]
    assert all(len(cell.strip("-").replace(".", "").lstrip("0")) <= 4 for row in far for cell in row), (
        "6 digits of a guess"
    )
    assert "2 (outside)" in other[5] and "3 (outside)" in other[8] and max(map(len, other)) <= 100
    part = strokes_table(0.05).assign(outside=lambda frame: (frame["time_s"] > 59.0).astype(float))
    mixed = loop_table.lines(part, words, "displacement_mm")
    assert mixed[2].startswith("1   ") and mixed[8].startswith("3 (5 % outside) "), "a few rows made all of it outside"
    columns = np.array([re.split(r" {2,}", line)[-3:-1] for line in mixed[2:]])
    assert len({len(cell.partition(".")[2]) for cell in columns.ravel()}) == 1, "-0.930 stood over -0.919182"
    small = strokes_table().assign(low_mm=lambda frame: frame["displacement_mm"] - 0.054)
    small = small.assign(
        high_mm=lambda frame: frame["displacement_mm"] + 0.054, displacement_mm=lambda frame: frame["low_mm"]
    )
    row = re.split(r" {2,}", loop_table.lines(small, words, "displacement_mm")[5])
    assert row == ["2 and 3", "2.5", "0.471", "0.671", "-0.200 mm"], "the digits of a band of ±0.054 mm"
    coarse = strokes_table().assign(outside=1.0, displacement_mm=lambda frame: 20.0 + 0.26 * frame["displacement_mm"])
    row = re.split(r" {2,}", loop_table.lines(coarse, words, "displacement_mm")[6])
    assert row[-1] == "-0.052 mm" and float(row[-2]) - float(row[-3]) == pytest.approx(0.052, abs=2e-3), "to be checked"
    flat = strokes_table().assign(
        displacement_mm=lambda frame: frame["motor_turns"] + 3.5e-4 * (frame["time_s"] % 20.0 > 10.0)
    )
    gaps = [line.split("  ")[-1].strip() for line in loop_table.lines(flat, words, "displacement_mm")[2:]]
    assert gaps and all(re.fullmatch(r"[+-]0\.00035 mm", gap) for gap in gaps), gaps
    many = pd.concat(
        [strokes_table(0.1 * k).assign(time_s=lambda frame, k=k: frame["time_s"] + 60.0 * k) for k in range(5)]
    )
    long = loop_table.lines(many.reset_index(drop=True), words, "displacement_mm")
    assert len(long) == 2 + 3 * 3 + 1 and "more strokes that differ from these are in the file" in long[-1]
    assert not loop_table.lines(table[:400], words, "displacement_mm"), "no stroke is whole"


def test_a_first_stroke_that_begins_otherwise_than_the_second_is_explained():
    words, table = Vocabulary.of(SYSTEMS["mm"]), strokes_table()
    (sentence,) = loop_table.of_starts(table, words, "displacement_mm", "friction_hysteresis")
    assert sentence.startswith("stroke 1 begins at 0 mm and stroke 2 at ") and "(friction_hysteresis)" in sentence
    assert "as it was before its first stroke" in sentence and "--after-recording" in sentence
    same = table.assign(displacement_mm=table["motor_turns"])
    assert not loop_table.of_starts(same, words, "displacement_mm", "jam")
    assert not loop_table.of_starts(table[:900], words, "displacement_mm", "jam"), "one stroke begins once"


def test_the_loop_of_a_plan_is_printed_and_why_its_first_stroke_begins_otherwise(make_run, tmp_path):
    folder, table = four_strokes(make_run)
    top, plan, lasts_s = float(table["motor_turns"].max()), tmp_path / "plan.csv", float(table["time_s"].max()) / 8.0
    corners_s = np.arange(5) * lasts_s
    pd.DataFrame({"time_s": corners_s, "motor_turns": [0.0, top, 0.0, top, 0.0]}).to_csv(plan, index=False)
    loop = acting(tmp_path, LOOP)
    printed = simulated(folder, loop, tmp_path / "a.csv", "--motion", plan).stdout
    assert "winding less unwinding" in printed and "stroke 1 begins at " in printed
    after = simulated(folder, loop, tmp_path / "a.csv", "--motion", plan, "--after-recording").stdout
    assert "winding less unwinding" in after and "stroke 1 begins at " not in after


@pytest.mark.parametrize("falls", [False, True])
def test_a_load_that_falls_is_outside_where_the_recorded_ones_only_rose(make_run, tmp_path, falls):
    """Every row was inside, and the error 1.7 times the expected one: the string stretched and did not stay longer."""
    table, plan = recording(4), tmp_path / "plan.csv"
    first = table["time_s"] < table["time_s"].median()
    folder = make_run("loads", table.assign(load_n=np.where(first ^ falls, 20.0, 30.0)))
    top, lasts_s = float(table["motor_turns"].max()), float(table["time_s"].max()) / 4.0
    path = tmp_path / "diagnosis.json"
    path.write_text(json.dumps({"run": folder.name, "parameters": {}, "simulation": []}))

    def asks(first_n: float, second_n: float, *words: str) -> tuple[str, set[int]]:
        loads_n = [first_n, first_n, second_n, second_n]
        at_s = [0.0, lasts_s, lasts_s + 0.1, 2.0 * lasts_s]
        pd.DataFrame({"time_s": at_s, "motor_turns": [0.0, top, top, 0.0], "load_n": loads_n}).to_csv(plan, index=False)
        warning = simulated(folder, path, tmp_path / "a.csv", "--motion", plan, *words).stderr
        return warning, set(pd.read_csv(tmp_path / "a.csv")["outside"].iloc[-5:])

    assert "load_n that falls" not in asks(20.0, 30.0)[0] and "load_n that falls" not in asks(20.0, 20.0)[0]
    fallen, rows = asks(30.0, 20.0)
    assert ("load_n that falls from 30 to 20 (what was recorded only rose)" in fallen) is not falls
    assert ("record a low load after a high one" in fallen) is not falls and (falls or rows == {1})
    assert ("load_n that falls" in asks(20.0, 20.0, "--after-recording")[0]) is not falls


def test_what_another_recording_of_the_same_diagnosis_holds_is_inside(make_run, tmp_path):
    """What the warning says to do, recording such a stroke and diagnosing both together, takes the warning away."""
    fast, path, plan = four_strokes(make_run)[0], acting(tmp_path, SLOWED), tmp_path / "plan.csv"
    table = recording(4).assign(load_n=20.0)
    slow = make_run("slow", table.assign(time_s=2.0 * table["time_s"]))
    top, lasts_s = float(table["motor_turns"].max()), float(table["time_s"].max()) / 4.0
    corners = {"time_s": [0.0, lasts_s, 2.0 * lasts_s], "motor_turns": [0.0, top, 0.0]}
    pd.DataFrame(corners).to_csv(plan, index=False)

    def plan_warning(folder: Path, runs: object) -> str:
        path.write_text(json.dumps(json.loads(path.read_text()) | {"run": runs}))
        return simulated(folder, path, tmp_path / "a.csv", "--motion", plan).stderr

    together, alone = [fast.name, slow.name], "that change by only"
    assert alone in plan_warning(fast, fast.name) and alone not in plan_warning(slow, slow.name)
    assert alone not in plan_warning(fast, together) and alone not in plan_warning(slow, together)
    assert alone in plan_warning(fast, [fast.name, "gone", "../slow", 5]), "what is not there adds nothing"
    assert alone in plan_warning(fast, ["other", slow.name]), "a diagnosis of other runs alone"


def test_what_follows_speed_or_time_is_known_from_the_mechanisms_own_driver():
    paced = {id_ for id_, mechanism in mechanisms().items() if mechanism.paced}
    assert {"viscous_loss", "sensor_lag", "creep", "thermal", "stick_slip", "load_swing", "x_clock"} <= paced
    assert not paced & {"backlash", "jam", "wear", "axial_elasticity", "sensor_drift", "friction_hysteresis"}


def test_a_motion_as_fast_as_a_moment_of_the_recording_alone_is_outside(make_run):
    """The recorded strokes are sines, whose middle is faster than they are on the whole; the plan stays that fast."""
    time_s = np.arange(0.0, 60.0, 0.02)
    table = pd.DataFrame({"time_s": time_s, "motor_turns": 10.0 - 10.0 * np.cos(np.pi * time_s / 10.0), "load_n": 20.0})
    table["displacement_mm"] = 0.02 * table["motor_turns"] ** 2
    run, samples, strokes = read_strokes(make_run("sines", table))
    recorded = Recorded([samples], [strokes], "motor_turns")
    turns = 0.5 + 19.0 * np.abs((0.1645 * time_s + 1.0) % 2.0 - 1.0)
    plan = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "load_n": 20.0})
    answer = outside(run, plan, recorded)
    assert "strokes whose motor_turns change by 3.13 a second. Recorded was one speed, " in answer.asks[0]
    assert ": five quarters of it, and 5 %" in answer.asks[0]
    assert answer.rows.mean() > 0.9 and not outside(run, table, recorded).asks


def test_a_plan_may_use_the_names_and_units_of_the_recordings_columns(make_run, tmp_path):
    table = recording(4).assign(angle_deg=lambda frame: 360.0 * frame["motor_turns"], t=lambda frame: frame["time_s"])
    channels = {"time_s": "t", "motor_turns": {"column": "angle_deg", "unit": "deg"}}
    folder = make_run("named", table.drop(columns=["motor_turns", "time_s"]), channels=channels)
    path, out = tmp_path / "diagnosis.json", tmp_path / "a.csv"
    path.write_text(json.dumps({"run": "named", "parameters": {}, "simulation": []}))
    ours = {"time_s": [0.0, 5.0, 10.0], "motor_turns": [0.0, 20.0, 0.0]}
    own = {"t": [0.0, 5.0, 10.0], "angle_deg": [0.0, 7200.0, 0.0]}
    answers = []
    for plan in (ours, own):
        pd.DataFrame(plan).to_csv(tmp_path / "plan.csv", index=False)
        simulated(folder, path, out, "--motion", tmp_path / "plan.csv")
        answers.append(pd.read_csv(out))
    assert np.allclose(*answers) and np.ptp(answers[0]["displacement_mm"]) > 1.0
    pd.DataFrame({"t": [0.0, 5.0], "x": [0.0, 1.0]}).to_csv(tmp_path / "plan.csv", index=False)
    words = ["--simulation", path, "--motion", tmp_path / "plan.csv", "--out", out]
    wrong = programs.run("pipeline.simulate", folder, *words).stderr
    assert "motor_turns: there is no such column, only t, x. Mend: " in wrong
    assert "or with the columns of the recording: angle_deg for motor_turns" in wrong


def test_what_a_drive_is_taken_to_be_is_said_in_its_own_word(tmp_path):
    """A cable drive has no string, and `the string is taken to be as it was` stood in what simulate says of it."""
    drive_case = cases.make("cable-backlash", 3)
    write_run(drive_case, tmp_path / "raw/a-01")
    planned = read_samples(tmp_path / "raw/a-01")[1].iloc[:3000]
    planned[["time_s", "motor_deg", "torque_nm"]].to_csv(tmp_path / "plan.csv", index=False)
    options = ("--motion", tmp_path / "plan.csv", "--out", tmp_path / "answer.csv")
    done = programs.run("pipeline.simulate", tmp_path / "raw/a-01", *options)
    assert "; the drive is taken to be as it was before its first stroke" in " ".join(done.stdout.split()), done.stderr
