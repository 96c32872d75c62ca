"""A bounded, seeded fuzz: hostile settings, model files and command lines end in a clean refusal or a right answer."""

import json
import os
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from export.made_models import QUICK
from hostile import NAMES, NUMBERS, damaged, ended
from made_recording import content, recording
from models.made_dataset import made_dataset
from shares import shares

from pipeline.export.interface import names as exported
from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas, seal
from pipeline.models.interface import make_model, names, settings_of
from pipeline.models.parts.configured import configured

HURTS, COMMANDS, SETTINGS = 130, 170, 900  # of each kind of model, of each program, of all models
STRANGE = [
    "0", "-1", "1e999", "-1e999", "NaN", "1e-320", "null", "true", '"7"', '""', "[]", "{}", "[0]", "[-1]", '["x"]',
    "2.5", "9" * 400, "1e400", '{"a": 1}', "[" * 5000, '"' + "x" * 400 + '"', "1, 2",
]  # fmt: skip
TOO_SMALL = {"degree": -1, "bins": 0, "epochs": 0, "batch": 0, "width": 0, "blocks": 0, "layers": 0, "rates": [],
             "ridge": 0, "clamp": 0, "steps": 0, "stroke_degree": -1, "other_degree": -1, "rate": -1}  # fmt: skip


def clean(code: int, complaint: str) -> None:
    """Done, or refused in words without a traceback."""
    assert code in (0, 2), complaint
    assert "Traceback" not in complaint
    assert code == 0 or "error: " in complaint, complaint


@pytest.mark.parametrize("model", [name for name in names() if settings_of(name)])
def test_every_setting_has_its_bounds_and_the_refusal_names_them(model: str) -> None:
    fields = settings_of(model).__dataclass_fields__  # type: ignore[union-attr]
    for name in fields:
        for value in (*([TOO_SMALL[name]] if name in TOO_SMALL else []), "none", None, float("nan"), 10**30, -(10**30)):
            with pytest.raises(BadInput) as refused:
                configured(model, json.dumps({name: value}))
            assert refused.value.file == "--settings" and refused.value.field == f"{model}.{name}"
            assert refused.value.mend.startswith("give ")


def test_settings_are_refused_in_words_whatever_they_are() -> None:
    rng = np.random.default_rng(0)
    for _ in range(SETTINGS):
        model = str(rng.choice(names()))
        kind = settings_of(model)
        keys = [*(kind.__dataclass_fields__ if kind else []), "depth", ""]
        json_pairs = ", ".join(f'"{rng.choice(keys)}": {rng.choice(STRANGE)}' for _ in range(rng.integers(1, 3)))
        text = rng.choice(
            [f"{{{json_pairs}}}", f"{{{json_pairs}", json_pairs, str(rng.choice(STRANGE))], p=[0.7, 0.1, 0.1, 0.1]
        )
        try:
            configured(model, str(text))
        except BadInput as error:
            assert error.file == "--settings" and error.field.startswith(model) and len(str(error)) < 700


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a dataset and a small fitted model of every kind that is exported."""
    folder, points = tmp_path_factory.mktemp("saved"), made_dataset(40, 5)
    schemas.write(points, schemas.DATASET, folder / "dataset.parquet")
    for name in exported():
        model = make_model(
            name, **{**QUICK.get(name, {}), **({"epochs": 2} if "epochs" in QUICK.get(name, {}) else {})}
        )
        model.fit(points[points["within"] == "train"], 0)
        (folder / name).mkdir()
        model.save(folder / name / "within-0.model")
    return folder


@shares
@pytest.mark.parametrize("name", exported())
def test_a_damaged_model_is_refused_and_one_that_is_sealed_again_exported_or_refused(
    saved: Path, tmp_path: Path, name: str, share: float
) -> None:
    shutil.copy(saved / "dataset.parquet", tmp_path)
    (tmp_path / name).mkdir()
    path, rng = tmp_path / name / "within-0.model", np.random.default_rng(1)
    whole = (saved / name / "within-0.model").read_bytes()
    inside = bytes(seal.opened(whole))
    for number in range(round(HURTS * share)):
        resealed = number % 2 == 0  # as if written so: what the check sum cannot see
        path.write_bytes(hurt := seal.sealed(damaged(inside, rng)) if resealed else damaged(whole, rng))
        code, complaint = ended("pipeline.export.__main__", [str(path), "--format", "c", "--out", "tsa.h"], tmp_path)
        clean(code, complaint)
        assert resealed or hurt == whole or code == 2
        if code == 0:
            (tmp_path / "tsa.h").unlink()
        assert not (tmp_path / "tsa.h").exists()


def test_a_truncated_network_and_a_box_of_nan_are_refused(saved: Path, tmp_path: Path) -> None:
    shutil.copytree(saved / "cinn", tmp_path / "cinn")
    shutil.copytree(saved / "spline", tmp_path / "spline")
    cinn, spline = tmp_path / "cinn" / "within-0.model", tmp_path / "spline" / "within-0.model"
    cinn.write_bytes(seal.sealed(bytes(seal.opened(cinn.read_bytes()))[:-500]))
    spline_content = json.loads(bytes(seal.opened(spline.read_bytes())))
    spline_content["box"]["low"]["motor_turns"] = float("nan")
    spline.write_bytes(seal.sealed(json.dumps(spline_content).encode()))
    for path in (cinn, spline):
        for kind in ("c", "onnx"):
            code, complaint = ended("pipeline.export.__main__", [str(path), "--format", kind], tmp_path)
            assert code == 2 and str(path) in complaint and "train it again" in complaint
    assert sorted(path.name for path in tmp_path.iterdir()) == ["cinn", "spline"]


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory, saved: Path) -> Path:
    """A folder with what the programs read: a dataset, questions, a model, run folders, a diagnosis, files of junk."""
    folder = tmp_path_factory.mktemp("place")
    shutil.copytree(saved, folder, dirs_exist_ok=True)
    (folder / "questions.csv").write_text("stroke,direction,motor_turns\n1,1,3\n")
    for name, table in (("a-1", recording(1, rate_hz=10.0)), ("a-3", recording(3)), ("short-1", recording(1).iloc[:5])):
        (folder / "raw" / name).mkdir(parents=True)
        (folder / "raw" / name / "run.yaml").write_text(json.dumps(content(name)))
        table.to_parquet(folder / "raw" / name / "recording.parquet", index=False)
    schemas.write(made_dataset(40, 5).assign(later=""), schemas.DATASET, folder / "points.parquet")
    (folder / "simulation.json").write_text('{"run": "a-1", "parameters": {}, "simulation": []}')
    (folder / "junk").write_bytes(np.random.default_rng(0).integers(256, size=500, dtype=np.uint8).tobytes())
    (folder / "empty").write_bytes(b"")
    (folder / "locked").mkdir()
    return folder


GOOD = {  # command lines that work, or end soon; every try spoils at least one word
    "predict": "dataset.parquet questions.csv --model polynomial --settings {} --level 0.9 --seed 0 --out out/a.csv",
    "dataset": "raw/a-3 --out out/d",
    "fit_model": "polynomial points.parquet --settings {} --seed 0 --out out/m",
    "stages.train": "dataset.parquet --model polynomial --split within --seed 0 --settings {} --out-model out/m "
    "--out-predictions out/p.parquet",
    "export.__main__": "spline/within-0.model --format c --out out/t.h --name tsa --model spline "
    "--dataset dataset.parquet --split within --string made-01",
    "lifespan.__main__": "raw/a-1 --loss 0.1 --drift-mm 1 --level 0.9 --out out/life",
    "simulate": "raw/a-1 --simulation simulation.json --out out/s.parquet",
    "adopt": "simulation.json raw/a-3",
    "diagnose": "raw/short-1 --out out/d --jobs 1",
    "stages.campaign.points": "locked --out out/c.parquet",
    "stages.campaign.few_shot": "dataset.parquet --model polynomial --settings {} --seed 0 --out out/f.parquet",
    "stages.campaign.coverage": "dataset.parquet --model polynomial --settings {} --seed 0 --strings 2 --out o.parquet",
    "stages.campaign.floor": "dataset.parquet --out out/f.parquet",
}
OTHERS = ("junk", "empty", "locked", "nowhere/at/all", "dataset.parquet", "raw/a-1", "questions.csv", "junk/under")


@shares
@pytest.mark.parametrize("program", GOOD)
def test_a_spoilt_command_line_is_answered_or_refused(program: str, place: Path, share: float) -> None:
    rng, before = np.random.default_rng(list(program.encode())), sorted(Path("/dev").iterdir())
    for number in range(round(COMMANDS * share)):  # each spoils one word or two, and may end early
        words = GOOD[program].split()
        spoils = rng.choice(len(words), size=int(rng.integers(1, 3)), replace=False)
        for at in spoils:
            pool = NUMBERS if words[at].replace(".", "").isdigit() else (*NAMES, *NUMBERS, *OTHERS, *OTHERS)
            words[at] = str(pool[int(rng.integers(len(pool)))])
        if number % 7 == 0:
            words = words[: int(rng.integers(len(words)))]
        try:
            clean(*ended(f"pipeline.{program}", words, place))
        except Exception as error:
            raise AssertionError(f"{program} {words}"[:1500]) from error
    assert sorted(Path("/dev").iterdir()) == before and not list(place.rglob("PWNED"))
    assert Path("/dev/full").is_char_device() and Path("/dev/null").is_char_device()


@pytest.mark.parametrize("wrong", ["", "locked", "junk/under/a.csv", "/dev/full", "a" * 300])
def test_where_nothing_can_be_written_is_said_before_the_work(place: Path, wrong: str) -> None:
    words = ["dataset.parquet", "questions.csv", "--model", "polynomial", "--out", wrong]
    code, complaint = ended("pipeline.predict", words, place)
    assert code == 2 and complaint.startswith("error: --out: ") and "Mend: name" in complaint
    assert not [path for path in place.rglob("*") if path.name.startswith(".")]


@pytest.mark.parametrize(
    ("program", "words", "out"),
    [
        ("simulate", "raw/a-1 --simulation simulation.json --out", "raw/a-1/recording.csv"),
        ("simulate", "raw/a-1 --simulation simulation.json --out", "raw/a-1/run.yaml"),
        ("simulate", "raw/a-1 --simulation simulation.json --out", "simulation.json"),
        ("stages.ingest", "raw/a-1 --out", "raw/a-1/recording.parquet"),
        ("stages.ingest", "raw/a-1 --out b.parquet --out-strokes", "raw/a-1/recording.parquet"),
        ("dataset", "raw/a-1 --out", "raw/a-1"),
        ("stages.dataset", "raw/a-1 --processed processed --out", "processed/a-1/samples.parquet"),
        (
            "stages.train",
            "dataset.parquet --model polynomial --split within --out-model m --out-predictions",
            "dataset.parquet",
        ),
        ("predict", "dataset.parquet questions.csv --model polynomial --out", "./questions.csv"),
        ("predict", "dataset.parquet questions.csv --model polynomial --out", "linked.parquet"),
        ("stages.campaign.floor", "dataset.parquet --out", "dataset.parquet"),
        ("export.__main__", "spline/within-0.model --format c --out", "spline/within-0.model"),
        ("export.__main__", "spline/within-0.model --format c --out", "dataset.parquet"),
    ],
)
def test_nothing_that_is_read_and_no_recording_is_ever_written_over(
    place: Path, tmp_path: Path, program: str, words: str, out: str
) -> None:
    shutil.copytree(place, tmp_path, dirs_exist_ok=True)
    (tmp_path / "linked.parquet").symlink_to("dataset.parquet")
    assert ended("pipeline.stages.ingest", ["raw/a-1", "--out", "samples.parquet"], tmp_path)[0] == 0
    (tmp_path / "processed" / "a-1").mkdir(parents=True)
    shutil.copy(tmp_path / "samples.parquet", tmp_path / "processed" / "a-1")
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    code, complaint = ended(f"pipeline.{program}", [*words.split(), out], tmp_path)
    assert code == 2 and complaint.startswith("error: --out") and f": {Path(out)}: " in complaint, complaint
    assert before == {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}


ACTS = '{"run": "a-3", "parameters": {}, "simulation": [{"id": "%s", "parameters": {%s}}]}'
EDITED = {  # what a diagnosis.json is edited to, and the field that is then named
    '{"parameters": {"radius_mm": {"value": %s}}, "simulation": []}' % ("9" * 400): "parameters.radius_mm",
    ACTS % ("backlash", '"half_width_turns": ' + "9" * 400): "simulation[0].parameters.half_width_turns",
    ACTS % ("load_swing", '"frequency_hz": 0, "damping": 0.1, "heavy_slow": 0'): "simulation[0].parameters",
    ACTS % ("slack", '"take_up_turns": 1, "stop": 1, "softness": 0.1'): "simulation[0].parameters",
    ACTS % ("backlash", '"half_width_turns": 1, "share": 1e308'): "simulation",
    ACTS % ("x" * 1_000_000, ""): "simulation[0].id",
    ACTS % ("backlash", '"half_width_turns": "%s"' % ("x" * 1_000_000)): "simulation[0].parameters.half_width_turns",
    '{"run": [], "parameters": {}, "simulation": []}': "run",
    "[" * 100_000: "file",
    "a pipe": "file",
}  # fmt: skip


OF_MECHANISMS = [text for text in EDITED if EDITED[text] != "parameters.radius_mm"]  # dimensions are not adopted
TAKEN = [*(("simulate", text) for text in EDITED), *(("adopt", text) for text in OF_MECHANISMS)]


@pytest.mark.parametrize(("program", "edited"), TAKEN, ids=range(len(TAKEN)))
def test_an_edited_diagnosis_is_refused_in_words_and_nothing_is_simulated(
    place: Path, tmp_path: Path, program: str, edited: str
) -> None:
    path, out, described = tmp_path / "diagnosis.json", tmp_path / "out.parquet", place / "raw" / "a-3" / "run.yaml"
    before = described.read_bytes()
    words = ["raw/a-3", "--simulation", str(path), "--out", str(out)] if program == "simulate" else [path, "raw/a-3"]
    if edited == "a pipe":
        os.mkfifo(path)
    else:
        path.write_text(edited)
    code, complaint = ended(f"pipeline.{program}", list(map(str, words)), place)
    assert (
        code == 2
        and described.read_bytes() == before
        and f"{path}: {EDITED[edited]}: " in complaint
        and "Mend: " in complaint
    ), complaint[:2000]
    assert len(complaint) < 2000 and not out.exists()


DIGITS = "9" * 400  # a whole number that no float holds


def test_a_cell_of_400_digits_costs_a_question_itself_and_refuses_a_plan(place: Path, tmp_path: Path) -> None:
    questions, plan, out = tmp_path / "q.csv", tmp_path / "p.csv", tmp_path / "o.csv"
    questions.write_text(f"stroke,direction,motor_turns\n1,1,3\n1,1,-{DIGITS}\n")
    words = ["dataset.parquet", str(questions), "--model", "polynomial", "--out", str(out)]
    code, complaint = ended("pipeline.predict", words, place)
    assert code == 2 and "motor_turns: is without end in row 2. Mend: write a number." in complaint
    answered = pd.read_csv(out)
    assert answered["displacement_mm"].notna().tolist() == answered["inside"].tolist() == [True, False]
    out.unlink()
    plan.write_text(f"time_s,motor_turns,load_n\n0,0,20\n5,{DIGITS},20\n9,0,20\n")
    words = ["raw/a-3", "--simulation", "simulation.json", "--motion", str(plan), "--out", str(out)]
    code, complaint = ended("pipeline.simulate", words, place)
    assert code == 2 and "motor_turns: is not a number in 1 of 3 rows, first in row 2" in complaint and not out.exists()


def test_a_number_of_400_digits_in_a_json_recording_is_named_by_its_row(place: Path, tmp_path: Path) -> None:
    rows = recording(1, rate_hz=10.0).to_dict("records")
    rows[20]["load_n"] = rows[22]["displacement_mm"] = int(DIGITS)
    (tmp_path / "log.json").write_text(json.dumps(rows))
    described = {key: value for key, value in content("b-9").items() if key != "run"}
    (tmp_path / "mapping.yaml").write_text(json.dumps(described))
    assert ended("pipeline.import_run", ["log.json", "--guess"], tmp_path)[0] == 0
    words = ["log.json", "--map", "mapping.yaml", "--run", "b-9"]
    code, complaint = ended("pipeline.import_run", words, tmp_path)
    assert code == 2 and "log.json: displacement_mm: is not a number in 1 of 320 rows, first in row 23" in complaint


@pytest.mark.parametrize(
    ("edited", "field"),
    [
        ('{"run": "a-3", "parameters": {}, "simulation": [{"parameters": {}}]}', "simulation[0]"),
        ('{"run": "a-3", "parameters": {}, "simulation": [true]}', "simulation[0]"),
        ('{"run": "a-3", "parameters": {}, "simulation": [], "closest": [1]}', "closest"),
        (
            '{"run": "a-3", "parameters": {}, "simulation": [], '
            '"closest": {"ids": [], "parameters": {}, "simulation": [7]}}',
            "simulation[0]",
        ),
    ],
)
@pytest.mark.parametrize("motion", [True, False])
def test_what_cannot_act_is_refused_before_a_plan_too(
    place: Path, tmp_path: Path, edited: str, field: str, motion: bool
) -> None:
    path, plan, out = tmp_path / "s.json", tmp_path / "p.csv", tmp_path / "o.csv"
    path.write_text(edited)
    plan.write_text("time_s,motor_turns,load_n\n0,0,20\n5,10,20\n9,0,20\n")
    words = ["raw/a-3", "--simulation", str(path), *(["--motion", str(plan)] if motion else []), "--out", str(out)]
    code, complaint = ended("pipeline.simulate", words, place)
    assert code == 2 and complaint.startswith(f"error: {path}: {field}: is ") and not out.exists(), complaint


@pytest.mark.parametrize(
    ("program", "words"),
    [
        ("new_run", "b-9 --like raw/a-1 --out"),
        ("import_run", "raw/a-1/recording.parquet --map mapping.yaml --run b-9 --out"),
        ("import_run", "raw/a-1/recording.parquet --guess --out"),
        ("simulate", "raw/a-3 --simulation simulation.json --out"),
        ("settle.__main__", "raw/a-1 --out"),
        ("dataset", "raw/a-3 --out"),
        ("fit_model", "polynomial dataset.parquet --out"),
    ],
)
def test_a_place_a_thousand_folders_deep_is_refused_in_words(place: Path, program: str, words: str) -> None:
    described = {key: value for key, value in content("b-9").items() if key != "run"}
    (place / "mapping.yaml").write_text(json.dumps(described))
    code, complaint = ended(f"pipeline.{program}", [*words.split(), "deep/" * 500 + "x"], place)
    assert code == 2 and "--out" in complaint and "Mend: " in complaint and not (place / "deep").exists()


LONG = {  # command lines of which one word has 5,000 characters
    "new_run": ["{}", "b-9 {}", "b-9 --like {}", "b-9 --radius-mm {}", "b-9 --like raw/a-1 --file {}", "b-9 --{} 1"],
    "import_run": ["{} --map m --run b-9", "junk --map {} --run b-9", "junk --map m --run {}", "junk {}"],
    "lifespan.__main__": ["{}", "raw/a-1 --loss {}", "raw/a-1 --out {}", "raw/a-1 {}"],
    "settle.__main__": ["{}", "raw/a-3 --out {}", "raw/a-3 --{}"],
    "capture.__main__": ["{} raw/b-9", "/dev/null {}", "/dev/null raw/b-9 --baud {}", "/dev/null raw/b-9 --program {}"],
    "predict": ["dataset.parquet questions.csv --model {} --out o", "dataset.parquet {} --model polynomial --out o"],
    "dataset": ["{}", "raw/a-3 {}", "raw/a-3 --out {}"],
    "fit_model": ["{} dataset.parquet", "polynomial {}", "polynomial dataset.parquet --settings {}"],
    "pack.unpack": ["{}", "a.zip {}"],
    "stages.train": ["dataset.parquet --model {}", "dataset.parquet --split {}", "{}"],
}


@pytest.mark.parametrize("word", ["9" * 5000, "a b " * 1250, "a/" * 2500, "{b: " + "9" * 5000 + "}"], ids=range(4))
@pytest.mark.parametrize("program", LONG)
def test_a_word_of_5000_characters_is_not_repeated_whole(place: Path, program: str, word: str) -> None:
    for line in LONG[program]:
        words = [part.replace("{}", word) for part in line.split()]
        code, complaint = ended(f"pipeline.{program}", words, place)
        assert code == 2 and "error: " in complaint and len(complaint) < 2000, (line, len(complaint), complaint[:3000])


def test_another_actuator_than_the_recorded_is_refused(place: Path) -> None:
    """It was answered -0.048 for 1.078 as lying inside."""
    questions = place / "pair.csv"
    questions.write_text("stroke,direction,motor_turns,actuator\n1,1,3,separator\n1,1,3,twisted_pair\n")
    words = ["dataset.parquet", str(questions), "--model", "polynomial", "--out", "pair-answers.csv"]
    code, complaint = ended("pipeline.predict", words, place)
    assert code == 2 and "actuator: is twisted_pair, and the recordings are of separator" in complaint
    assert not (place / "pair-answers.csv").exists()


def test_a_fit_that_runs_away_is_refused_and_names_the_model(place: Path) -> None:
    points = pd.read_parquet(place / "dataset.parquet")
    points["displacement_mm"] *= 1e200
    schemas.write(points, schemas.DATASET, place / "huge.parquet")
    for model, settings in (("mlp", '{"epochs": 1, "width": 4}'), ("spline", "{}")):
        words = ["huge.parquet", "--model", model, "--split", "within", "--settings", settings]
        code, complaint = ended(
            "pipeline.stages.train", [*words, "--out-model", "m", "--out-predictions", "p.parquet"], place
        )
        assert code == 2 and f"--model: {model}: cannot be fitted" in complaint and not (place / "m").exists()
