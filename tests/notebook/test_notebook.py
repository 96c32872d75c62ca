"""twistbench in memory: what a notebook can make, ask and keep, and what it is refused."""

import json
import pickle
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_recording import content, recording

import pipeline as tb
from pipeline.diagnosis import in_memory
from pipeline.ground.stored import schemas
from pipeline.notebook import diagnosis as in_a_notebook

ROOT = Path(__file__).parents[2]
DESCRIPTION = {key: value for key, value in content("a-01").items() if key != "run"}


@pytest.fixture(scope="module")
def nylon() -> tb.Recording:
    return tb.Recording.of(recording(6), DESCRIPTION)


@pytest.fixture(scope="module")
def diagnosed_pair(nylon: tb.Recording) -> tuple[tb.Diagnosis, bytes]:
    """Its diagnosis, and what that was made from, which the program can be given again."""
    pickles: list[bytes] = []

    def diagnosed(*arguments):
        content, study = in_memory.diagnosed(*arguments)
        study.problem._terms.clear()  # functions, which cannot be written down
        pickles.append(pickle.dumps((content, study)))
        return content, study

    steps: list[str] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(in_a_notebook, "diagnosed", diagnosed)
        pair = tb.Diagnosis.of(nylon, say=steps.append), pickles[0]
    assert steps[0] == "held out" and steps[-1] == "writing", "who waits is told each step"
    return pair


@pytest.fixture(scope="module")
def diagnosis(diagnosed_pair: tuple[tb.Diagnosis, bytes]) -> tb.Diagnosis:
    return diagnosed_pair[0]


def test_importing_the_package_imports_none_of_its_rooms_and_every_public_name_is_there() -> None:
    program = "import sys, pipeline; sys.exit(any(name.startswith('pipeline.') for name in sys.modules))"
    assert subprocess.run([sys.executable, "-c", program], cwd=ROOT).returncode == 0
    for name in tb.__all__:
        assert name in dir(tb) and getattr(tb, name).__doc__, name
    with pytest.raises(AttributeError, match="nothing"):
        _ = tb.nothing


def test_a_recording_of_a_table_is_what_its_run_folder_reads_as(nylon: tb.Recording, tmp_path: Path) -> None:
    folder = nylon.save(tmp_path / "raw")
    read = tb.Recording.read(folder)
    pd.testing.assert_frame_equal(read.samples, nylon.samples)
    assert read.run == nylon.run and folder.name == "recording" and "6 strokes" in repr(read)
    assert read.strokes["stroke"].max() == 6
    with pytest.raises(tb.BadInput, match="is there already"):
        nylon.save(tmp_path / "raw")


def test_columns_of_other_names_and_units_become_channels(nylon: tb.Recording) -> None:
    foreign = pd.DataFrame({"ms": 1e3 * nylon.samples["time_s"], "rad": 2 * np.pi * nylon.samples["motor_turns"]})
    foreign["laser"] = 5.0 - nylon.samples["displacement_mm"]
    channels = {
        "time_s": {"column": "ms", "unit": "ms"},
        "motor_turns": {"column": "rad", "unit": "rad"},
        "displacement_mm": {"column": "laser", "scale": -1, "offset": 5},
    }
    converted = tb.Recording.of(foreign, {**DESCRIPTION, "channels": channels})
    np.testing.assert_allclose(converted.samples[["time_s", "motor_turns", "displacement_mm"]],
                               nylon.samples[["time_s", "motor_turns", "displacement_mm"]], atol=1e-9)  # fmt: skip


@pytest.mark.parametrize(
    ("change", "column", "field"),
    [
        ({"string": {**DESCRIPTION["string"], "radius_mm": -1}}, None, "radius_mm"),
        ({"nonsense": 1}, None, "nonsense"),
        ({"run": "../escape"}, None, "run"),
        ({}, "motor_turns", "motor_turns"),
    ],
)
def test_what_cannot_be_right_is_refused_with_its_field(change, column, field) -> None:
    samples = recording(6)
    with pytest.raises(tb.BadInput, match=field):
        tb.Recording.of(samples.drop(columns=column) if column else samples, {**DESCRIPTION, **change})


def test_a_complaint_about_a_recording_in_memory_names_the_argument_and_no_file(nylon: tb.Recording, tmp_path) -> None:
    """It was "recording/run.yaml: string.radius_mm: is missing": no such file was there."""
    samples, string_entry = recording(6), {"string": {"material": "nylon", "length_mm": 300}}
    with pytest.raises(tb.BadInput, match=r"^Recording\.of: description: string\.radius_mm: is missing\. Mend: add it"):
        tb.Recording.of(samples, {**DESCRIPTION, **string_entry})
    with pytest.raises(tb.BadInput, match=r"^Recording\.of: samples: motor_turns: there is no column") as caught:
        tb.Recording.of(samples.drop(columns="motor_turns"), DESCRIPTION)
    assert caught.value.mend == "name the column under channels.motor_turns in the description"
    misspelt = tb.Recording.of(samples, {**DESCRIPTION, "simulation": [{"id": "creepy"}]})
    with pytest.raises(tb.BadInput, match=r"^Recording\.of: description: simulation\[0\]\.id: 'creepy' is not a mech"):
        misspelt.simulate()
    kept = tb.Recording.read(nylon.save(tmp_path / "raw"))
    for each in (nylon, kept):
        with pytest.raises(tb.BadInput, match=r"^Recording\.simulate: motion: motor_turns: there is no such column"):
            each.simulate(motion=pd.DataFrame({"time_s": [0.0, 1.0]}))
    run_yaml = kept.folder / "run.yaml"
    run_yaml.write_text(run_yaml.read_text().replace("radius_mm", "radius_inch"))
    with pytest.raises(tb.BadInput, match=r"recording/run\.yaml: string\.radius_inch: is not a known key"):
        tb.Recording.read(kept.folder)  # this file is there


@pytest.mark.long
@pytest.mark.parametrize("anew", [False, pytest.param(True, marks=pytest.mark.long)])
def test_a_diagnosis_is_that_of_the_program(
    nylon: tb.Recording, diagnosed_pair, tmp_path: Path, monkeypatch, anew
) -> None:
    """The program diagnoses anew, or is given what the diagnosis in memory was made from."""
    diagnosis, made_from = diagnosed_pair
    folder = nylon.save(tmp_path / "raw")
    words = ["pipeline.diagnose", str(folder), "--out", str(tmp_path / "out")]
    if anew:
        subprocess.run([sys.executable, "-m", *words], check=True, capture_output=True, cwd=ROOT)
    else:
        monkeypatch.setattr(in_a_notebook, "diagnosed", lambda *_: pickle.loads(made_from))
        assert programs.run(*words).returncode == 0
    assert (tmp_path / "out" / "recording" / "diagnosis.json").read_text() == diagnosis.to_json()
    program = tmp_path / "out" / "recording"
    assert diagnosis.save(tmp_path / "kept") == tmp_path / "kept"
    assert (tmp_path / "kept" / "diagnosis.pdf").is_file()  # its bytes depend on what else a process has drawn
    assert {path.name for path in (tmp_path / "kept").iterdir()} == {path.name for path in program.iterdir()}
    for name in ("diagnosis.json", "diagnosis.png"):
        assert (tmp_path / "kept" / name).read_bytes() == (tmp_path / "out" / "recording" / name).read_bytes(), name


def test_a_diagnosis_gives_its_parts_as_objects_and_shows_itself(diagnosis: tb.Diagnosis, tmp_path: Path) -> None:
    json_content = json.loads(diagnosis.to_json())
    assert diagnosis.verdict == json_content["verdict"] and [mechanism.id for mechanism in diagnosis.mechanisms] == [
        entry["id"] for entry in json_content["mechanisms"]
    ]
    assert diagnosis.mechanisms, "the made recording no longer has an effect to name"
    size = diagnosis.mechanisms[0].size
    assert size.unit == "mm" and size.low <= size.value <= size.high
    assert diagnosis.parameters["radius_mm"].unit == "mm"
    for mechanism, entry in zip(diagnosis.mechanisms, json_content["mechanisms"], strict=True):
        still = {name for name, number in entry["parameters"].items() if number["low"] == number["high"]}
        assert set(mechanism.constants) == still and still, "the made recording no longer names one with constants"
        assert mechanism.fitted and mechanism.fitted | mechanism.constants == mechanism.parameters
    shown = diagnosis._repr_html_()
    assert diagnosis.mechanisms[0].id in shown and "data:image/png;base64," in shown
    diagnosis.save(tmp_path)
    read = tb.Diagnosis.read(tmp_path / "diagnosis.json")
    assert (
        read == diagnosis
        and read.words == diagnosis.words
        and read.details == diagnosis.details
        and "<img" not in read._repr_html_()
    )
    with pytest.raises(tb.BadInput, match="diagnose the recording"):
        read.figure()


def test_simulating_with_a_diagnosis_errs_less_and_never_follows_the_reading(nylon, diagnosis) -> None:
    def error_mm(simulated: pd.DataFrame) -> float:
        return float(np.std(nylon.samples["displacement_mm"] - simulated["displacement_mm"]))

    assert error_mm(nylon.simulate(diagnosis)) < 0.5 * error_mm(nylon.simulate())
    start = nylon.samples["time_s"] <= 1.0  # which alone sets the zero
    blind = nylon.samples.assign(displacement_mm=nylon.samples["displacement_mm"].where(start, 3.0))
    blinded = tb.Recording(nylon.run, blind, nylon.folder)
    pd.testing.assert_frame_equal(blinded.simulate(), nylon.simulate())


def test_a_planned_motion_is_simulated_as_the_program_does(nylon, diagnosis, tmp_path: Path) -> None:
    folder, plan = nylon.save(tmp_path / "raw"), tmp_path / "plan.csv"
    (tmp_path / "diagnosis.json").write_text(diagnosis.to_json())
    top = float(nylon.samples["motor_turns"].max())
    motion = pd.DataFrame({"time_s": [0.0, 1.0, 14.0, 15.0, 28.0], "motor_turns": [0.0, 0.0, top - 1, top - 1, 0.0]})
    motion.to_csv(plan, index=False)
    words = ["--simulation", tmp_path / "diagnosis.json", "--motion", plan, "--out", tmp_path / "out.parquet"]
    done = programs.run("pipeline.simulate", folder, *words)
    assert done.returncode == 0, done.stderr
    simulated = nylon.simulate(diagnosis, motion)
    pd.testing.assert_frame_equal(simulated, pd.read_parquet(tmp_path / "out.parquet"))
    inside = simulated[simulated["outside"] == 0.0]
    assert (
        len(inside) > len(simulated) / 2
        and inside["displacement_mm"].between(inside["low_mm"], inside["high_mm"]).all()
    )
    with pytest.raises(tb.BadInput, match="motor_turns"):
        nylon.simulate(diagnosis, motion.drop(columns="motor_turns"))


def test_models_fit_answer_and_come_back_by_name(nylon: tb.Recording, tmp_path: Path) -> None:
    points = tb.points([nylon])
    model = tb.fit("polynomial", points[points["within"] == "train"], degree=4)
    model.save(tmp_path / "p.model")
    again = tb.load("polynomial", tmp_path / "p.model")
    np.testing.assert_array_equal(again.forward(points), model.forward(points))
    count = (points["within"] == "train").sum()
    assert repr(model) == f"<FittedModel polynomial, fitted to {count} points of recording>"
    assert repr(again) == f"<FittedModel polynomial, read from {tmp_path / 'p.model'}>"
    several = pd.concat([points.assign(string=name) for name in "dacb"])
    assert repr(tb.fit("polynomial", several, degree=2)).endswith(f"fitted to {4 * len(points)} points of 4 strings>")
    assert {"spline", "inn", "traditional"} <= set(tb.model_names())
    with pytest.raises(tb.BadInput, match="polynomial"):
        tb.fit("nothing", points)
    with pytest.raises(tb.BadInput, match="strength"):
        tb.fit("spline", points, strength=1)
    with pytest.raises(tb.BadInput, match="load_n"):
        tb.fit("spline", points.drop(columns="load_n"))
    with pytest.raises(tb.BadInput, match="recordings"):
        tb.points([])
    with pytest.raises(tb.BadInput, match=r"p\.model"):
        tb.load("spline", tmp_path / "p.model")


def test_a_model_asked_without_a_column_or_by_a_wrong_name_is_refused_in_words(
    nylon: tb.Recording, tmp_path: Path
) -> None:
    points = tb.points(nylon)
    for name, lacks in (("spline", "torsion_zone_mm"), ("calibrated", "string")):
        model = tb.fit(name, points)
        for answer in (model.forward, model.inverse):
            with pytest.raises(tb.BadInput, match=rf"{lacks}: is no column.*answers\(points, questions\)"):
                answer(points.drop(columns=lacks))
    model.save(tmp_path / "made.model")
    with pytest.raises(tb.BadInput, match=r"give one of model_names\(\)"):
        tb.load(str(tmp_path / "made.model"), "calibrated")
    for wrong, match in (
        (lambda: tb.fit("spline", points, knots=3), r"^settings: spline\.knots: is no setting"),
        (lambda: tb.fit("spline", points, bins=np.array(3)), r"^settings: spline: .*ndarray"),
        (lambda: tb.answers(points, points, "splin"), r"^model: name: is 'splin'"),
        (lambda: tb.answers(points, points, level=2.0), r"^level: 2\.0: is no probability"),
        (lambda: tb.load("mlp", tmp_path / "made.model"), r"made\.model: model: is no saved mlp"),
        (lambda: tb.load("spline", tmp_path / "none.model"), r"none\.model: model: cannot be read"),
    ):
        with pytest.raises(tb.BadInput, match=match) as caught:
            wrong()
        assert "--" not in str(caught.value), "a notebook has no options"


def test_a_model_whose_library_is_not_installed_says_which(
    nylon: tb.Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    monkeypatch.delitem(sys.modules, "pipeline.models.cinn", raising=False)
    with pytest.raises(
        tb.BadInput, match=r"^python: torch: is not installed\. Mend: pip install 'twistbench\[models\]'\.$"
    ):
        tb.fit("cinn", tb.points([nylon]))


def test_no_room_or_program_has_the_name_of_a_public_one() -> None:
    """A program `fit` took the place of the function as soon as somebody imported it."""
    folder = ROOT / "pipeline"
    inside = {path.stem for path in folder.glob("*.py")} | {path.name for path in folder.iterdir() if path.is_dir()}
    assert not inside & set(tb.__all__)


def test_a_diagnosis_of_something_else_is_refused(nylon: tb.Recording) -> None:
    with pytest.raises(tb.BadInput, match=r"are DataFrame.*Recording\.read"):
        tb.Diagnosis.of(nylon.samples)  # type: ignore[arg-type]


def test_a_plan_may_go_on_after_the_recording(nylon: tb.Recording, diagnosis: tb.Diagnosis) -> None:
    motion = pd.DataFrame({"time_s": [0.0, 5.0, 10.0], "motor_turns": [0.0, 10.0, 0.0], "load_n": 20.0})
    fresh, after = (nylon.simulate(diagnosis, motion, after_recording=late) for late in (False, True))
    assert not np.allclose(fresh["displacement_mm"], after["displacement_mm"], atol=1e-3)


def test_a_plan_that_leaves_what_was_recorded_is_warned_of(nylon: tb.Recording, diagnosis: tb.Diagnosis) -> None:
    motion = pd.DataFrame({"time_s": [0.0, 5.0, 10.0], "motor_turns": [0.0, 10.0, 0.0], "load_n": 90.0})
    warned = r"^motion: it asks for load_n of 90 .* Mend: keep load_n at 20, or record a stroke that does as the plan"
    with pytest.warns(UserWarning, match=warned):
        assert nylon.simulate(diagnosis, motion)["outside"].any()


@pytest.mark.long
def test_the_example_of_the_reference_runs(
    nylon: tb.Recording, diagnosis: tb.Diagnosis, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (example,) = re.findall(r"```python\n(.+?)```", (ROOT / "docs" / "api.md").read_text("utf-8"), re.S)
    nylon.save(tmp_path / "raw")
    shutil.copy(ROOT / "docs" / "tutorial" / "nylon_log.csv", tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(tb.Diagnosis, "of", lambda of: diagnosis)  # the slow part, which other tests run
    exec(example.replace("twistbench", "pipeline").replace("nylon-20261121-01", "recording"), {})
    assert (tmp_path / "reports" / "nylon" / "verdict.txt").is_file() and (tmp_path / "nylon.model").is_file()


def test_questions_are_answered_as_the_program_answers_them(nylon: tb.Recording, tmp_path: Path) -> None:
    points = tb.points([nylon])
    questions = pd.DataFrame({"stroke": 3, "direction": [1, -1, 1, 5], "motor_turns": [5.0, 10.0, 90.0, 1.0]})
    answers = tb.answers(points, questions.set_axis(list("abcd")), "polynomial", degree=4)
    assert answers["inside"].tolist() == [True, True, False, False]
    assert (answers["displacement_mm_low"][:2] < answers["displacement_mm"][:2]).all()
    assert answers.loc[2:, ["displacement_mm_low", "displacement_mm_high"]].isna().all(axis=None)
    assert "90 turns is above" in answers["why"][2] and "neither 1 nor -1" in answers["why"][3]
    schemas.write(points, schemas.DATASET, tmp_path / "dataset.parquet")
    questions.to_csv(tmp_path / "questions.csv", index=False)
    words = ["--model", "polynomial", "--settings", '{"degree": 4}', "--out", tmp_path / "answers.csv"]
    done = programs.run("pipeline.predict", tmp_path / "dataset.parquet", tmp_path / "questions.csv", *words)
    assert done.returncode == 2 and "in row 4" in done.stderr, "a bad row costs itself alone"
    assert (tmp_path / "answers.csv").read_text() == answers.to_csv(index=False, float_format="%.6g")


def test_points_have_the_models_zero_and_the_recording_says_by_how_much_it_is_moved(nylon: tb.Recording) -> None:
    """Answers and simulated readings stood 0.2 mm apart, and nothing said why."""
    points = tb.points([nylon]).set_index("time_s")["displacement_mm"]
    read = nylon.samples.set_index("time_s")["displacement_mm"].reindex(points.index)
    np.testing.assert_allclose(points - read, nylon.tare_mm, atol=1e-9)
    assert abs(nylon.tare_mm) > 0.01


def test_questions_that_nobody_can_answer_are_refused(nylon: tb.Recording) -> None:
    points, question = tb.points([nylon]), pd.DataFrame({"stroke": [3], "direction": [1], "motor_turns": [5.0]})
    for wrong, match in (
        (question.rename(columns={"motor_turns": "twist"}), "rename it: motor_turns"),
        (question.drop(columns="motor_turns"), "neither of motor_turns and displacement_mm"),
        (question.drop(columns="stroke"), "stroke"),
        (question[:0], "there are none"),
    ):
        with pytest.raises(tb.BadInput, match=match):
            tb.answers(points, wrong, "polynomial")
    with pytest.raises(tb.BadInput, match="no probability"):
        tb.answers(points, question, "polynomial", level=90)
    with pytest.raises(tb.BadInput, match="a whole motion"):
        tb.answers(points, question, "diagnosed")
    with pytest.raises(tb.BadInput, match="degree"):
        tb.answers(points, question, "polynomial", degree=-1)


def test_recordings_together_are_taken_in_the_order_of_their_recording(monkeypatch) -> None:
    """As the program takes the folders: what creeps and wears goes on from run to run."""
    table, taken = recording(2), []
    of_rig = {**DESCRIPTION, "string": {**DESCRIPTION["string"], "id": "a"}}

    def diagnosed(recorded, *others):
        taken.extend(each.run.run for each in recorded)
        raise InterruptedError

    monkeypatch.setattr(in_a_notebook, "diagnosed", diagnosed)
    later = tb.Recording.of(table.assign(time_s=table["time_s"] + 400.0), {**of_rig, "run": "r-10"})
    with pytest.raises(InterruptedError):
        tb.Diagnosis.of(later, tb.Recording.of(table, {**of_rig, "run": "r-9"}))
    assert taken == ["r-9", "r-10"]
