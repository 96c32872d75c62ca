"""Adopting a diagnosis: its block goes into run.yaml, all else stays; what was adopted simulates alone, once."""

import json
import os
import re
import shlex
import stat
from pathlib import Path

import pandas as pd
import programs
import pytest
import yaml

from pipeline.diagnosis.adoption.block import adopted, bare, with_block, without_block
from pipeline.diagnosis.document.adopted_run import as_list
from pipeline.diagnosis.fit.adopt import fitted
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.one_rig import described
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.next_run import commands
from pipeline.ground.errors import BadInput
from pipeline.ground.input.strict_yaml import parse_yaml
from pipeline.run.folder import read_run
from pipeline.systems import systems

ROOT = Path(__file__).resolve().parents[2]
LAG = [{"id": "sensor_lag", "parameters": {"late_s": 0.02}}, {"id": "backlash", "parameters": {"width": 1e-07}}]
TEXTS = {
    "at the end": "run: a\nrig: {load_n: 20}  # kept\n# the end\n",
    "no last newline": "run: a\nrig:\n  load_n: 20",
    "empty list": "run: a\nsimulation: []  # none yet\nrig: {load_n: 20}\n",
    "block before others": (
        "# head\nrun: a\nsimulation:\n  - id: creep\n    parameters:\n      tau_s: 31.0\n\n"
        "# of the rig\nrig: {load_n: 20}\n"
    ),
    "unindented block at the end": "run: a\nsimulation:\n- id: creep\n  parameters: {}\n",
    "pasted json": 'run: a\n"simulation": [\n  {"id": "creep", "parameters": {"tau_s": 31.0}}\n ]\nrig: {load_n: 20}\n',
    "all json": '{"run": "a", "rig": {"load_n": 20}}\n',
    "all json with one": '{"run": "a", "simulation": [{"id": "creep"}], "rig": {"load_n": 20}}\n',
    "indented": "  run: a\n  rig: {load_n: 20}\n",
    "windows": "run: a\r\nsimulation: []\r\nrig: {load_n: 20}  # kept\r\n",
}


@pytest.mark.parametrize("name", TEXTS)
def test_the_block_comes_in_and_all_else_stays(name: str) -> None:
    before = TEXTS[name]
    after = with_block(before, LAG)
    where = Path("run.yaml")
    assert parse_yaml(after, where) == {**parse_yaml(before, where), "simulation": LAG}
    for kept in ("# kept", "# the end", "# head", "\n# of the rig\nrig: {load_n: 20}", "# none yet"):
        assert (kept in after) == (kept in before), kept
    assert ("\r" in before) == ("\r" in after) and after.count("\r") in (0, after.count("\n"))
    assert with_block(after, LAG) == after


@pytest.mark.parametrize("name", TEXTS)
def test_what_is_put_in_and_taken_out_again_leaves_the_text_byte_for_byte(name: str) -> None:
    before = without_block(TEXTS[name], "simulation")
    assert "simulation" not in parse_yaml(before, Path("run.yaml")) and without_block(before, "simulation") == before
    both = with_block(with_block(before, LAG), [{"effects": ["sensor_lag"], "tied": []}], "adopted")
    assert without_block(without_block(both, "adopted"), "simulation") == before
    for kept in ("# kept", "# the end", "# head", "\n# of the rig\nrig: {load_n: 20}", "# none yet"):
        assert (kept in before) == (kept in TEXTS[name]), kept


def test_what_cannot_be_taken_out_alone_is_told_so() -> None:
    text = "run: a\nsimulation: &all []\nadopted: []\nchannels: *all\n"
    with pytest.raises(BadInput) as refused:
        bare(text, Path("a/run.yaml"))
    assert refused.value.field == "simulation" and "out by hand" in refused.value.mend


def flat(done: programs.Done) -> str:
    """What a program printed, without the breaks of its lines."""
    return " ".join(done.stdout.split())


@pytest.fixture
def folder(conceal, tmp_path: Path) -> Path:
    """A copy of a run with nothing in it but its dimensions, and a comment in its run.yaml."""
    source, _ = conceal("creep")
    copy = tmp_path / source.name
    copy.mkdir()
    for path in source.iterdir():
        (copy / path.name).write_bytes(path.read_bytes())
    with open(copy / "run.yaml", "a") as file:
        file.write("# measured by hand\n")
    return copy


@pytest.fixture
def diagnosis(folder: Path, tmp_path: Path) -> Path:
    """A diagnosis of the run that names nothing and moves a dimension."""
    path = tmp_path / "diagnosis.json"
    radius_mm = yaml.safe_load((folder / "run.yaml").read_text())["string"]["radius_mm"]
    content = {"run": folder.name, "parameters": {"radius_mm": {"value": 1.02 * radius_mm}}, "simulation": []}
    path.write_text(json.dumps(content))
    return path


def simulated(folder: Path, *words: object) -> pd.Series:
    """What the simulator alone says of a run."""
    out = folder.parent / "simulated.parquet"
    done = programs.run("pipeline.simulate", folder, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return pd.read_parquet(out)["displacement_mm"]


def named(path: Path, **parameters: float) -> Path:
    """A diagnosis that names one effect."""
    content = json.loads(path.read_text())
    content["simulation"] = [{"id": "sensor_drift", "parameters": parameters}] if parameters else []
    path.write_text(json.dumps(content))
    return path


DRIFT = {"whole_s": 200.0, "straight_mm": 0.7}


def test_adopting_changes_run_yaml_alone_and_once(folder: Path, diagnosis: Path) -> None:
    named(diagnosis, **DRIFT)
    before = (folder / "run.yaml").read_text()
    os.chmod(folder / "run.yaml", 0o640)
    done = programs.run("pipeline.adopt", diagnosis, folder)
    assert done.returncode == 0 and "simulation holds sensor_drift now" in flat(done), done.stderr
    after = (folder / "run.yaml").read_text()
    assert yaml.safe_load(after) == {
        **yaml.safe_load(before),
        "simulation": json.loads(diagnosis.read_text())["simulation"],
    }
    assert "\nsimulation:  # numbers of the library's formulas, as a diagnosis found them: not to be edited" in after
    assert "# measured by hand" in after and all(line in after for line in before.splitlines())
    assert stat.S_IMODE((folder / "run.yaml").stat().st_mode) == 0o640
    assert sorted(path.name for path in folder.iterdir()) == ["recording.parquet", "run.yaml"]
    again = programs.run("pipeline.adopt", diagnosis, folder)
    assert again.returncode == 0 and "holds sensor_drift already" in flat(again)
    assert (folder / "run.yaml").read_text() == after
    content = json.loads(diagnosis.read_text())
    diagnosis.write_text(json.dumps({**content, "verdict": "parameters", "mechanisms": [], "adopted": []}))
    printed = flat(programs.run("pipeline.adopt", diagnosis, folder))
    assert "names no further effect: the dimensions that it calibrated are not taken over." in printed


def test_what_was_adopted_simulates_without_being_given_and_counts_once(folder: Path, diagnosis: Path) -> None:
    bare = simulated(folder)
    from_diagnosis = simulated(folder, "--simulation", named(diagnosis, **DRIFT))
    assert programs.run("pipeline.adopt", diagnosis, folder).returncode == 0
    own = simulated(folder)
    assert abs(own - bare).max() > 0.3
    pd.testing.assert_series_equal(simulated(folder, "--simulation", diagnosis), from_diagnosis)
    content = json.loads(diagnosis.read_text())
    diagnosis.write_text(json.dumps({**content, "run": "another-01", "parameters": {}}))
    pd.testing.assert_series_equal(simulated(folder, "--simulation", diagnosis), own)


def test_what_was_adopted_simulates_with_the_dimensions_that_fit_until_one_is_measured_again(folder, diagnosis) -> None:
    content = judged(diagnosis, "ambiguous", TIED)
    right = content["parameters"]["radius_mm"]["value"] / 1.02
    content["parameters"]["radius_mm"]["nominal"] = right
    content["parameters"]["zero_mm"] = {"nominal": 0.0, "value": 0.3}
    diagnosis.write_text(json.dumps(content))
    bare_effects = json.loads(diagnosis.read_text()) | {"parameters": {}, "run": "another-01"}
    other = folder.parent / "effects.json"
    other.write_text(json.dumps(bare_effects))
    effects_alone = simulated(folder, "--simulation", other)
    done = programs.run("pipeline.adopt", diagnosis, folder)
    assert "Adopted with the effects, as they were fitted together" not in flat(done), "it did not say how far it moved"
    dimensions = yaml.safe_load((folder / "run.yaml").read_text())["adopted"][0]["dimensions"]
    assert dimensions["radius_mm"] == {"nominal": right, "fitted": pytest.approx(1.02 * right, rel=1e-5)}
    assert dimensions["zero_mm"] == {"nominal": 0.0, "fitted": 0.3} and len(dimensions) == 2
    own = simulated(folder)
    from_diagnosis = simulated(folder, "--simulation", diagnosis)
    assert abs(own - from_diagnosis).max() < 1e-4, "one simulator, one number"
    assert abs(own - effects_alone).max() > 0.05
    out = folder.parent / "simulated.parquet"
    done = programs.run("pipeline.simulate", folder, "--out", out)
    assert done.stderr == "" and "sensor_drift and the dimensions that fit with them, in" in done.stdout
    text = (folder / "run.yaml").read_text()
    (folder / "run.yaml").write_text(text.replace(f"radius_mm: {right:g}", f"radius_mm: {1.01 * right:g}", 1))
    again = programs.run("pipeline.simulate", folder, "--out", out)
    assert "warning: the radius in run.yaml changed since the effects were adopted." in again.stderr
    assert f"pipeline.adopt --remove {folder}" in again.stderr and "and the dimensions of" in again.stdout


def test_a_run_of_one_stroke_adopts_what_was_named_with_other_runs(folder: Path, diagnosis: Path) -> None:
    """What `settle` proposes is one stroke; its last words sent a person to a refusal: what cannot be told of it."""
    samples = pd.read_parquet(folder / "recording.parquet")
    few = samples[samples["time_s"] < samples["time_s"].iloc[0] + 15.0]
    few.to_parquet(folder / "recording.parquet")
    done = programs.run("pipeline.adopt", named(diagnosis, **DRIFT), folder)
    assert done.returncode == 0 and "simulation holds sensor_drift now" in flat(done), done.stderr
    assert "error of pipeline.simulate" in flat(done)
    explained = programs.run("pipeline.adopt", "--explain", folder)
    assert explained.returncode == 0 and "straight_mm" in explained.stdout, explained.stderr


def test_a_run_that_was_diagnosed_together_adopts_the_zero_of_its_own_motor() -> None:
    zero_entry = {"nominal": 0.0, "value": 0.02}
    parameters = {
        "angle_turns": zero_entry,
        "angle_turns_2": {"nominal": 0.0, "value": 0.3},
        "zero_mm": zero_entry,
        "length_mm": {},
    }
    content = {"run": ["a-01", "a-02"], "parameters": parameters}
    assert fitted(content, "a-01") == {"angle_turns": {"nominal": 0.0, "fitted": 0.02}}
    assert fitted(content, "a-02") == {
        "angle_turns": {"nominal": 0.0, "fitted": pytest.approx(0.32)},
        "angle_turns_2": {"nominal": 0.0, "fitted": 0.3},
    }


def test_what_cannot_be_adopted_leaves_run_yaml_as_it_was(folder: Path, diagnosis: Path) -> None:
    before = (folder / "run.yaml").read_bytes()
    done = programs.run("pipeline.adopt", named(diagnosis), folder)
    assert done.returncode == 0 and "there is nothing to adopt" in done.stdout
    wrong = programs.run("pipeline.adopt", named(diagnosis, whole_s=200.0, crooked_mm=1.0), folder)
    assert (
        wrong.returncode == 2 and "diagnosis.json: simulation[0].parameters.crooked_mm: is not one of" in wrong.stderr
    )
    diagnosis.write_text('{"parameters": {}, "simulation": [3]}')
    assert programs.run("pipeline.adopt", diagnosis, folder).returncode == 2
    assert programs.run("pipeline.adopt", folder / "run.yaml", folder).returncode == 2
    assert (folder / "run.yaml").read_bytes() == before


def test_adopting_says_by_what_the_simulator_errs_before_and_now(folder: Path, diagnosis: Path) -> None:
    """The numbers are those of what `pipeline.simulate` writes."""
    measured = pd.read_parquet(folder / "recording.parquet")["displacement_mm"]

    def errs() -> float:
        return float((measured - simulated(folder)).pow(2).mean() ** 0.5)

    def about_its_median() -> float:
        residual = measured - simulated(folder)
        return float((residual - residual.median()).pow(2).mean() ** 0.5)

    content = judged(diagnosis, "explained", [])
    content["parameters"]["radius_mm"]["nominal"] = content["parameters"]["radius_mm"]["value"] / 1.02
    diagnosis.write_text(json.dumps(content))
    before = [errs(), about_its_median()]
    done = programs.run("pipeline.adopt", diagnosis, folder)
    heads = [line for line in done.stdout.splitlines() if not line.startswith(" ")]
    assert heads == ["What changed", "", "What it means", "", "What comes next"], "it was one block of 30 lines"
    lines = [line.removeprefix("  ") for line in done.stdout.splitlines()]
    place = next(number for number, line in enumerate(lines) if line.startswith("on this recording"))
    head, first, second = lines[place : place + 3]
    assert head.split("   ")[0] == "on this recording, rms of single samples" and head.endswith("now")
    set_, free = ([float(error_mm) for error_mm in re.findall(r"([0-9.]+) mm", row)] for row in (first, second))
    assert set_ == pytest.approx([before[0], errs()], rel=0.05) and first.startswith("error of pipeline.simulate ")
    assert free == pytest.approx([before[1], about_its_median()], rel=0.05) and second.startswith(
        "the same, if the whole recording sets the zero "
    )
    assert f"  python -m pipeline.adopt --explain {folder}" in lines
    means = programs.run("pipeline.adopt", "--explain", folder).stdout
    assert means.startswith("What each number under simulation means, if you are curious")
    assert f"    Its formula: {mechanisms()['sensor_drift'].equation}" in means
    assert re.search(r"straight_mm +-?[0-9.]+ mm +[0-9.]+ mm .*\n      adds to the reading\n", means)


def test_a_diagnosis_of_other_dimensions_than_run_yaml_has_now_is_not_adopted(folder: Path, diagnosis: Path) -> None:
    content = judged(diagnosis, "explained", [])
    content["parameters"]["radius_mm"]["nominal"] = content["parameters"]["radius_mm"]["value"] / 1.02
    diagnosis.write_text(json.dumps(content | {"evidence": {}}))
    text = (folder / "run.yaml").read_text()
    right = yaml.safe_load(text)["string"]["radius_mm"]
    measured_again = text.replace(f"radius_mm: {right:g}", f"radius_mm: {1.01 * right:.5g}", 1)
    scaled = text + "channels: {displacement_mm: {scale: 1.01}}\n"
    for now, says in (
        (measured_again, f"a radius of {right:g} mm, and run.yaml says {1.01 * right:.5g}"),
        (scaled, "a scale of 1, and run.yaml says 1.01"),
    ):
        (folder / "run.yaml").write_text(now)
        done = programs.run("pipeline.adopt", diagnosis, folder)
        assert done.returncode == 2 and says in done.stderr and "diagnose the run again" in done.stderr, done.stderr
        assert (folder / "run.yaml").read_text() == now
    (folder / "run.yaml").write_text(text)
    assert programs.run("pipeline.adopt", diagnosis, folder).returncode == 0


def test_adopting_names_the_dimensions_that_fit_and_those_to_measure_again(folder: Path, diagnosis: Path) -> None:
    content = judged(diagnosis, "explained", [])
    run = read_run(folder)
    assert run.string is not None
    radius, separator, length = run.string.radius_mm, run.rig["separator_mm"], run.string.length_mm
    values = {
        "radius_mm": (radius, radius + 0.011),
        "scale": (1.0, 1.001),
        "separator_mm": (separator, separator + 1.4),
        "length_mm": (length, length),
    }
    content["parameters"] = {name: {"nominal": nominal, "value": other} for name, (nominal, other) in values.items()}
    moved = {"radius_mm": -1.9, "scale": 0.4, "separator_mm": 2.9, "length_mm": "far"}
    diagnosis.write_text(json.dumps({**content, "evidence": {"moved_sigma": moved}}))
    printed = flat(programs.run("pipeline.adopt", diagnosis, folder))
    dimensions = (
        f"separator {separator:g} → {separator + 1.4:.4g} mm; radius {radius:g} → {radius + 0.011:.4g} mm; "
        "gain of the displacement sensor 1 (assumed) → 1.001."
    )
    assert f"Adopted with the effects, as they were fitted together: {dimensions}" in printed
    assert (
        "The values that you gave in run.yaml stay. Change one of them, and the fitted ones count no more." in printed
    )
    assert "Measure the separator again: calibration moved it by more than 2 tolerances." in printed


def test_adopting_against_the_verdict_s_advice_is_refused_until_a_person_is_sure(folder: Path, diagnosis: Path) -> None:
    """A verdict said "Do not adopt before the separator is measured again", and adopting it went on all the same."""
    content = judged(diagnosis, "explained", [])
    fit = {"heldout": {}, "noise_floor_mm": 0.01}
    for sigma, says in ((2.9, True), (1.9, False)):
        evidence = {"moved_sigma": {"separator_mm": sigma}, "strokes_left_out": []}
        diagnosis.write_text(json.dumps({**content, "fit": fit, "evidence": evidence}))
        refused = programs.run("pipeline.adopt", diagnosis, folder)
        assert refused.returncode == (2 if says else 0) and bool(read_run(folder).simulation) != says, refused.stdout
        advice = "verdict: advises against adopting it: Do not adopt before the separator is measured again. Mend: "
        assert (advice in refused.stderr and "add --sure" in refused.stderr) == says
        programs.run("pipeline.adopt", "--remove", folder)
        done = programs.run("pipeline.adopt", diagnosis, folder, "--sure")
        printed = flat(done)
        assert done.returncode == 0 and read_run(folder).simulation, done.stderr
        against = "Adopted against the verdict's advice. The verdict says: Do not adopt before the"
        assert done.stdout.startswith(against) == says, printed
        assert printed.count(f"python -m pipeline.adopt --remove {folder}") == 1
        assert programs.run("pipeline.adopt", "--remove", folder).returncode == 0


def test_what_was_adopted_is_taken_out_again_and_run_yaml_is_what_it_was(folder: Path, diagnosis: Path) -> None:
    before = (folder / "run.yaml").read_bytes()
    os.chmod(folder / "run.yaml", 0o640)
    judged(diagnosis, "ambiguous", TIED, next_experiment=NEXT)
    done = programs.run("pipeline.adopt", diagnosis, folder)
    *_, before_last, last = done.stdout.splitlines()
    assert before_last.strip() == "To take all of it out of run.yaml again:"
    assert "not weighed again" in done.stdout, "before the command that takes it out"
    assert last == f"    python -m pipeline.adopt --remove {folder}"
    assert (folder / "run.yaml").read_bytes() != before
    done = programs.run(*last.split()[-3:])
    assert done.returncode == 0 and "are taken out (they held sensor_drift)" in done.stdout, done.stderr
    assert (folder / "run.yaml").read_bytes() == before
    assert stat.S_IMODE((folder / "run.yaml").stat().st_mode) == 0o640
    assert sorted(path.name for path in folder.iterdir()) == ["recording.parquet", "run.yaml"]
    again = programs.run("pipeline.adopt", "--remove", folder)
    assert again.returncode == 0 and "holds nothing that was adopted" in again.stdout
    assert programs.run("pipeline.adopt", "--remove", folder, diagnosis).returncode == 2
    assert programs.run("pipeline.adopt", diagnosis).returncode == 2
    usage = programs.run("pipeline.adopt", "--help").stdout
    assert usage.startswith(
        "usage: python -m pipeline.adopt DIAGNOSIS.json RUN_DIR [--sure]\n       python -m pipeline.adopt --remove"
    )
    columns = " ".join(programs.run("pipeline.simulate", "--help").stdout.split())
    assert columns.startswith("usage: python -m pipeline.simulate ") and "time_s, and what the rig reads" in columns


def test_simulating_prints_the_error_against_the_recording(folder: Path) -> None:
    out = folder.parent / "simulated.parquet"
    done = programs.run("pipeline.simulate", folder, "--out", out)
    error = pd.read_parquet(folder / "recording.parquet")["displacement_mm"] - pd.read_parquet(out)["displacement_mm"]
    match = re.search(r"rms error against the recording, its zero set in the first second: ([0-9.]+) mm\n", done.stdout)
    assert match and float(match[1]) == pytest.approx(float(error.pow(2).mean() ** 0.5), rel=0.05), done.stdout


NEXT = "One stroke under twice the load: 28 s in all."
TIED = [["creep"], ["thermal", "wear"]]


def judged(path: Path, verdict: str, tied: list, **more: object) -> dict:
    """A diagnosis that names a drift, with its verdict and what tied with it."""
    content = json.loads(named(path, **DRIFT).read_text())
    content |= {"verdict": verdict, "mechanisms": [{"id": "sensor_drift"}], "alternatives": tied, **more}
    path.write_text(json.dumps(content))
    return content


@pytest.mark.long
def test_run_yaml_holds_which_other_sets_tied_and_the_next_verdict_says_so(folder: Path, diagnosis: Path) -> None:
    judged(diagnosis, "ambiguous", TIED, next_experiment=NEXT)
    done = programs.run("pipeline.adopt", diagnosis, folder)
    assert (
        done.returncode == 0
        and "2 other explanations were likely too: creep or thermal + wear. Adopted is " in flat(done)
    )
    first = {"effects": ["sensor_drift"], "verdict": "ambiguous", "tied": TIED, "runs": [folder.name]}
    first |= {"diagnosis": str(diagnosis), "next_experiment": [NEXT]}
    text = (folder / "run.yaml").read_text()
    assert yaml.safe_load(text)["adopted"] == [first] and "# measured by hand" in text
    assert "holds sensor_drift already" in flat(programs.run("pipeline.adopt", diagnosis, folder))
    beware = "beware: sensor_drift is one of 3 likely explanations, and another may say otherwise here"
    assert beware in flat(programs.run("pipeline.simulate", folder, "--out", folder.parent / "it.csv"))
    out = folder.parent / "out"
    done = programs.run("pipeline.diagnose", folder, "--out", out)
    assert done.returncode == 0, done.stderr
    content = json.loads((out / folder.name / "diagnosis.json").read_text())
    assert content["adopted"] == [first]
    verdict_words = " ".join((out / folder.name / "verdict.txt").read_text().split())
    assert (
        "Instead of what was adopted (sensor_drift) this may be right, for it was likely as well: creep or thermal + w"
        in verdict_words
    )
    pasted = out / folder.name / "simulation.yaml"
    assert content["verdict"] == "ambiguous" and pasted.is_file()
    own = {"effects": [entry["id"] for entry in content["mechanisms"]], "verdict": content["verdict"]}
    own |= {"tied": content["alternatives"], "runs": [folder.name]}
    own |= {"diagnosis": str(out / folder.name / "diagnosis.json"), "dimensions": fitted(content, folder.name)}
    assert own["dimensions"]["radius_mm"]["nominal"] == content["parameters"]["radius_mm"]["nominal"]
    experiment = content["next_experiment"]
    useless = "Hardly worth making" in (experiment or "")
    none = ["Hardly worth making: no run that was tried decides"]
    own |= {"next_experiment": none if useless else as_list(experiment)} if experiment else {}
    assert "last 30 % of strokes (seen before)" in verdict_words and "unseen" not in verdict_words
    assert yaml.safe_load(pasted.read_text()) == {"simulation": content["simulation"], "adopted": [first, own]}
    assert programs.run("pipeline.adopt", out / folder.name / "diagnosis.json", folder).returncode == 0
    assert yaml.safe_load((folder / "run.yaml").read_text())["adopted"] == [first, own]
    named(diagnosis, **DRIFT)
    content = json.loads(diagnosis.read_text())
    del content["verdict"]
    diagnosis.write_text(json.dumps(content))
    assert programs.run("pipeline.adopt", diagnosis, folder).returncode == 0  # nobody knows what tied with this one
    assert yaml.safe_load((folder / "run.yaml").read_text())["adopted"] == []


@pytest.mark.parametrize("tied", [3, [3], [["nothing_known"]], [[["creep"]]]])
def test_ties_that_are_none_are_refused(folder: Path, diagnosis: Path, tied: object) -> None:
    before = (folder / "run.yaml").read_bytes()
    judged(diagnosis, "ambiguous", tied)  # type: ignore[arg-type]
    done = programs.run("pipeline.adopt", diagnosis, folder)
    assert done.returncode == 2 and "diagnosis.json: mechanisms, alternatives: holds" in done.stderr, done.stderr
    assert (folder / "run.yaml").read_bytes() == before


def test_a_block_that_cannot_be_replaced_is_told_so() -> None:
    text = "run: a\nrig: &all {load_n: 20}\nsimulation: *all\n"
    with pytest.raises(BadInput) as refused:
        adopted(text, LAG, Path("a/run.yaml"))
    assert refused.value.field == "simulation" and "by hand" in refused.value.mend


def test_another_runs_diagnosis_is_adopted_with_a_warning_unless_it_makes_things_worse(folder, diagnosis) -> None:
    content, before = json.loads(named(diagnosis, **DRIFT).read_text()), (folder / "run.yaml").read_bytes()
    other = {**content, "run": ["other-01", "other-02"]}
    diagnosis.write_text(json.dumps(other))
    worse = programs.run("pipeline.adopt", diagnosis, folder)
    assert worse.returncode == 2 and (folder / "run.yaml").read_bytes() == before
    assert "run: is of another run, and would make the simulator of this one worse: " in worse.stderr
    other["simulation"][0]["parameters"]["straight_mm"] = 1e-3
    diagnosis.write_text(json.dumps(other))
    done = programs.run("pipeline.adopt", diagnosis, folder)
    assert done.returncode == 0 and "beware: " in done.stderr and "the same string on the same rig" in done.stderr


def test_the_printed_line_makes_a_run_that_can_be_diagnosed_together_with_the_old_one(folder: Path) -> None:
    new_run_command, diagnose = commands.lines([folder], folder.parent / "out", ["35"])
    new, log = folder.with_name(f"{folder.name}-next"), folder / "recording.parquet"
    assert new_run_command.endswith(" --recording FILE.csv"), (
        "what every logger writes, though the old one came as parquet"
    )
    assert commands.remark(folder, Vocabulary.of(systems()["separator"])) == (
        "FILE.csv is the new file of your logger, with the columns time_s, motor_turns, displacement_mm and load_n."
    )
    own = (folder / "run.yaml").read_text()
    named = "channels: {time_s: {column: ms, unit: ms}, motor_turns: {column: 1}, load_n: newton}\n"
    (folder / "run.yaml").write_text(own + named)
    assert commands.remark(folder, Vocabulary.of(systems()["separator"])) == (
        "FILE.csv is the new file of your logger, with the columns ms, column 1, displacement_mm and newton."
    ), "the names of its run.yaml: --like takes them over"
    content = yaml.safe_load(own)
    (folder / "run.yaml").write_text(yaml.safe_dump(content | {"rig": content["rig"] | {"load_n": 40.0}}))
    assert commands.remark(folder, Vocabulary.of(systems()["separator"])).endswith(
        "and displacement_mm. It names no load: new_run takes 40 N. For each other load record a run of its own, "
        "with --load-n N."
    ), "strokes under 20 N were read as under 40"
    (folder / "run.yaml").write_text(own)
    done = programs.run(*shlex.split(new_run_command)[2:-1], log)
    assert done.returncode == 0, done.stderr
    old, fresh = read_run(folder), read_run(new)
    assert fresh.rig == old.rig | {"load_n": 35.0} and fresh.string_id == old.string_id and not fresh.simulation
    shared = ("rig", "string", "tolerance", "simulation")
    assert all(described(old, field) == described(fresh, field) for field in shared)
    both = [str(folder), str(new), "--together", "--out", str(folder.parent / "out-next")]
    assert shlex.split(diagnose)[2:] == ["pipeline.diagnose", *both]


def test_adopting_says_what_unseen_strokes_are_missed_by_and_repeats_a_warning(folder: Path, diagnosis: Path) -> None:
    content = judged(diagnosis, "explained", [])
    heldout = {"calibrated_mm": 0.4, "explained_mm": 0.034}
    diagnosis.write_text(json.dumps(content | {"fit": {"heldout": heldout}}))
    printed = flat(programs.run("pipeline.adopt", diagnosis, folder))
    assert "On unseen ones the verdict says 0.034 mm, and 0.40 mm without the effects." in printed
    assert "adopt nothing" not in printed
    programs.run("pipeline.adopt", "--remove", folder)
    evidence = {**content.get("evidence", {}), "chosen_without_them": ["wear"]}
    diagnosis.write_text(json.dumps(content | {"fit": {"heldout": heldout}, "evidence": evidence}))
    printed = flat(programs.run("pipeline.adopt", diagnosis, folder))
    assert "says 0.034 mm (of wear, which the procedure names without these strokes), and 0.40 mm without" in printed
    programs.run("pipeline.adopt", "--remove", folder)
    diagnosis.write_text(json.dumps(content | {"fit": {"heldout": heldout | {"explained_mm": 4.3}}}))
    assert "So the verdict says: adopt nothing." in flat(programs.run("pipeline.adopt", diagnosis, folder))
    programs.run("pipeline.adopt", "--remove", folder)
    diagnosis.write_text(json.dumps(content | {"fit": {"heldout": {"calibrated_mm": "x"}}}))
    assert "On unseen ones" not in flat(programs.run("pipeline.adopt", diagnosis, folder))
