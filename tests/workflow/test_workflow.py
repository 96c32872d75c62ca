"""The whole workflow on the small rig: what it makes, and what it makes again."""

import csv
import json
import os
import shutil
from pathlib import Path

import pytest
import yaml
from added_runs import LATE, OF_A_MATERIAL, add_run
from made_recording import recording

# The main job, which is the README's other command, run and run again: in pytest -m long.
pytestmark = pytest.mark.long
ROOT = Path(__file__).parents[2]


def test_the_main_job_makes_everything_and_prints_the_tables(finished):
    project, printed = finished
    reports = project.folder / "reports"
    names = [f"table_{n}.{suffix}" for n in (1, 2) for suffix in ("csv", "csv-metadata.json", "md", "tex")]
    names += [f"figure_{n}.{suffix}" for n in (4, 5) for suffix in ("png", "pdf")] + [
        "comparison.md",
        "comparison.html",
    ]
    names += ["models.md", "models.html", "models.csv", "models.csv-metadata.json"]
    names += ["figure_leak.png", "figure_leak.pdf"]
    assert all((reports / "synthetic" / name).stat().st_size > 0 for name in names)
    assert "TABLE I: FORWARD" in printed and "TABLE II: INVERSE" in printed
    assert "tables, figures, every model and how to ask it: reports/synthetic/index.html" in printed
    with open(reports / "synthetic" / "table_1.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))[1:]
    titles, models = [row[0] for row in rows[::3]], yaml.safe_load((ROOT / "pipeline/config/default.yaml").read_text())
    assert titles[0] == "INN model" and titles[-1] == "Traditional model"
    assert titles == [model["title"] for model in models["models"].values()]
    assert all(row[2] for row in rows if row[1] in ("n=1", "n=5")) and not any(
        row[2] for row in rows if row[1] == "n=9"
    )
    header, *lines = (reports / "metrics.csv").read_text().splitlines()
    assert header == "material,model,split,map,stroke,phase,angle_band,seed,metric,unit,value"
    assert {line.split(",")[1] for line in lines} >= {"inn", "traditional", "floor", "floor_blind"}
    words = (reports / "synthetic" / "models.md").read_text()
    assert "- Least error forward, within strokes: " in words and "- The INN model (" in words
    index = (reports / "index.html").read_text()
    assert "synthetic/models.html" in index and "synthetic/figure_leak.png" in index
    assert index.index("At a glance") < index.index("<details") < index.index("Table I: forward")
    content = json.loads((reports / "diagnosis" / "synthetic-01" / "diagnosis.json").read_text())
    verdict, harms = content["verdict"], "explained" in content["fit"].get("worse_than_nominal", [])
    assert "synthetic-01: " in printed and content["mechanisms"][0]["id"] in printed
    doubted = ", but worse on unseen strokes: do not adopt</span>" in index or ", but not settled</span>" in index
    assert doubted or not harms
    assert f'<span class="verdict {"doubted" if doubted else verdict}">' in index
    assert (
        "diagnosis/synthetic-01/diagnosis.png" in index and (reports / "diagnosis/synthetic-01/diagnosis.png").is_file()
    )


def test_what_ci_makes_cannot_be_taken_for_a_result(finished):
    project, printed = finished
    reports = project.folder / "reports"
    assert "(small fit: not a result, made by ci.yaml" in printed
    pages = [reports / "index.html", *(reports / "synthetic").glob("*.html"), *(reports / "synthetic").glob("*.md")]
    pages += [reports / "synthetic" / f"table_{n}.tex" for n in (1, 2)]
    for path in (*pages, *reports.rglob("*.csv-metadata.json")):
        assert "Small fit, not a result: made by ci.yaml" in path.read_text(), path
    tables = {path.name for path in reports.rglob("*.csv") if "diagnosis" not in path.parts}
    assert tables == {path.name.removesuffix("-metadata.json") for path in reports.rglob("*.csv-metadata.json")}
    for path in (reports / "synthetic").glob("figure_*.png"):
        assert b"Small fit, not a result: made by ci.yaml" in path.read_bytes(), path


def test_a_second_run_has_nothing_to_do(finished):
    done = finished[0].snakemake()
    assert done.returncode == 0 and "Nothing to be done" in done.stdout + done.stderr


def test_the_tables_alone(tmp_path, finished):
    project = finished[0]
    assert project.rules_to_run("tables") == {}
    shutil.rmtree(tmp_path / "project", ignore_errors=True)
    shutil.copytree(project.folder, tmp_path / "project", symlinks=True)
    other = type(project)(tmp_path / "project")
    shutil.rmtree(other.folder / "reports")
    done = other.snakemake("tables")
    assert done.returncode == 0 and "TABLE I: FORWARD" in done.stdout
    assert other.rules_of(done.stderr) == {"table": 1}
    again = other.snakemake("tables")
    assert again.returncode == 0 and other.rules_of(again.stderr) == {}
    assert again.stdout == done.stdout, "it said only that nothing was to be done"
    forms = {n: [f"reports/synthetic/table_{n}.{suffix}" for suffix in ("csv", "md", "tex")] for n in (1, 2)}
    last = [f"Table {'I' * n}: {', '.join(paths)}" for n, paths in forms.items()]
    assert "\n".join(last) in done.stdout and all(
        (other.folder / path).is_file() for paths in forms.values() for path in paths
    )
    for page in ("index.html", "comparison", "models.", "figure_", "what the simulator leaves out"):
        assert page not in done.stdout, page
    assert other.read("reports/synthetic/table_2.tex") == project.read("reports/synthetic/table_2.tex")
    assert not (other.folder / "reports" / "index.html").exists()


@pytest.mark.parametrize(
    ("module", "rules"),
    [
        ("pipeline/report/tables.py", {"table": 1, "material_page": 1, "index": 1, "left_out": 1}),
        ("pipeline/models/mlp.py", {"train": 2, **LATE}),
        ("pipeline/import_run.py", {}),
        (
            "pipeline/rig/setups/small.yaml",
            {"record": 1, "ingest": 1, "dataset": 1, "floor": 1, "train": 17, "train_leak": 3, "leak": 1}
            | {"diagnose": 1, "croissant": 1, **LATE},
        ),
        # the diagnosed simulator is a model, which is trained again as well
        (
            "pipeline/diagnosis/fit/locate.py",
            {"diagnose": 1, "train": 2, **LATE},
        ),
    ],
)
def test_a_change_of_code_makes_again_what_it_made(project, module, rules):
    path = project.folder / module
    path.write_text(path.read_text() + ("\nCHANGED = True\n" if path.suffix == ".py" else "# changed\n"))
    assert project.rules_to_run() == rules


def test_a_new_material_asks_for_a_fit_of_every_model_and_of_nothing_else(project):
    add_run(project, "nylon-01", "nylon")
    assert project.rules_to_run() == {"train": 17, **OF_A_MATERIAL}


def test_a_recording_goes_stale_by_its_content_and_not_by_its_time(project):
    folder, target = add_run(project, "wool-01", "wool"), "processed/wool-01/samples.parquet"
    assert project.snakemake(target).returncode == 0
    for path in folder.iterdir():
        os.utime(path)
    assert project.rules_to_run(target) == {}
    description, recorded = folder / "run.yaml", folder / "recording.parquet"
    text, times = description.read_text(), description.stat()
    description.write_text(text.replace("length_mm: 400", "length_mm: 401"))
    os.utime(description, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert project.rules_to_run(target) == {"ingest": 1}
    description.write_text(text)
    assert project.rules_to_run(target) == {}
    older = folder.parent / "older.parquet"
    recording(3).to_parquet(older, index=False)
    os.utime(older, (10**9, 10**9))
    os.replace(older, recorded)
    assert project.rules_to_run(target) == {"ingest": 1}
    (project.folder / "raw/synthetic-01/run.yaml").write_text("run: synthetic-01\n")
    assert project.rules_to_run("raw/synthetic-01/run.yaml", "processed/synthetic-01/samples.parquet") == {
        "record": 1, "ingest": 1,
    }  # fmt: skip
