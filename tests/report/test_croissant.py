"""The metadata of a dataset, validated by Croissant's own library, and the dataset read back through them."""

import json
import logging
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest
from models.made_dataset import made_dataset

from pipeline.ground.stored import schemas

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def mlcroissant():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of its own imports
        import mlcroissant

        return mlcroissant


@pytest.fixture(scope="module")
def project_folder(tmp_path_factory) -> Path:
    """A dataset with its metadata; the folder in which `processed/` and `reports/` lie."""
    place = tmp_path_factory.mktemp("croissant")
    dataset = place / "processed" / "nylon" / "dataset.parquet"
    schemas.write(made_dataset(per_phase=20, strokes=2), schemas.DATASET, dataset)
    assert made_by_program(dataset, place / "reports" / "nylon" / "croissant.json").returncode == 0
    return place


def made_by_program(dataset: Path, out: Path) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "pipeline.report.croissant", str(dataset), "--out", str(out)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


def read(mlcroissant, path: Path):
    """The dataset behind metadata, and what the library says of them."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        logging.disable()
        try:
            loaded = mlcroissant.Dataset(jsonld=str(path))
            return loaded, loaded.metadata.ctx.issues
        finally:
            logging.disable(logging.NOTSET)


def test_its_own_library_finds_no_error_and_reads_the_dataset_back(project_folder, mlcroissant):
    loaded, issues = read(mlcroissant, project_folder / "reports" / "nylon" / "croissant.json")
    assert not issues.errors, issues.errors
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        records = [*loaded.records(record_set="points")]
    table = made_dataset(per_phase=20, strokes=2)
    assert len(records) == len(table)
    for name in table:
        back = [record[f"points/{name}"] for record in records]
        if schemas.DATASET.field(name).type == "string":
            assert [cell.decode() for cell in back] == table[name].tolist(), name
        else:
            np.testing.assert_array_equal(np.array(back, dtype=table[name].dtype), table[name], name)


def test_the_library_would_find_an_error(project_folder, mlcroissant, tmp_path):
    content = json.loads((project_folder / "reports" / "nylon" / "croissant.json").read_text())
    content["recordSet"][0]["field"][0]["source"]["fileObject"]["@id"] = "another.parquet"
    (tmp_path / "croissant.json").write_text(json.dumps(content))
    with pytest.raises(mlcroissant.ValidationError):
        read(mlcroissant, tmp_path / "croissant.json")


def test_each_column_says_its_unit_and_the_file_is_named_by_its_check_sum(project_folder):
    content = json.loads((project_folder / "reports" / "nylon" / "croissant.json").read_text())
    fields = {field["name"]: field for field in content["recordSet"][0]["field"]}
    assert [*fields] == schemas.DATASET.names
    assert fields["displacement_mm"]["description"].endswith(", in mm")
    (file,) = content["distribution"]
    assert file["contentUrl"] == "../../processed/nylon/dataset.parquet" and len(file["sha256"]) == 64
    assert "Made by hand" in content["description"]


def test_the_same_dataset_gives_the_same_bytes_and_a_damaged_one_none(project_folder, tmp_path):
    dataset = project_folder / "processed" / "nylon" / "dataset.parquet"
    again = project_folder / "reports" / "again" / "croissant.json"
    assert made_by_program(dataset, again).returncode == 0
    assert again.read_bytes() == (project_folder / "reports" / "nylon" / "croissant.json").read_bytes()
    broken = tmp_path / "processed" / "nylon" / "dataset.parquet"
    broken.parent.mkdir(parents=True)
    data = bytearray(dataset.read_bytes())
    data[200] ^= 1
    broken.write_bytes(data)
    done = made_by_program(broken, tmp_path / "croissant.json")
    assert done.returncode == 2 and "is damaged" in done.stderr and not (tmp_path / "croissant.json").exists()
