"""Run folders are put together by one command, as the stages do it, and the commands that it prints come next."""

import json
import re
import shlex
import subprocess
from pathlib import Path

import pandas as pd
import programs
import pytest
import yaml
from made_recording import content, recording

from pipeline.models.parts import saved_files

FILES = ("dataset.parquet", "zero_jumps.json", "made_from.json")
SPOOL = {**content("x")["string"], "id": "spool-1"}
NYLON = {**content("x")["string"], "material": "nylon"}
CABLE = {"actuator": "cable_drive", "string": None, "rig": {"gear_ratio": 12}}


def add_run(root: Path, name: str, strokes: int = 4, by_load_n: float = 0.0, **changes: object) -> Path:
    folder = root / "raw" / name
    folder.mkdir(parents=True)
    (folder / "run.yaml").write_text(yaml.safe_dump(content(name, **changes)))
    table = recording(strokes, rate_hz=10.0)
    table.assign(load_n=table["load_n"] + by_load_n).to_csv(folder / "recording.csv", index=False)
    return folder


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A folder with two runs of one string, one of another under another load, and one of another material."""
    add_run(tmp_path, "a-1", string=SPOOL)
    add_run(tmp_path, "a-2", string=SPOOL, tare="run")
    add_run(tmp_path, "b-1", by_load_n=10.0)
    add_run(tmp_path, "n-1", string=NYLON)
    gaps = [{"after_samples": 300}]
    (tmp_path / "raw/a-1/capture.json").write_text(json.dumps({"gaps": gaps, "started_utc": "2026-01-01T00:00:00"}))
    return tmp_path


def ask(root: Path, *words: str) -> programs.Done:
    return programs.run("pipeline.dataset", *words, cwd=root)


def by_stages(root: Path, runs: list[str], *more: str) -> None:
    for run in runs:
        names = {"--out": "samples.parquet", "--out-strokes": "strokes.parquet", "--out-read-from": "read_from.json"}
        words = [word for option, name in names.items() for word in (option, f"stages/{run}/{name}")]
        assert programs.run("pipeline.stages.ingest", f"raw/{run}", *words, cwd=root).returncode == 0
    outs = zip(("--out", "--out-jumps", "--out-made-from"), FILES, strict=True)
    words = [word for option, name in outs for word in (option, f"stages/{name}")]
    runs = [f"raw/{run}" for run in runs]
    done = programs.run("pipeline.stages.dataset", *runs, "--processed", "stages", *words, *more, cwd=root)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("more", [(), ("--keep-lossy",)])
def test_it_is_byte_by_byte_what_the_stages_make(root: Path, more: tuple[str, ...]) -> None:
    runs = ["a-1", "a-2", "b-1"]
    by_stages(root, runs, *more)
    done = ask(root, *(f"raw/{run}" for run in runs), *more)
    assert done.returncode == 0, done.stderr
    assert f"samples are missing in stroke 1: {'kept all the same' if more else 'left out'}\n" in done.stdout
    for name in FILES:
        assert (root / "processed/UHMWPE" / name).read_bytes() == (root / "stages" / name).read_bytes(), name
    assert "a-2" in (root / "processed/UHMWPE/zero_jumps.json").read_text()
    assert sorted(path.name for path in (root / "processed").rglob("*")) == sorted(["UHMWPE", *FILES])


def test_the_commands_that_it_ends_with_lead_to_answers_and_to_a_header(root: Path) -> None:
    done = ask(root, "raw/a-2", "raw/b-1")
    commands = re.findall(r"^(?:Next|  [^:]+|Next: [^:]+): ((?:printf|python) .*)$", done.stdout, re.M)
    write, answer, fit = commands
    subprocess.run(["sh", "-c", write], cwd=root, check=True)
    assert (root / "questions.csv").read_text().startswith("stroke,direction,motor_turns,string,load_n\n")
    done = programs.run(*shlex.split(answer)[2:], cwd=root)
    assert done.returncode == 0, done.stderr
    assert pd.read_csv(root / "answers.csv")["inside"].tolist() == [True]
    done = programs.run(*shlex.split(fit)[2:], cwd=root)
    assert done.returncode == 0, done.stderr
    export, ask_saved = re.findall(r": (python .*)$", done.stdout, re.M)
    done = programs.run("pipeline.export.__main__", *shlex.split(export)[3:], cwd=root)
    assert done.returncode == 0, done.stderr
    assert (root / "reports/UHMWPE/spline/tsa.h").is_file()
    done = programs.run(*shlex.split(ask_saved)[2:], cwd=root)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (
            "raw/a-1 raw/n-1",
            "raw/n-1/run.yaml: string.material: is nylon, and that of raw/a-1 is UHMWPE. Mend: name the runs of one",
        ),
        ("raw", "raw: run.yaml: is missing. Mend: write it with pipeline.new_run|python -m pipeline.new_run"),
        ("raw/a-1 raw/../raw/a-1", "run_dir: is named twice. Mend: name each run once"),
        ("raw/a-1 other/a-1", "other/a-1/run.yaml: run: is a-1, as that of raw/a-1. Mend: name one of them"),
        ("raw/empty", "raw/empty: recording: is missing. Mend: put one of "),
        ("raw/cable", "raw/cable/run.yaml: actuator: is cable_drive: kinematic models are of strings. Mend: name runs"),
        (
            "raw/a-2 --out raw/a-1",
            "--out: raw/a-1: is a run's folder, in which nothing else is put. Mend: name another",
        ),
        ("raw/a-2 --out .", "--out: path: is empty or the current folder itself. Mend: name a folder of the dataset's"),
        ("raw/a-2 --out raw/a-1/run.yaml", "--out: raw/a-1/run.yaml: is a file. Mend: name a folder"),
        ("raw/lossy", "lossy: strokes: samples are missing in every one. Mend: record it again, leave it out, or keep"),
        ("raw/short", "raw/short: within: there are too few points to hold some out and learn from others. Mend: rec"),
        ("raw/a-1 --out home/processed/nylon", "--out: home/processed/nylon: is where a checkout makes its own data"),
    ],
)
def test_what_cannot_be_made_is_refused_with_the_file_and_the_mend_and_leaves_nothing(
    root: Path, words: str, complaint: str
) -> None:
    (root / "other").mkdir()
    add_run(root / "other", "a-1").rename(root / "other/a-1")
    (root / "home").mkdir()
    (root / "home/Snakefile").touch()
    (add_run(root, "empty") / "recording.csv").unlink()
    add_run(root, "cable", **CABLE)
    gaps = [{"after_samples": number} for number in range(4000)]
    (add_run(root, "lossy") / "capture.json").write_text(json.dumps({"gaps": gaps}))
    (root / "raw/short").mkdir()
    (root / "raw/short/run.yaml").write_text(yaml.safe_dump(content("short")))
    recording(1, rate_hz=5.0, speed=18.0).to_csv(root / "raw/short/recording.csv", index=False)
    before = {path: path.read_bytes() for path in root.rglob("*") if path.is_file()}
    done = ask(root, *words.split())
    assert done.returncode == 2 and any(part in done.stderr for part in complaint.split("|")), done.stderr
    assert {path: path.read_bytes() for path in root.rglob("*") if path.is_file()} == before
    assert not (root / "processed").exists() and not (root / "reports").exists()


def test_an_earlier_dataset_is_replaced_and_in_a_checkout_it_lies_where_no_job_writes(root: Path) -> None:
    assert ask(root, "raw/a-2").returncode == 0
    assert ask(root, "raw/a-2", "raw/b-1").returncode == 0
    assert set(pd.read_parquet(root / "processed/UHMWPE/dataset.parquet")["run"]) == {"a-2", "b-1"}
    (root / "Snakefile").touch()
    done = ask(root, "raw/n-1")
    assert done.returncode == 0 and "pipeline.predict reports/mine/nylon/dataset.parquet" in done.stdout
    assert not (root / "processed/nylon").exists()


def test_likely_mistakes_in_a_recording_are_said_as_at_ingest(root: Path) -> None:
    add_run(root, "c-1", by_load_n=-18.0, string={**SPOOL, "radius_mm": 4.0})
    words = ["--out", "samples.parquet"]
    ingested = programs.run("pipeline.stages.ingest", "raw/c-1", *words, cwd=root)
    done = ask(root, "raw/c-1")
    assert ingested.stderr and done.stderr == ingested.stderr


def test_an_installed_package_names_its_commands_and_no_job(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    in_a_checkout = saved_files.listed(()) + saved_files.dataset_mend(Path("d.parquet"))
    assert in_a_checkout.count("the main job makes") == 2
    monkeypatch.setattr(saved_files, "INSTALLED", True)
    words = saved_files.listed(()) + saved_files.dataset_mend(Path("d.parquet"))
    assert "main job" not in words and saved_files.MAKE_DATASET in words and saved_files.fit_command() in words
