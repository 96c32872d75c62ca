"""The commands: `diagnosis.json` has the keys of `diagnosis/document/content.py` and comes out byte for byte again.

Then adoption, simulation alone, and bad input.
"""

import contextlib
import importlib.util
import io
import json
import re
import shutil
import subprocess
import sys
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml
from PIL import Image

from pipeline import diagnose
from pipeline.diagnosis.drawing import figures
from pipeline.diagnosis.fit.adopt import acts_from
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.numerics.noise import resolution
from pipeline.diagnosis.one_rig import described, of_one_rig
from pipeline.diagnosis.prediction.simulation import read_diagnosis, state_of
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas
from pipeline.ground.stored.files import sha256
from pipeline.notebook import of_folders
from pipeline.run import strokes
from pipeline.run.clean_motion import Motion
from pipeline.run.samples import read_samples, read_strokes

DRAWN = figures.page
ROOT = Path(__file__).resolve().parents[2]


@dataclass
class Done:
    """How a command ended, and what it said."""

    returncode: int
    stdout: str
    stderr: str


def command(module: str, *arguments: object) -> Done:
    """A command of the project, run in this process, which spares it the imports."""
    printed, complained, before = io.StringIO(), io.StringIO(), sys.argv
    sys.argv = [module, *map(str, arguments)]
    try:
        with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(complained):
            importlib.import_module(module).main()
        code = 0
    except SystemExit as ended:
        code = int(ended.code or 0)
    finally:
        sys.argv = before
    return Done(code, printed.getvalue(), complained.getvalue())


@pytest.fixture(scope="module")
def diagnosed(conceal, remembered, tmp_path_factory) -> tuple[Path, dict, Path, dict]:
    """A run with creep, its truth, its diagnosis' folder and content."""
    folder, truth = conceal("creep")
    out = tmp_path_factory.mktemp("out")
    with remembered(), pytest.MonkeyPatch.context() as patch:
        patch.setattr(figures, "page", DRAWN)
        done = command("pipeline.diagnose", folder, "--out", out)
    assert done.returncode == 0, done.stderr
    diagnosis_folder = out / folder.name
    return folder, truth, diagnosis_folder, json.loads((diagnosis_folder / "diagnosis.json").read_text())


def test_the_json_has_the_keys_that_programs_read(diagnosed) -> None:
    folder, _, diagnosis_folder, content = diagnosed
    assert list(content) == [
        "run", "verdict", "mismatch", "mechanisms", "alternatives", "next_experiment", "next_run", "parameters",
        "fit", "simulation", "code", "evidence", "uncertainty", "without_last_strokes",
    ]  # fmt: skip
    assert content["run"] == folder.name and content["verdict"] == "explained"
    assert set(content["mismatch"]) == {"rms_mm", "location", "driver"}
    assert set(content["mismatch"]["location"]) == {"motor_turns", "strokes", "phase", "share"}
    (creep,) = content["mechanisms"]
    assert set(creep) == {"id", "confidence", "rms_mm", "parameters", "location", "sentence"}
    assert creep["rms_mm"]["low"] <= creep["rms_mm"]["value"] <= creep["rms_mm"]["high"]
    assert set(content["parameters"]["radius_mm"]) == {"nominal", "value", "low", "high"}
    zero = content["parameters"]["zero_mm"]  # its interval had no width
    assert (
        zero["low"] < zero["value"] < zero["high"]
        and zero["high"] - zero["low"] > content["uncertainty"][0]["moves"][0]
    )
    assert set(content["fit"]) == {"noise_floor_mm", "detectable_mm", "heldout"}
    assert creep["sentence"].startswith("Under load the string lengthens by up to ") and " mm rms)" in creep["sentence"]
    assert (diagnosis_folder / "diagnosis.png").stat().st_size > 10_000
    assert (
        diagnosis_folder / "diagnosis.json.sha256"
    ).read_text() == f"{sha256(diagnosis_folder / 'diagnosis.json')}  diagnosis.json\n"
    assert (diagnosis_folder / "diagnosis.pdf").read_bytes().startswith(b"%PDF")
    with Image.open(diagnosis_folder / "diagnosis.png") as image:
        assert image.info["dpi"][0] >= 200


def test_what_the_recording_covers_holds_the_temperature_that_was_logged(diagnosed) -> None:
    folder, _, _, content = diagnosed
    low, high = content["evidence"]["covered"]["temperature_c"]
    logged = read_samples(folder)[1]["temperature_c"]
    assert logged.min() < low < logged.quantile(0.05) and logged.quantile(0.95) < high < logged.max()


def test_every_explanation_that_was_weighed_has_its_standing_and_its_words(diagnosed) -> None:
    _, _, diagnosis_folder, content = diagnosed
    shown = content["evidence"]["explanations"]
    standing = {tuple(entry["ids"]): entry["standing"] for entry in shown}
    assert standing[("creep",)] == "named" and standing[()] == "nothing"
    assert {"beaten", "not needed"} & set(standing.values())
    text = (diagnosis_folder / "details.txt").read_text()
    assert (diagnosis_folder / "verdict.txt").read_text().startswith(text.splitlines()[0])
    assert "The run to make next\n  None is needed: " in text and content["next_experiment"] is None
    assert content["evidence"]["nominal_mm"] > content["evidence"]["calibrated_mm"] > content["fit"]["noise_floor_mm"]
    assert text.startswith(f"{content['run']}: explained by ") and "\nHow probable each explanation is\n" in text
    for entry in (entry for entry in shown if entry["standing"] == "beaten"):
        assert set(entry["location"]) == {"motor_turns", "strokes", "phase", "share"} and entry["gap_mm"] > 0.0
        row = rf"^  (\d+ +)?{re.escape(' + '.join(entry['ids']))}  .*(mm \([\d.]+\)|as much as )"  # of either table
        assert re.search(row, text, re.MULTILINE)
    assert not re.search(r"\de[+-]\d", text)


@pytest.mark.long
def test_a_library_without_the_truth_never_names_it_and_says_what_to_run_next(diagnosed, tmp_path) -> None:
    folder, _, _, first = diagnosed
    done = command("pipeline.diagnose", folder, "--out", tmp_path, "--without", "creep", "--without", "thermal")
    assert done.returncode == 0, done.stderr
    content = json.loads((tmp_path / folder.name / "diagnosis.json").read_text())
    named = {id_ for ids in [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]] for id_ in ids}
    assert content["without"] == ["creep", "thermal"] and not named & {"creep", "thermal"}
    assert content["code"] == first["code"] and len(content["code"]) == 16
    assert first["next_run"] is None and content["verdict"] in ("unknown", "ambiguous")  # no firm name
    legs = content["next_run"]["legs"]
    assert all(set(leg) == {"seconds", "motor_turns", "load_n"} and leg["seconds"] > 0 for leg in legs)
    assert " turns in " in content["next_experiment"] and "1. " in content["next_experiment"]
    text = (tmp_path / folder.name / "details.txt").read_text()
    both = f"python -m pipeline.diagnose {folder} {folder}-next --together --out {tmp_path / folder.name}-next\n"
    assert both in text
    unknown = command("pipeline.diagnose", folder, "--out", tmp_path / "none", "--without", "crep")
    assert unknown.returncode == 2 and "crep is no mechanism" in unknown.stderr and not (tmp_path / "none").exists()


def test_floor_and_held_out_error_are_the_noise(diagnosed) -> None:
    _, truth, _, content = diagnosed
    heldout = content["fit"]["heldout"]
    assert abs(content["fit"]["noise_floor_mm"] / truth["floor"] - 1) < 0.06
    assert heldout["explained_mm"] < 1.15 * truth["floor"] < heldout["calibrated_mm"] < heldout["nominal_mm"]


@pytest.mark.long
def test_again_is_the_same_byte_for_byte(diagnosed, tmp_path) -> None:
    folder, _, diagnosis_folder, _ = diagnosed
    words = [sys.executable, "-m", "pipeline.diagnose", str(folder), "--out", str(tmp_path)]
    assert subprocess.run(words, cwd=ROOT, capture_output=True, check=False).returncode == 0
    assert (tmp_path / folder.name / "diagnosis.json").read_bytes() == (
        diagnosis_folder / "diagnosis.json"
    ).read_bytes()


def test_simulate_alone_gives_the_error_that_the_diagnosis_claims(diagnosed, tmp_path) -> None:
    folder, truth, diagnosis_folder, _ = diagnosed
    out = tmp_path / "simulated.parquet"
    done = command("pipeline.simulate", folder, "--simulation", diagnosis_folder / "diagnosis.json", "--out", out)
    assert done.returncode == 0, done.stderr
    simulated, recorded = pd.read_parquet(out), pd.read_parquet(folder / "recording.parquet")
    assert list(simulated.columns) == ["time_s", "displacement_mm"]
    error = simulated["displacement_mm"].to_numpy() - recorded["displacement_mm"].to_numpy()
    assert np.sqrt(np.mean(error**2)) < 1.1 * truth["floor"]


def test_every_effect_that_is_not_kept_has_what_speaks_against_it(diagnosed) -> None:
    _, _, diagnosis_folder, content = diagnosed
    first, *others = content["evidence"]["not_kept"]
    kept = {entry["id"] for entry in content["mechanisms"]} | {id_ for ids in content["alternatives"] for id_ in ids}
    assert {entry["id"] for entry in others} | kept == {id_ for id_ in mechanisms() if not id_.startswith("x_")}
    assert not kept & {entry["id"] for entry in others}
    (named,) = [entry for entry in content["evidence"]["explanations"] if entry["standing"] == "named"]
    assert first["left_mm"] == pytest.approx(named["left_mm"], rel=1e-3)
    assert all(entry["left_mm"] > first["left_mm"] for entry in others if entry["left_mm"] is not None)
    assert all(abs(change["change"]) < 4 * change["error"] for change in first["stands"].values())
    loss = next(entry for entry in others if entry["id"] == "viscous_loss")
    assert loss["possible"] and loss["beside_mm"] <= 1.001 * first["left_mm"]
    assert "\nWhy it is none of the other effects\n" in (diagnosis_folder / "details.txt").read_text()


def test_what_is_adopted_is_not_found_again(diagnosed, tmp_path) -> None:
    folder, _, diagnosis_folder, content = diagnosed
    adopted = tmp_path / folder.name
    shutil.copytree(folder, adopted)
    adopting = command("pipeline.adopt", diagnosis_folder / "diagnosis.json", adopted)
    assert adopting.returncode == 0, adopting.stderr
    block = (diagnosis_folder / "simulation.yaml").read_text()  # what may be pasted instead
    assert block in (adopted / "run.yaml").read_text()
    block_content = yaml.safe_load(block)
    assert set(block_content) == {"simulation", "adopted"} and block_content["simulation"] == content["simulation"]
    assert [(adoption["effects"], adoption["verdict"], adoption["tied"]) for adoption in block_content["adopted"]] == [
        (["creep"], "explained", [])
    ]
    assert (
        f"python -m pipeline.adopt {diagnosis_folder / 'diagnosis.json'} {folder}\n"
        in (diagnosis_folder / "verdict.txt").read_text()
    )
    (tmp_path / "out" / folder.name).mkdir(parents=True)
    (tmp_path / "out" / folder.name / "simulation.yaml").write_text(block)  # of an earlier diagnosis
    done = command("pipeline.diagnose", adopted, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    again = json.loads((tmp_path / "out" / folder.name / "diagnosis.json").read_text())
    assert again["verdict"] in ("consistent", "parameters")
    (kept,) = again["evidence"]["adopted_effects"]
    assert kept["id"] == "creep" and kept["sentence"].startswith("Under load the string lengthens by up to")
    assert kept["rms_mm"] == pytest.approx(content["mechanisms"][0]["rms_mm"]["value"], rel=0.05)
    assert again["evidence"]["adopted_mm"] < 1.3 * again["evidence"]["floor_mm"] < again["evidence"]["nominal_mm"]
    assert not (tmp_path / "out" / folder.name / "simulation.yaml").exists()
    text = (tmp_path / "out" / folder.name / "details.txt").read_text()
    nothing = "What was adopted tied with others." if content["alternatives"] else "None is proposed: "
    assert f"The run to make next\n  {nothing}" in text
    moved = re.search(r"\nDimensions\n +dimension +as measured .*\n.* [0-9.]+( \([+-].* %\))?\n", text)
    assert (again["verdict"] == "parameters") == bool(moved)


def edited(source: Path, to: Path, samples: pd.DataFrame | None = None, **described: object) -> Path:
    """A copy of a run with other samples, or other words in its run.yaml."""
    shutil.copytree(source, to)
    words = yaml.safe_load((to / "run.yaml").read_text()) | {"run": to.name} | described
    (to / "run.yaml").write_text(yaml.safe_dump(words))
    if samples is not None:
        samples.to_parquet(to / "recording.parquet", index=False)
    return to


def test_bad_and_poor_input_is_named_and_the_good_run_is_written(conceal, cuts, tmp_path) -> None:
    good, _ = conceal()
    samples = pd.read_parquet(good / "recording.parquet")
    few = samples[samples["time_s"] < samples["time_s"].iloc[0] + 15.0]
    noise = np.random.default_rng(0).normal(size=len(samples))
    bad = edited(good, tmp_path / "bad", simulation=[{"id": "crep", "parameters": {}}])
    short = edited(good, tmp_path / "short", few)
    faint = edited(good, tmp_path / "faint", samples.assign(displacement_mm=samples["displacement_mm"] + 9.0 * noise))
    done = command("pipeline.diagnose", bad, short, faint, good, "--out", tmp_path / "out")
    assert done.returncode == 2 and "simulation[0].id" in done.stderr
    assert "short: recording" in done.stderr and "record at least three strokes" in done.stderr
    assert "faint: displacement_mm" in done.stderr and "finer sensor" in done.stderr
    assert re.search(r"moves by [0-9.]+ mm and has a noise of [0-9.]+ mm: nothing", done.stderr)
    assert [path.name for path in (tmp_path / "out").iterdir()] == [good.name]
    done = command("pipeline.diagnose", short, "--out", tmp_path / "noted", "--note-refusals")
    assert done.returncode == 0 and [path.name for path in (tmp_path / "noted" / "short").iterdir()] == ["verdict.txt"]
    assert (tmp_path / "noted" / "short" / "verdict.txt").read_text().startswith("short: not decided: ")


@pytest.mark.long
def test_two_runs_of_one_rig_are_diagnosed_together(diagnosed, tmp_path) -> None:
    folder, _, _, _ = diagnosed
    samples = pd.read_parquet(folder / "recording.parquet")
    resting = samples["motor_turns"] < 0.02 * samples["motor_turns"].max()
    middle = samples.index[resting & (samples.index > 0.55 * len(samples))][0]
    halves = [
        edited(folder, tmp_path / name, half.reset_index(drop=True), string=string_of(folder) | {"id": "spool"})
        for name, half in (("first", samples.loc[:middle]), ("second", samples.loc[middle:]))
    ]
    done = command("pipeline.diagnose", *halves, "--together", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    content = json.loads((tmp_path / "out" / "diagnosis.json").read_text())
    assert content["run"] == ["first", "second"] and {"zero_1_mm", "zero_2_mm"} <= set(content["parameters"])
    assert content["fit"]["heldout"]["runs"] == ["second"]
    assert [entry["id"] for entry in content["mechanisms"]] == ["creep"]


def string_of(folder: Path) -> dict:
    """The string of a run."""
    return yaml.safe_load((folder / "run.yaml").read_text())["string"]


SIMULATION = [
    ([{"id": "creep", "parameters": None}], "simulation[0]"),
    ([{"id": ["creep"], "parameters": {}}], "simulation[0]"),
    (["creep"], "simulation[0]"),
    ({"id": "creep"}, "simulation"),
    ([{"id": "backlash", "parameters": {"half_width_turns": "x"}}], "simulation[0].parameters.half_width_turns"),
    ([{"id": "backlash", "parameters": {"half_width_turns": float("nan")}}], "simulation[0].parameters.half_width"),
    ([{"id": "backlash", "parameters": {}, "bar": 1}], "simulation[0]"),
]


@pytest.mark.parametrize(("entries", "field"), SIMULATION)
def test_what_is_no_simulation_is_refused_with_its_place(problem, entries, field) -> None:
    with pytest.raises(BadInput) as error:
        acts_from(entries, problem.drivers, "raw/a/run.yaml")
    assert error.value.file == "raw/a/run.yaml" and error.value.field.startswith(field)


@pytest.mark.parametrize(
    ("content", "field"),
    [
        ([], "parameters"),
        ({}, "parameters"),
        ({"parameters": {}, "simulation": {}}, "simulation"),
        ({"parameters": {"radius_mm": {"value": None}}, "simulation": []}, "parameters.radius_mm"),
        ({"parameters": {"radius_mm": 3}, "simulation": []}, "parameters.radius_mm"),
    ],
)
def test_what_is_no_diagnosis_is_not_simulated(content, field, problem, tmp_path) -> None:
    path = tmp_path / "diagnosis.json"
    path.write_text(json.dumps(content))
    with pytest.raises(BadInput) as error:
        state_of(read_diagnosis(path), problem, path, "a-01")
    assert error.value.field == field


def test_what_cannot_be_diagnosed_is_named_and_the_rest_is(conceal, tmp_path, monkeypatch) -> None:
    good, _ = conceal()
    mass = edited(good, tmp_path / "mass", actuator="moving_mass")
    other = edited(good, tmp_path / "other", string=string_of(good) | {"radius_mm": 0.7})
    done = command("pipeline.diagnose", mass, good / "run.yaml", "--out", tmp_path / "out")
    assert done.returncode == 2 and "Traceback" not in done.stderr
    done = command("pipeline.diagnose", good, other, "--together", "--out", tmp_path / "out")
    assert done.returncode == 2 and f"{good}: string: is not that of other" in done.stderr
    adopting = edited(good, tmp_path / "adopting", simulation=[{"id": "sensor_drift", "parameters": {"whole_s": 9.0}}])
    with pytest.raises(BadInput, match=f"adopting has adopted effects, {good.name} has not") as refused:
        of_one_rig([RecordedRun(*read_strokes(folder), folder) for folder in (adopting, good)])
    assert refused.value.mend == f"take them out first: python -m pipeline.adopt --remove {adopting}"
    monkeypatch.setattr(diagnose, "decide", lambda *_: 1 / 0)
    outcome = diagnose._one(good, tmp_path / "out", diagnose.Options(), note=True)
    assert outcome.fine is None and "ZeroDivisionError" in outcome.text and not (tmp_path / "out").exists()
    assert command("pipeline.diagnose", good, "--out", tmp_path / "out").returncode == 1  # no bad input


@pytest.fixture
def cuts(monkeypatch) -> list[Motion]:
    """Every motion that is cut into strokes, one entry a cut; processes apart are none, so that all are seen."""
    motions, cut = [], strokes._stretches
    monkeypatch.setattr(strokes, "_stretches", lambda motion: motions.append(motion) or cut(motion))
    monkeypatch.setattr(diagnose, "each_alone", lambda work, items, *rest, **_: [work(item, *rest) for item in items])
    return motions


@pytest.fixture
def strings_runs(conceal, tmp_path) -> list[Path]:
    """Three runs of one string in one folder, the second and third of which begin elsewhere than the one before."""
    good, raw = conceal()[0], tmp_path / "raw"
    table, runs = pd.read_parquet(good / "recording.parquet"), []
    for number, name in enumerate(("a", "b", "c")):
        moved = {"displacement_mm": table["displacement_mm"] + 2.0 * number, "time_s": table["time_s"] + 1e4 * number}
        runs.append(edited(good, raw / name, table.assign(**moved), string=string_of(good) | {"id": "one"}))
    return runs


def test_a_recording_is_cut_into_strokes_once(conceal, cuts, tmp_path) -> None:
    """The door's cut is handed on: to the diagnosis, to what it is scored on, and to the zeros of the string's runs."""
    diagnose.diagnose([conceal()[0]], tmp_path / "out")
    assert len(cuts) == 1


def test_what_ingest_made_gives_the_same_bytes_and_no_recording_is_read(diagnosed, remembered, cuts, tmp_path) -> None:
    """As the main job asks: the recording itself is gone, and what is damaged or was refused is said."""
    folder, _, out, _ = diagnosed
    processed_folder = tmp_path / "processed" / folder.name
    files = ("--out", processed_folder / "samples.parquet", "--out-strokes", processed_folder / "strokes.parquet")
    assert command("pipeline.stages.ingest", folder, *files).returncode == 0
    edited(folder, tmp_path / "raw" / folder.name)
    (tmp_path / "raw" / folder.name / "recording.parquet").unlink()
    arguments = ("pipeline.diagnose", tmp_path / "raw" / folder.name, "--processed", processed_folder.parent, "--out")
    cuts.clear()
    with remembered():
        assert command(*arguments, tmp_path / "out").returncode == 0 and not cuts
    for name in ("diagnosis.json", "simulation.yaml"):
        then, again = ((place / folder.name / name).read_text() for place in (out.parent, tmp_path / "out"))
        assert again.replace(str(tmp_path / "out"), str(out.parent)) == then
    refusal = BadInput(folder, "motor_turns", "there is no stroke in it", "record at least one winding")
    schemas.write_refusal(refusal, processed_folder / "samples.parquet")
    done = command(*arguments, tmp_path / "noted", "--note-refusals")
    assert done.returncode == 0 and [path.name for path in (tmp_path / "noted").iterdir()] == [folder.name]
    assert (tmp_path / "noted" / folder.name / "verdict.txt").read_text() == f"{folder.name}: not decided: {refusal}\n"


def test_runs_of_one_string_are_cut_once_each_and_told_of_each_others_zeros(
    strings_runs, remembered, cuts, tmp_path, monkeypatch
) -> None:
    *run_folders, beside = strings_runs
    verdicts, write_words = [], of_folders.write_words
    monkeypatch.setattr(
        of_folders, "write_words", lambda *arguments: verdicts.append(arguments[3]) or write_words(*arguments)
    )
    with remembered():
        assert command("pipeline.diagnose", *run_folders, "--out", tmp_path / "out").returncode == 0
    assert len(cuts) == 3
    assert verdicts == [
        tmp_path / "out" / run.name for run in run_folders
    ]  # each is written once, with what it is told
    contents = [json.loads((tmp_path / "out" / run.name / "diagnosis.json").read_text()) for run in run_folders]
    (jump,) = contents[1]["zero_jumps"]
    assert "zero_jumps" not in contents[0] and (jump["before"], jump["run"]) == ("a", "b")
    text = " ".join((tmp_path / "out" / "b" / "verdict.txt").read_text().split())
    assert "The zero jumps between two runs of one string: at rest b reads" in text
    cuts.clear()
    with remembered():
        assert command("pipeline.diagnose", run_folders[1], "--out", tmp_path / "alone").returncode == 0
    assert len(cuts) == 3  # its own, and each run's beside it
    assert (tmp_path / "alone" / "b" / "diagnosis.json").read_bytes() == (
        tmp_path / "out" / "b" / "diagnosis.json"
    ).read_bytes()
    assert beside.is_dir()


def test_a_verdict_that_waits_for_others_is_written_also_where_they_die(
    strings_runs, remembered, tmp_path, monkeypatch
) -> None:
    def dies(work, items, *rest, **_):
        yield work(items[0], *rest)
        assert not (tmp_path / "out" / "a" / "verdict.txt").exists()
        raise BrokenProcessPool

    monkeypatch.setattr(diagnose, "each_alone", dies)
    with pytest.raises(BrokenProcessPool), remembered():
        command("pipeline.diagnose", *strings_runs[:2], "--out", tmp_path / "out")
    assert (tmp_path / "out" / "a" / "verdict.txt").read_text().startswith("a: parameters")


def test_adopting_explaining_and_simulating_cut_a_recording_once(diagnosed, cuts, tmp_path) -> None:
    folder, _, place, _ = diagnosed
    run = edited(folder, tmp_path / folder.name)
    for number, words in enumerate((
        ("adopt", place / "diagnosis.json", run),
        ("adopt", "--explain", run),
        ("simulate", run, "--out", tmp_path / "simulated.csv"),
    ), 1):  # fmt: skip
        done = command(f"pipeline.{words[0]}", *words[1:])
        assert done.returncode == 0, done.stderr
        assert len(cuts) == number, words[0]


def test_what_is_imported_beforehand_for_many_runs_is_there() -> None:
    """A name of no module would be passed over without a word, and each run would import all of it again."""
    assert [module for module in diagnose.MODULES if importlib.util.find_spec(module) is None] == []


def test_runs_of_one_string_may_name_it_or_not(conceal, tmp_path) -> None:
    first, _ = conceal()
    later = edited(first, tmp_path / "later", string=string_of(first) | {"id": first.name, "strokes_before": 5})
    thick = edited(first, tmp_path / "thick", string=string_of(first) | {"radius_mm": 0.7})
    first_string, same, other = (described(read_samples(folder)[0], "string") for folder in (first, later, thick))
    assert first_string == same != other


def test_a_coarse_sensor_does_not_stick(conceal) -> None:
    run, samples = read_samples(conceal(rich=False)[0])
    reading_mm = samples["displacement_mm"].to_numpy()
    coarse = samples.assign(displacement_mm=np.round(reading_mm / 0.1) * 0.1)
    assert resolution(coarse["displacement_mm"].to_numpy()) == pytest.approx(0.1, rel=1e-3)
    assert study(make_problem([RecordedRun.cut(run, coarse)])).verdict in ("consistent", "parameters")
