"""The reader of YAML files takes what is plain and refuses the rest with the line and the mend."""

import math
import os
from pathlib import Path

import pytest
import yaml

from pipeline.ground.errors import BadInput
from pipeline.ground.input.strict_yaml import read_yaml, write_yaml

ROOT = Path(__file__).parents[2]
SHIPPED = [path for path in sorted(ROOT.rglob("*.yaml")) if not any(part.startswith(".") for part in path.parts)]


def read(folder, text):
    path = folder / "any.yaml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_yaml(path)


def test_all_that_is_shipped_reads_as_before():
    assert len(SHIPPED) > 20
    for path in SHIPPED:
        assert read_yaml(path) == yaml.safe_load(path.read_text(encoding="utf-8")), path


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.0e-300", 1e-300),
        ("1e5", 1e5),
        ("-.5", -0.5),
        ("0", 0),
        ("0x1F", 31),
        ("true", True),
        ("~", None),
        ("", None),
        ("yes", "yes"),
        ("no", "no"),
        ("5:00", "5:00"),
        ("2026-11-22", "2026-11-22"),
        ("2026-11-22T25:61:00", "2026-11-22T25:61:00"),
        ('"0300"', "0300"),
        ("1_000", "1_000"),
        ("\N{BYTE ORDER MARK}a: 1", {"a": 1}),
        ("a: &x [1, 2]\nb: *x", {"a": [1, 2], "b": [1, 2]}),
        ("<<: {a: 1}", {"<<": {"a": 1}}),
    ],
)
def test_plain_words_are_read_as_yaml_1_2_does(tmp_path, text, value):
    parsed = read(tmp_path, text)
    assert parsed == value and type(parsed) is type(value)


def test_a_piece_of_json_is_read_as_a_value_and_else_the_mend_says_what_it_needs(tmp_path):
    entry = '{"id": "creep",\n  "parameters": {"tau_s": 31.0}}'
    assert read(tmp_path, f'run: a\n"simulation": [\n {entry}\n]\nb: 1')["simulation"][0]["id"] == "creep"
    for text in (f'run: a\n "simulation": [\n  {entry}\n ],\n', f"run: a\n{entry}\n", f"run: a\n[{entry}]\nb: 1"):
        with pytest.raises(BadInput) as refused:
            read(tmp_path, text)
        assert refused.value.problem == "is not YAML" and "no comma after its last bracket" in refused.value.mend
        assert "pipeline.adopt" in refused.value.mend
    for text in ("a: 1\nb: }", '{"run": "a",\n "b" 3}'):
        with pytest.raises(BadInput) as refused:
            read(tmp_path, text)
        assert refused.value.mend == "check its indentation, colons and quotes"


EXPLODING = "a0: &a0 [x, x]\n" + "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]\n" for n in range(1, 12))


@pytest.mark.parametrize(
    ("text", "place", "says"),
    [
        ("a: 1\nb: 2\na: 3", "line 3", "says 'a' a second time"),
        ("a: {b: 1, b: 2}", "line 1", "says 'b' a second time"),
        ('a: 1\n"a": 2', "line 2", "says 'a' a second time"),
        (b"a: \xe4", "any.yaml", "not UTF-8"),
        ("a: 1".encode("utf-16"), "any.yaml", "not UTF-8"),
        ("a: 1\n- b", "line 2", "is not YAML"),
        ("a: 1\nb: }", "line 2", "is not YAML"),
        ("a: \0", "any.yaml", "is not YAML"),
        ("[" * 3000, "line 1", "nested more than 30 deep"),
        ("\n".join(" " * n + "a:" for n in range(1000)), "line 31", "nested more than 30 deep"),
        (EXPLODING, "line 7", "huge once its aliases are written out"),
        ("a: &x [*x]", "line 1", "stands for nothing, or for what it stands in"),
        ("a: &x {b: *x}", "line 1", "stands for nothing, or for what it stands in"),
        ("a: &x 1\nb: &x [*x]", "line 2", "stands for nothing, or for what it stands in"),
        ("a: *x", "line 1", "stands for nothing"),
        ("a: !!int x", "line 1", "carries the tag 'tag:yaml.org,2002:int'"),
        ("a: !!python/object/apply:os.system [ls]", "line 1", "carries the tag"),
        ("a: ! x", "line 1", "carries the tag '!'"),
        ("a: 0300", "line 1", "0300 is a number with a leading zero. Mend: write 300, or put it in quotes"),
        ("a: " + "9" * 5000, "line 1", "is a number of 5000 characters"),
        ("a: 1e999", "line 1", "no computer holds"),
        ("a: 1e-999", "line 1", "no computer holds"),
        ("a: .nan", "line 1", "a: .nan is no finite number"),
        ("{b: {radius_mm: -.inf}}", "line 1", "radius_mm: -.inf is no finite number"),
        ("? [a, b]\n: 1", "line 1", "a key that is no name"),
        ("true: 1", "line 1", "a key that is no name"),
        ("1.5: 1", "line 1", "a key that is no name"),
        ("{null: 1}", "line 1", "a key that is no name"),
        ("a: 1\n---\nb: 2", "line 2", "begins a second document"),
        ("a: " + "x" * 1_000_001, "any.yaml", "more than 1 MB"),
    ],
)
def test_what_is_unclear_or_endless_is_refused_with_its_line(tmp_path, text, place, says):
    with pytest.raises(BadInput) as error:
        read(tmp_path, text)
    assert error.value.field == place and says in str(error.value)


def test_what_is_no_plain_file_is_refused(tmp_path):
    (tmp_path / "folder.yaml").mkdir()
    os.mkfifo(tmp_path / "pipe.yaml")
    (tmp_path / "loop.yaml").symlink_to("loop.yaml")
    (tmp_path / "file").write_text("a: 1")
    for name, says in [
        ("folder.yaml", "is a folder, not a file"),
        ("pipe.yaml", "is a pipe, not a file"),
        ("loop.yaml", "cannot be read (Too many levels of symbolic links)"),
        ("none.yaml", "is not there"),
        ("file/none.yaml", "is not there"),
        ("x" * 300, "cannot be read (File name too long)"),
        ("a\0b", "is no name of a file"),
    ]:
        with pytest.raises(BadInput) as error:
            read_yaml(tmp_path / name)
        assert says in str(error.value)
    with pytest.raises(BadInput, match="is a device, not a file"):
        read_yaml(Path("/dev/zero"))


def test_what_is_written_reads_back(tmp_path):
    words = [
        "yes",
        "1e5",
        "0o7",
        "0300",
        "5:00",
        "2026-11-22",
        "~",
        "",
        ".nan",
        "null",
        "a: b",
        "é\u2028x",
        "- x",
        "1_0",
    ]
    content = {"b": words, "a": {word: 1.5e-300 for word in words}, "c": [1e300, -0.1, math.pi, 7, True, None]}
    assert read(tmp_path, write_yaml(content)) == content
    assert write_yaml({"b": 1, "a": 2}) == "b: 1\na: 2\n"
