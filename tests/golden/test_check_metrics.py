"""The check of the published metrics passes on them and fails on a regression."""

import json
import shutil
from pathlib import Path

import pytest
from golden.check_metrics import PUBLISHED, complaints, misdiagnosis


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
    first, *others = [one.split() for one in sets]
    verdict = "ambiguous" if others else "explained"
    content = {"verdict": verdict, "mechanisms": [{"id": name} for name in first], "alternatives": others, "fit": fit}
    path = tmp_path / "diagnosis" / "synthetic-01" / "diagnosis.json"
    path.parent.mkdir(parents=True)
    path.write_text(json.dumps(content), encoding="utf-8")
    found = misdiagnosis(tmp_path)
    assert says in "\n".join(found) and len(found) == bool(says)
