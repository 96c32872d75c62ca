import ast
import json
import os
import re
import stat
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
from made_damage import flips_and_cuts
from models.made_dataset import made_dataset

from pipeline.capture.log import Log
from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas, seal
from pipeline.ground.stored.files import whole, write_text
from pipeline.ground.words.jump_notes import NAME, read_jumps, write_jumps
from pipeline.ground.words.left_out import LeftOut, read_left_out, write_left_out
from pipeline.models.interface import make_model
from pipeline.workflow.known_files import KnownFiles


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


def test_of_a_thousand_folders_in_each_other_none_is_made(tmp_path):
    deep = tmp_path / ("x/" * 1000)
    for make in (lambda: Log(deep / "run-1"), lambda: write_text(deep / "table.csv", "new")):
        with pytest.raises(BadInput, match="cannot be"):
            make()
    assert not list(tmp_path.iterdir())
    write_text(tmp_path / ("x/" * 100) / "table.csv", "new")


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
    table.to_parquet(tmp_path / "elsewhere.parquet")
    with pytest.raises(BadInput, match="content: is damaged, or not this version's"):
        schemas.read(tmp_path / "elsewhere.parquet", schemas.PREDICTIONS)
    seal.seal_parquet(tmp_path / "elsewhere.parquet")
    with pytest.raises(BadInput, match="schema: columns, types or units"):
        schemas.read(tmp_path / "elsewhere.parquet", schemas.PREDICTIONS)


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


def rows(schema, many=200):
    """A table of a schema with numbers that no two rows share."""
    columns = {}
    for field in schema:
        kind = str(field.type)
        columns[field.name] = [str(at % 3) if kind == "string" else at % 2 == 0 if kind == "bool" else at + 0.0
                               for at in range(many)]  # fmt: skip
    return pd.DataFrame(columns).astype({field.name: "int32" for field in schema if str(field.type) == "int32"})


KINDS = {
    "samples": schemas.samples(["time_s", "motor_turns", "displacement_mm", "load_n"]),
    "strokes": schemas.STROKES, "dataset": schemas.DATASET, "predictions": schemas.PREDICTIONS,
    "metrics": schemas.METRICS,
}  # fmt: skip


def flipped(whole, path, read):
    """How many of 300 files with one bit the other way, and of 20 cut off, are read without a word."""
    silent = 0
    for content in flips_and_cuts(whole):
        path.write_bytes(content)
        try:
            read(path)
        except BadInput as error:
            assert str(path) in str(error) and "damaged" in error.problem and error.mend
        else:
            silent += 1
    return silent


NOTES = {
    "left_out.json": ([LeftOut(f"a-{at}", "nylon", "run.yaml", "run", "is ü", "mend it") for at in range(9)],
                      write_left_out, read_left_out),
    NAME: ({"a": ["The zero jumps by 0.2 mm.", "It jumps by −3 mm."]},
           write_jumps, lambda path: {"a": notes} if (notes := read_jumps([path])) else {}),
}  # fmt: skip


@pytest.mark.parametrize("name", NOTES)
@pytest.mark.parametrize("empty", [False, True])
def test_no_flipped_bit_of_a_note_is_read_silently(tmp_path, name, empty):
    content, write, read = NOTES[name]
    content, path = type(content)() if empty else content, tmp_path / name
    write(path, content)
    assert read(path) == content
    plain = json.loads(json.dumps(content, default=vars))
    assert json.loads(path.read_text())["content"] == plain, "any reader of JSON reads it"
    assert KnownFiles(tmp_path / "known.json").damaged([str(path)]) == {}
    whole = path.read_bytes()
    assert flipped(whole, path, read) == 0
    assert flipped(whole, path, no_damage) == 0, "the start of the main job finds each"


def no_damage(path):
    """What the start of the main job finds is raised."""
    damage = KnownFiles(path.with_name("known.json")).damaged([str(path)])
    if damage:
        raise BadInput(path, "content", f"damaged: {damage[str(path)]}", "mend it")


@pytest.mark.parametrize("kind", KINDS)
def test_no_flipped_bit_of_a_table_is_read_silently(tmp_path, kind):
    schema, path = KINDS[kind], tmp_path / f"{kind}.parquet"
    schemas.write(rows(schema), schema, path)
    assert len(schemas.read(path, schema)) == len(pd.read_parquet(path)) == 200  # any reader of Parquet reads it
    assert flipped(path.read_bytes(), path, lambda path: schemas.read(path, schema)) == 0


@pytest.mark.parametrize("name", ["inn", "spline", "traditional"])
def test_no_flipped_bit_of_a_model_is_read_silently(tmp_path, name):
    model, path = make_model(name, **({"epochs": 1} if name == "inn" else {})), tmp_path / "within-0.model"
    model.fit(made_dataset(40, 4), 0)
    model.save(path)
    make_model(name).load(path)
    assert flipped(path.read_bytes(), path, make_model(name).load) == 0


def test_every_program_says_whether_its_out_is_a_file_or_a_folder_and_the_default():
    pipeline, seen = Path(__file__).parents[2] / "pipeline", 0
    for path in pipeline.rglob("*.py"):
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not (isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute)):
                continue
            words = [word.value for word in call.args if isinstance(word, ast.Constant)]
            if call.func.attr == "add_argument" and "--out" in words:
                help_text = next(
                    (ast.literal_eval(keyword.value) for keyword in call.keywords if keyword.arg == "help"), ""
                )
                assert re.search("file|folder", help_text) and re.search("; (required|default: .+)$", help_text), (
                    path,
                    help_text,
                )
                seen += 1
    assert seen > 30


@pytest.mark.parametrize(("rows", "groups"), [(0, 1), (9, 1), (10, 1), (25, 3)])
def test_a_long_table_is_written_in_parts_and_read_as_one(tmp_path, monkeypatch, rows, groups):
    monkeypatch.setattr(schemas, "ROW_GROUP", 10)
    table = pd.DataFrame({"time_s": np.arange(float(rows)), "motor_turns": np.sqrt(np.arange(float(rows)))})
    path, schema = tmp_path / "samples.parquet", schemas.samples(["time_s", "motor_turns"])
    schemas.write(table, schema, path)
    pd.testing.assert_frame_equal(schemas.read(path, schema), table)
    assert pq.ParquetFile(path).num_row_groups == groups
