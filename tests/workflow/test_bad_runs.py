"""A run that cannot be used costs itself alone, with no flag: two models, no synthetic rig, the real main job."""

import shutil

import pytest
import yaml
from added_runs import add_run
from made_recording import recording

GOOD = "run: {}\nstring: {{material: nylon, radius_mm: {}, length_mm: 400, stiffness_n_per_mm: 15}}\n"
RIG = "rig: {torsion_zone_mm: 150, separator_mm: 8}\n"


@pytest.fixture(scope="module")
def project(bare_project):
    """A project with one good run, whose tables are made."""
    path = bare_project.folder / "pipeline" / "config" / "default.yaml"
    config = yaml.safe_load(path.read_text())
    config["models"] = {
        model: model_settings for model, model_settings in config["models"].items() if model in ("inn", "traditional")
    }
    config["models"]["inn"]["settings"] = {"blocks": 3, "width": 8, "layers": 1, "epochs": 1}
    for model_settings in config["models"].values():
        model_settings["seeds"] = {"within": 1, "later": 1}
    config["synthetic"] = {}
    path.write_text(yaml.safe_dump(config, sort_keys=False))
    (path.parent / "ci.yaml").write_text("{}\n")
    add_run(bare_project, "good-01", "nylon")
    done = bare_project.snakemake("tables")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "left out" not in done.stdout
    return bare_project


@pytest.mark.long
def test_it_trains_nothing_anew_comes_or_goes_and_is_said_everywhere(project):
    before = {path: path.stat().st_mtime_ns for path in (project.folder / "processed").rglob("*.model")}
    table = project.read("reports/nylon/table_1.csv")
    assert len(before) == 4
    add_run(project, "nan-01", "nylon", text=GOOD.format("nan-01", ".nan") + RIG)
    add_run(project, "column-01", "nylon", samples=recording(4).drop(columns="displacement_mm"))
    add_run(project, "alone-01", "silk", samples=recording(4).assign(displacement_mm=1.0))

    done = project.snakemake("tables")
    assert done.returncode == 0, done.stdout + done.stderr
    assert project.rules_of(done.stderr) == {"table": 1}
    last = done.stdout.rstrip().splitlines()[-4:]
    assert last[0].startswith("All else that was asked for is made.")
    assert sorted(line.split("/")[1] for line in last[1:]) == ["alone-01", "column-01", "nan-01"]
    (of_column,) = [line for line in last if "column-01" in line]
    assert "raw/column-01/recording.parquet" in of_column or "raw/column-01/run.yaml" in of_column
    page = project.read("reports/nylon/table_1.md")
    assert "Left out: run nan-01: raw/nan-01/run.yaml: line 2: radius_mm: .nan is no finite number" in page
    assert "Left out: run column-01: " in page and "alone-01" not in page
    assert project.read("reports/nylon/table_1.csv") == table

    for name in ("nan-01", "column-01", "alone-01"):
        shutil.rmtree(project.folder / "raw" / name)
    done = project.snakemake("tables")
    assert project.rules_of(done.stderr) == {"table": 1}
    assert done.returncode == 0 and "left out" not in done.stdout + done.stderr
    assert "Left out" not in project.read("reports/nylon/table_1.md")
    assert {path: path.stat().st_mtime_ns for path in before} == before
