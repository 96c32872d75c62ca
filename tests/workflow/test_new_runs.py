"""Runs that are added to a finished project of two models: a new material, and what costs itself alone."""

import shutil

import pytest
from added_runs import OF_A_MATERIAL, add_run, digest
from made_recording import recording
from markupsafe import escape

pytestmark = pytest.mark.long  # the main job is run again


def test_a_new_material_runs_its_own_jobs_only_and_raw_is_never_touched(few):
    project = few
    add_run(project, "nylon-01", "nylon")
    before = digest(project.folder / "raw")
    done = project.snakemake()
    assert done.returncode == 0, done.stdout + done.stderr
    assert project.rules_of(done.stderr) == {"train": 4, **OF_A_MATERIAL}
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
    printed = done.stdout + done.stderr
    closing = done.stdout.partition("All else that was asked for is made. What is to be mended:\n")[2].splitlines()
    assert len(closing) == len(HOSTILE) + len(BAD) + 1 and "failed: " not in done.stdout
    assert closing[-1].startswith("Until then the main job ends as failed.")
    assert done.returncode != 0 and "left out: raw/typo-01/run.yaml: string.raduis_mm: is not a known key" in printed
    assert "processed/synthetic/metrics.parquet: is damaged" in printed and "it is made again" in printed
    assert all(f"left out: raw/{run_name}/run.yaml: " in printed for run_name in ("deep-01", "typo-01", "taken-01"))
    assert printed.count("Mend: rename the folder") >= len(HOSTILE)
    assert digest(project.folder / "raw") == before and not list(project.folder.rglob("PWNED"))
    table = project.read("reports/nylon/table_1.md")
    assert (
        all(f"Left out: run {run_name}: " in table for run_name in ("still-01", "bare-01", "typo-01"))
        and "deep" not in table
    )
    assert "Left out: bare-01, still-01, typo-01." in project.read("reports/nylon/table_1.tex")
    assert "Left out" not in project.read("reports/nylon/table_1.csv") + project.read("reports/synthetic/table_1.md")
    index = project.read("reports/index.html")
    cell = '<td class="text">{}</td>'
    for run_name in (*BAD, *HOSTILE):
        assert not run_name.isprintable() or cell.format(escape(run_name)) in index, run_name
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
