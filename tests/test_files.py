import os
import stat

import pandas as pd
import pytest

from pipeline import schemas
from pipeline.errors import BadInput
from pipeline.files import whole, write_text


def test_a_failed_write_leaves_what_was_there(tmp_path):
    path = tmp_path / "table.csv"
    write_text(path, "old")

    def write_half():
        with whole(path) as temporary:
            temporary.write_text("half")
            raise OSError("disk full")

    with pytest.raises(OSError, match="disk full"):
        write_half()
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["table.csv"]


def test_who_reads_sees_the_old_file_or_the_new_one(tmp_path):
    path = tmp_path / "table.csv"
    write_text(path, "old")
    with open(path) as reader:
        write_text(path, "new and longer")
        assert reader.read() == "old"
    assert path.read_text() == "new and longer"


def test_a_table_comes_back_as_it_went(tmp_path):
    table = pd.DataFrame({"point": [1, 2], "displacement_mm": [0.5, float("nan")], "motor_turns": [1.0, 2.0]})
    schemas.write(table, schemas.PREDICTIONS, tmp_path / "t.parquet")
    read = schemas.read(tmp_path / "t.parquet", schemas.PREDICTIONS)
    assert read["displacement_mm"].isna().tolist() == [False, True]
    assert read["point"].tolist() == [1, 2]


def test_another_versions_table_is_refused(tmp_path):
    table = pd.DataFrame({"point": [1], "displacement_mm": [0.5], "motor_turns": [1.0]})
    schemas.write(table, schemas.PREDICTIONS, tmp_path / "t.parquet")
    with pytest.raises(BadInput, match="schema: columns, types or units"):
        schemas.read(tmp_path / "t.parquet", schemas.STROKES)
    table.to_parquet(tmp_path / "unitless.parquet")
    with pytest.raises(BadInput, match="schema"):
        schemas.read(tmp_path / "unitless.parquet", schemas.PREDICTIONS)


def test_every_column_with_a_unit_says_it():
    for schema in (schemas.STROKES, schemas.DATASET, schemas.PREDICTIONS):
        units = {field.name: field.metadata[b"unit"].decode() for field in schema}
        assert units.get("displacement_mm", "mm") == "mm" and units.get("start_turns", "turns") == "turns"
        assert units.get("stiffness_n_per_mm", "N/mm") == "N/mm" and units.get("stroke", "1") == "1"


def test_only_a_file_is_ever_replaced(tmp_path):
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("old")
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    before = sorted(os.listdir(tmp_path))
    for target in ("", "folder", "pipe", "link", "file/below", "x" * 300, "a\0b"):
        with pytest.raises(BadInput, match=r"--out: .*Mend: give the name of a file"):
            write_text(tmp_path / target if target else "", "new")
    assert sorted(os.listdir(tmp_path)) == before and (tmp_path / "file").read_text() == "old"
    for device in ("/dev/null", "/dev/full"):
        with pytest.raises(BadInput, match="a device"):
            write_text(device, "new")
        assert stat.S_ISCHR(os.stat(device).st_mode)
