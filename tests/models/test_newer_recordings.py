"""Where `raw/` of a checkout has what its dataset lacks, `predict` and `export` say so, and how it is made anew."""

import json
import os
import shutil
from pathlib import Path

import programs
import pytest
import yaml
from made_recording import content, recording

from pipeline.models.parts.newer_recordings import beware_of_newer

DATASET = "processed/UHMWPE/dataset.parquet"
MAKE = f"To make it anew: snakemake --cores 2 -- {DATASET}\n"


def add_run(root: Path, name: str, **changes: object) -> Path:
    folder = root / "raw" / name
    folder.mkdir(parents=True)
    (folder / "run.yaml").write_text(yaml.safe_dump(content(name, **changes)))
    recording(4).to_csv(folder / "recording.csv", index=False)
    return folder


def make(root: Path, *runs: str) -> None:
    """What the rules `ingest` and `dataset` start."""
    for run in runs:
        files = [f"processed/{run}/{name}" for name in ("samples.parquet", "strokes.parquet", "read_from.json")]
        options = zip(("--out", "--out-strokes", "--out-read-from"), files, strict=True)
        words = [word for option in options for word in option]
        done = programs.run("pipeline.stages.ingest", f"raw/{run}", *words, cwd=root)
        assert done.returncode == 0, done.stderr
    words = ["--processed", "processed", "--out", DATASET, "--out-made-from", "processed/UHMWPE/made_from.json"]
    done = programs.run("pipeline.stages.dataset", *(f"raw/{run}" for run in runs), *words, cwd=root)
    assert done.returncode == 0, done.stderr


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A checkout with two runs and their dataset."""
    for name in ("a-1", "a-2"):
        add_run(tmp_path, name)
    (tmp_path / "Snakefile").touch()
    make(tmp_path, "a-1", "a-2")
    return tmp_path


def beware(root: Path) -> str:
    (line,) = [line for line in predicted(root).stderr.splitlines() if "was made before this" in line] or [""]
    return line


def predicted(root: Path) -> programs.Done:
    (root / "questions.csv").write_text("string,stroke,direction,motor_turns\na-1,2,1,9\n")
    words = [DATASET, "questions.csv", "--out", "answers.csv", "--model", "polynomial"]
    done = programs.run("pipeline.predict", *words, cwd=root)
    assert done.returncode == 0, done.stderr
    return done


def test_what_a_diagnosis_found_and_a_remark_change_no_point(root: Path) -> None:
    """After `adopt` the dataset was said to be older than run.yaml, and to be made anew."""
    description = root / "raw" / "a-1" / "run.yaml"
    simulated = {"simulation": [{"id": "creep", "parameters": {"fresh": 1.0}}]}
    description.write_text(f"# by hand\n{yaml.safe_dump(content('a-1') | simulated)}")
    assert beware(root) == ""
    description.write_text(yaml.safe_dump(content("a-1") | {"tare": "run"}))
    assert "run.yaml of a-1" in beware(root)


def test_a_changed_run_yaml_and_a_run_that_is_not_in_it_are_named_until_it_is_made_anew(root: Path) -> None:
    """`tare: checked` was written, and the answers went on asking for it: the dataset was older, and nobody said so."""
    for path in root.glob("raw/*/*"):
        os.utime(path)
    assert beware(root) == "", "a time alone is no change"
    described = root / "raw/a-2/run.yaml"
    described.write_text(described.read_text() + "tare: checked\n")
    begin = f"beware: {DATASET} was made before this: "
    assert beware(root) == f"{begin}run.yaml of a-2 changed. {MAKE}".rstrip()
    add_run(root, "a-3")
    add_run(root, "other", string={**content("other")["string"], "material": "nylon"})
    (root / "raw/a-4").mkdir()
    shutil.copy(root / "raw/a-3/run.yaml", root / "raw/a-4")  # to be recorded yet
    with open(root / "raw/a-1/recording.csv", "r+b") as file:
        samples = file.read()
        file.seek(samples.rindex(b"20.0"))
        file.write(b"21.0")  # as many bytes
    changed = "run.yaml of a-2 changed, the recording of a-1 changed and a-3 in raw/ is not in it"
    assert beware(root) == f"{begin}{changed}. {MAKE}".rstrip()
    make(root, "a-1", "a-2", "a-3")
    assert beware(root) == ""


def test_an_export_says_it_too(root: Path) -> None:
    folder = root / "processed/UHMWPE/polynomial"
    words = ["--model", "polynomial", "--split", "within", "--out-model", folder / "within-0.model"]
    words += ["--out-predictions", folder / "within-0.predictions.parquet"]
    done = programs.run("pipeline.stages.train", DATASET, *words, cwd=root)
    assert done.returncode == 0, done.stderr
    words = ["processed/UHMWPE/polynomial/within-0.model", "--format", "c", "--out", "tsa.h"]
    assert "was made before this" not in programs.run("pipeline.export.__main__", *words, cwd=root).stderr
    add_run(root, "a-3")
    done = programs.run("pipeline.export.__main__", *words, cwd=root)
    assert f"was made before this: a-3 in raw/ is not in it. {MAKE}" in done.stderr.replace(f"cd {root} && ", "")


def test_a_recording_that_the_main_job_could_not_use_is_not_missed_until_it_changes(root: Path) -> None:
    """It would be in no dataset that is made anew: the line would stay."""
    recorded = add_run(root, "a-3") / "recording.csv"
    assert "a-3 in raw/ is not in it" in beware_of_newer(root / DATASET)
    refusal = [{"run": "a-3", "material": "", "file": "f", "field": "f", "problem": "p", "mend": "m"}]
    facts_file = root / ".snakemake/known_files.json"
    facts_file.parent.mkdir()
    facts_file.write_text(json.dumps({"facts": {}, "notes": {"usable": {"a-3": ["0", "0", json.dumps(refusal)]}}}))
    os.utime(facts_file, (2**31, 2**31))
    assert beware_of_newer(root / DATASET) == ""
    os.utime(recorded, (2**31 + 1, 2**31 + 1))
    assert "a-3 in raw/ is not in it" in beware_of_newer(root / DATASET)


@pytest.mark.parametrize("gone", ["raw", "Snakefile", "processed/UHMWPE/made_from.json"])
def test_nothing_is_said_where_there_is_nothing_to_compare_with(root: Path, gone: str) -> None:
    add_run(root, "a-3")
    assert beware_of_newer(root / DATASET)
    shutil.rmtree(root / gone) if gone == "raw" else (root / gone).unlink()
    assert beware_of_newer(root / DATASET) == ""


def test_outside_of_a_checkout_changed_runs_are_named_with_the_program_that_makes_a_dataset(root: Path) -> None:
    (root / "Snakefile").unlink()
    add_run(root, "a-3")
    described = root / "raw/a-2/run.yaml"
    described.write_text(described.read_text() + "tare: checked\n")
    make_by_hand = "python -m pipeline.dataset raw/a-1 raw/a-2"
    assert (
        beware(root)
        == f"beware: {DATASET} was made before this: run.yaml of a-2 changed. To make it anew: {make_by_hand}"
    )
    done = programs.run("pipeline.dataset", *make_by_hand.split()[3:], cwd=root)
    assert done.returncode == 0 and beware(root) == ""
    described.unlink()
    described.parent.rename(root / "elsewhere")
    assert beware(root) == "", "the run may lie there all the time"


def test_elsewhere_the_command_goes_to_the_checkout_and_what_is_gone_is_named(root: Path) -> None:
    shutil.rmtree(root / "raw/a-2")
    line = beware_of_newer(root / DATASET)
    assert "this: a-2 is gone from raw/. " in line and line.endswith(f": cd {root} && snakemake --cores 2 -- {DATASET}")
