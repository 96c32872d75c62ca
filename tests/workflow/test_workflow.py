"""The whole workflow on the small rig: what it makes, and what it makes again."""

import csv
import hashlib
import json
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest
import yaml
from made_recording import recording
from markupsafe import escape

# The main job, which is the README's other command, run and run again: in pytest -m long.
pytestmark = pytest.mark.long
ROOT = Path(__file__).parents[2]


def add_run(project, name, material, samples=None, text=None):
    folder = project.folder / "raw" / name
    folder.mkdir(parents=True)
    string = f"{{material: {material}, radius_mm: 0.4, length_mm: 400, stiffness_n_per_mm: 15}}"
    good = f"run: {name}\nstring: {string}\nrig: {{torsion_zone_mm: 150, separator_mm: 8}}\n"
    (folder / "run.yaml").write_text(good if text is None else text)
    (recording(4) if samples is None else samples).to_parquet(folder / "recording.parquet", index=False)
    return folder


def digest(folder):
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


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
    assert "TABLE I: FORWARD" in printed and "TABLE II: INVERSE" in printed and "figure_4.png" in printed
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
    verdict = json.loads((reports / "diagnosis" / "synthetic-01" / "diagnosis.json").read_text())["verdict"]
    assert f"synthetic-01: {verdict}" in printed and f'<span class="verdict {verdict}">' in index
    assert (
        "diagnosis/synthetic-01/diagnosis.png" in index and (reports / "diagnosis/synthetic-01/diagnosis.png").is_file()
    )


def test_what_ci_makes_cannot_be_taken_for_a_result(finished):
    project, printed = finished
    reports = project.folder / "reports"
    assert "(small fit: not a result, ci.yaml" in printed
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
    assert other.rules_to_run("tables") == {"table": 1}
    done = other.snakemake("tables")
    assert done.returncode == 0 and "TABLE I: FORWARD" in done.stdout
    forms = {n: [f"reports/synthetic/table_{n}.{suffix}" for suffix in ("csv", "md", "tex")] for n in (1, 2)}
    last = [f"Table {'I' * n}: {', '.join(paths)}" for n, paths in forms.items()]
    assert "\n".join(last) in done.stdout and all(
        (other.folder / path).is_file() for paths in forms.values() for path in paths
    )
    for page in ("index.html", "comparison", "models.", "figure_", "what the simulator leaves out"):
        assert page not in done.stdout, page
    assert other.read("reports/synthetic/table_2.tex") == project.read("reports/synthetic/table_2.tex")
    assert not (other.folder / "reports" / "index.html").exists()


LATE = dict.fromkeys(
    ("evaluate", "table", "comparison", "models", "figures", "leak_figure", "metrics", "index", "left_out"), 1
)


@pytest.mark.parametrize(
    ("module", "rules"),
    [
        ("pipeline/report/tables.py", {"table": 1, "index": 1, "left_out": 1}),
        ("pipeline/models/mlp.py", {"train": 2, **LATE}),
        ("pipeline/import_run.py", {}),
        (
            "pipeline/rig/setups/small.yaml",
            {"record": 1, "ingest": 1, "dataset": 1, "floor": 1, "train": 17, "train_leak": 3, "leak": 1}
            | {"diagnose": 1, "croissant": 1, **LATE},
        ),
        # the diagnosed simulator is a model, which is trained again as well
        (
            "pipeline/diagnosis/locate.py",
            {"diagnose": 1, "train": 2, **LATE},
        ),
    ],
)
def test_a_change_of_code_makes_again_what_it_made(project, module, rules):
    path = project.folder / module
    path.write_text(path.read_text() + ("\nCHANGED = True\n" if path.suffix == ".py" else "# changed\n"))
    assert project.rules_to_run() == rules


OF_A_MATERIAL = {"ingest": 1, "dataset": 1, "floor": 1, "diagnose": 1, "croissant": 1}
OF_A_MATERIAL |= {rule: 1 for rule in LATE if rule != "leak_figure"}


def test_a_new_material_asks_for_a_fit_of_every_model_and_of_nothing_else(project):
    add_run(project, "nylon-01", "nylon")
    assert project.rules_to_run() == {"train": 17, **OF_A_MATERIAL}


def test_a_new_material_runs_its_own_jobs_only_and_raw_is_never_touched(few):
    project = few
    add_run(project, "nylon-01", "nylon")
    before = digest(project.folder / "raw")
    assert project.rules_to_run() == {"train": 4, **OF_A_MATERIAL}
    done = project.snakemake()
    assert done.returncode == 0, done.stdout + done.stderr
    assert digest(project.folder / "raw") == before
    assert "== nylon" in done.stdout and "n=1" in project.read("reports/nylon/table_1.md")
    materials = {line.split(",")[0] for line in project.read("reports/metrics.csv").splitlines()[1:]}
    assert materials == {"synthetic", "nylon"}
    # A second run of the same material: its dataset and what stands on it, and nothing of the others.
    add_run(project, "nylon-02", "nylon")
    assert project.rules_to_run() == {"train": 4, **OF_A_MATERIAL}


HOSTILE = ("$(touch PWNED)", "nylon-1 (copy)", "it's", "a{b}c", "two\nlines", "-rf")
STILL = recording(4).assign(displacement_mm=1.0)
BAD = {
    "deep-01": {"material": "nylon", "text": "a: " + "[" * 3000},
    "typo-01": {"material": "x", "text": "run: typo-01\nstring: {material: nylon, raduis_mm: 1}\n"},
    "taken-01": {"material": "diagnosis"},
    "still-01": {"material": "nylon", "samples": STILL},
    "bare-01": {"material": "nylon", "samples": recording(4).drop(columns="displacement_mm")},
    "alone-01": {"material": "silk", "samples": STILL},
}


def test_a_bad_run_costs_itself_alone_and_is_said_until_it_is_gone(few):
    project = few
    names = [*HOSTILE, *BAD, "good-01"]
    for name in names:
        add_run(project, name, **BAD.get(name, {"material": "nylon"}))
    damaged = project.folder / "processed" / "synthetic" / "metrics.parquet"
    damaged.write_bytes(damaged.read_bytes()[:-20])
    before = digest(project.folder / "raw")

    done = project.snakemake()
    said = done.stdout + done.stderr
    closing = done.stdout.partition("All else that was asked for is made. Left out until mended:\n")[2].splitlines()
    assert len(closing) == len(HOSTILE) + len(BAD) + 1 and "failed: " not in done.stdout
    assert closing[-1].startswith("Until then the main job ends as failed.")
    assert done.returncode != 0 and "left out: raw/typo-01/run.yaml: string.raduis_mm: is not a known key" in said
    assert "processed/synthetic/metrics.parquet: is damaged" in said and "it is made again" in said
    assert all(f"left out: raw/{one}/run.yaml: " in said for one in ("deep-01", "typo-01", "taken-01"))
    assert said.count("Mend: rename the folder") >= len(HOSTILE)
    assert digest(project.folder / "raw") == before and not list(project.folder.rglob("PWNED"))
    table = project.read("reports/nylon/table_1.md")
    assert all(f"Left out: run {one}: " in table for one in ("still-01", "bare-01", "typo-01")) and "deep" not in table
    assert "Left out: bare-01, still-01, typo-01." in project.read("reports/nylon/table_1.tex")
    assert "Left out" not in project.read("reports/nylon/table_1.csv") + project.read("reports/synthetic/table_1.md")
    index = project.read("reports/index.html")
    cell = '<td class="text">{}</td>'
    for one in (*BAD, *HOSTILE):
        assert not one.isprintable() or cell.format(escape(one)) in index, one
    assert cell.format("silk") in index and 'id="material-nylon"' in index and 'id="material-silk"' not in index
    assert materials_of(project) == {"synthetic", "nylon"} and not (project.folder / "reports/silk").exists()

    for name in names:
        shutil.rmtree(project.folder / "raw" / name)
    done = project.snakemake()
    assert done.returncode == 0, done.stdout + done.stderr
    assert "reports/diagnosis/good-01: removed, its run is gone" in done.stdout
    assert [path.name for path in (project.folder / "reports" / "diagnosis").iterdir()] == ["synthetic-01"]
    assert not (project.folder / "reports" / "nylon").exists() and materials_of(project) == {"synthetic"}
    index = project.read("reports/index.html")
    assert "nylon" not in index and 'id="left-out"' not in index
    assert project.rules_to_run() == {}


def materials_of(project):
    return {line.split(",")[0] for line in project.read("reports/metrics.csv").splitlines()[1:]}


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


def test_killed_at_any_point_the_launcher_goes_on_to_the_same_tables(few, few_finished):
    project = few
    shutil.rmtree(project.folder / "processed" / "synthetic")
    shutil.rmtree(project.folder / "reports")
    kills = 0
    for wait_for in ("dataset-synthetic", "train-synthetic-inn", "evaluate-synthetic"):
        log = project.folder / "processed" / "logs" / wait_for
        for old in log.parent.glob(f"{wait_for}*"):
            old.unlink()
        run = subprocess.Popen(
            project.command(), cwd=project.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        deadline_s = time.monotonic() + 300
        while run.poll() is None and not list(log.parent.glob(f"{wait_for}*")) and time.monotonic() < deadline_s:
            time.sleep(0.02)
        kills += run.poll() is None
        os.kill(run.pid, signal.SIGKILL)
        run.wait()
    assert kills == 3
    done = project.snakemake()
    assert done.returncode == 0, done.stdout + done.stderr
    for name in ("table_1.csv", "table_2.csv", "comparison.md"):
        assert project.read(f"reports/synthetic/{name}") == few_finished.read(f"reports/synthetic/{name}")


def test_a_killed_snakemake_leaves_no_job_behind(few):
    project = few
    shutil.rmtree(project.folder / "processed" / "synthetic" / "inn")
    slow = project.folder / "pipeline/config/ci.yaml"
    config = yaml.safe_load(slow.read_text())
    config["models"]["inn"]["settings"]["epochs"] = 3000
    slow.write_text(yaml.safe_dump(config))
    run = subprocess.Popen(project.command(), cwd=project.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        deadline_s = time.monotonic() + 120
        while not jobs_in(project.folder) and time.monotonic() < deadline_s:
            time.sleep(0.1)
        assert jobs_in(project.folder)
    finally:
        run.kill()
        run.wait()
    deadline_s = time.monotonic() + 30  # a job that was still importing ends when it has done so
    while jobs_in(project.folder) and time.monotonic() < deadline_s:
        time.sleep(0.1)
    assert not jobs_in(project.folder)


def jobs_in(folder):
    """Training programs at work in a folder."""
    done = subprocess.run(["pgrep", "-f", "pipeline.stages.train"], capture_output=True, text=True)
    places = []
    for pid in done.stdout.split():
        try:
            places.append(os.readlink(f"/proc/{pid}/cwd"))
        except OSError:
            continue
    return [place for place in places if place == str(folder)]
