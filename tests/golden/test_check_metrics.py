"""The check of the published metrics passes on them and fails on a regression."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from golden import check_metrics
from golden.check_metrics import PUBLISHED, complaints, misdiagnosis

from pipeline.report.layout import paper
from pipeline.report.layout.made_by import MadeBy
from pipeline.report.layout.sidecar import describe


@pytest.fixture
def reports(tmp_path: Path) -> Path:
    shutil.copytree(PUBLISHED, tmp_path / "synthetic")
    return tmp_path


def worsen(reports: Path, table: int, start: str, factor: float) -> None:
    path = reports / "synthetic" / f"table_{table}.csv"
    lines = path.read_text(encoding="utf-8").splitlines()
    row = next(number for number, line in enumerate(lines) if line.startswith(start))
    *names, average, maximum, rmse = lines[row].split(",")
    lines[row] = ",".join([*names, f"{float(average) * factor:.3f}", maximum, rmse])
    path.write_text("\n".join(lines), encoding="utf-8")


def test_the_published_tables_pass(reports):
    assert complaints(reports) == []


@pytest.mark.parametrize(
    ("table", "row", "factor", "says"),
    [
        (1, "INN model,n=5", 1.3, "INN model, n=5, average"),
        (2, "MLP model,n=9", 0.7, "MLP model, n=9, average"),
        (1, "Traditional model,n=1", 1.01, "Traditional model, n=1, average"),
        (2, "Calibrated model,n=1", 0.99, "Calibrated model, n=1, average"),
        (2, "INN model,n=1", 3.0, "is not below the paper's 0.584"),
        (2, "Traditional model,n=9", 1.2, "from the paper's 18 numbers"),
    ],
)
def test_a_regression_is_named(reports, table, row, factor, says):
    worsen(reports, table, row, factor)
    assert says in "\n".join(complaints(reports))


def test_a_missing_row_is_named(reports):
    path = reports / "synthetic" / "table_1.csv"
    path.write_text("\n".join(path.read_text(encoding="utf-8").splitlines()[:-1]), encoding="utf-8")
    assert "its rows are not the published ones" in "\n".join(complaints(reports))


@pytest.mark.parametrize(
    ("sets", "explained_mm", "says"),
    [
        (["creep radius_compaction"], 0.031, ""),
        (["creep jam"], 0.031, "the rig has no jam"),
        (["creep"], 0.07, "it leaves 0.07 mm"),
        ([""], 0.03, "although the rig has effects"),
        (["creep jam", "creep"], 0.031, ""),
        (["creep jam", "creep slack"], 0.031, "the rig has no jam"),
        (["creep jam", "creep", "wear", "slack"], 0.031, "4 explanations are held"),
    ],
)
def test_a_wrong_diagnosis_is_named(tmp_path, sets, explained_mm, says):
    fit = {"noise_floor_mm": 0.03, "heldout": {"explained_mm": explained_mm}}
    first, *others = [effect_names.split() for effect_names in sets]
    verdict = "ambiguous" if others else "explained"
    content = {"verdict": verdict, "mechanisms": [{"id": name} for name in first], "alternatives": others, "fit": fit}
    path = tmp_path / "diagnosis" / "synthetic-01" / "diagnosis.json"
    path.parent.mkdir(parents=True)
    path.write_text(json.dumps(content), encoding="utf-8")
    faults = misdiagnosis(tmp_path)
    assert says in "\n".join(faults) and len(faults) == bool(says)


def asked_of(reports: Path) -> tuple[int, str]:
    """Exit status and all words of the program, as a person starts it."""
    done = subprocess.run(
        [sys.executable, check_metrics.__file__, str(reports)], capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout + done.stderr


def mark_tables(reports: Path, mark: MadeBy) -> None:
    for number in (1, 2):
        columns = [(head, "string", "") for head in paper.header(number)]
        describe(reports / "synthetic" / f"table_{number}.csv", "a table", columns, mark)


def test_tables_of_another_configuration_are_told_to_be_others_and_what_makes_the_published_ones(reports):
    path = reports / "synthetic" / "table_1.csv"
    rows = path.read_text(encoding="utf-8").splitlines()
    emptied = [",".join([*row.split(",")[:2], "", "", ""]) if ",n=9," in row else row for row in rows]
    path.write_text("\n".join(emptied), encoding="utf-8")
    mark_tables(reports, MadeBy("ci.yaml", "b63d259", "small"))
    status, words = asked_of(reports)
    assert status == 1 and len(words.splitlines()) == 1
    name = "ci.yaml (checksum of its settings b63d259) (small fit: not a result)"
    assert f"these tables are of another configuration, {name}" in words
    assert "they cannot be the published ones" in words and "`snakemake --cores 2` makes those" in words
    mark_tables(reports, MadeBy("default.yaml", "b63d259", "default"))
    status, words = asked_of(reports)
    assert status == 1 and "table_1.csv: its rows are not the published ones" in words and "Traceback" not in words


def test_what_is_not_there_is_named_with_what_makes_it(reports, tmp_path):
    status, words = asked_of(reports)
    assert status == 1 and words.startswith("diagnosis: ") and "diagnosis.json is not there" in words
    status, words = asked_of(tmp_path / "nothing")
    assert status == 1 and "table_1.csv is not there: `snakemake --cores 2` makes it" in words
