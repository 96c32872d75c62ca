"""What source files import is found once for all processes, and anew when a file or the finding changes."""

import json

import pytest

from pipeline.ground.code import fingerprint, kept_imports
from pipeline.ground.code.fingerprint import reachable


@pytest.fixture
def looked(tmp_path, monkeypatch):
    """Names of the files of a small package that a new process looks into, and what it reaches from the first."""
    house = tmp_path / "pipeline"
    house.mkdir()
    (house / "__init__.py").touch()
    (house / "a.py").write_text("from . import b\n")
    (house / "b.py").write_text("import pipeline.c\n")
    (house / "c.py").touch()
    monkeypatch.setattr(fingerprint, "HOUSE", house)
    monkeypatch.setattr(kept_imports.sys, "dont_write_bytecode", False)
    names, anew = [], fingerprint._imports_anew
    monkeypatch.setattr(fingerprint, "_imports_anew", lambda path: names.append(path.name) or anew(path))

    def process():
        for cached in (fingerprint._source, fingerprint._kept, fingerprint._imports, fingerprint._file_in):
            cached.cache_clear()
        names.clear()
        paths = {path.name for path in reachable("pipeline.a")}
        return set(names), paths

    yield house, process
    for cached in (fingerprint._source, fingerprint._kept, fingerprint._imports, fingerprint._file_in):
        cached.cache_clear()


ALL = {"__init__.py", "a.py", "b.py", "c.py"}


def kept(house):
    (path,) = (house / "__pycache__").glob("imports.*.json")
    return path


def test_a_second_process_looks_into_no_file_and_reaches_the_same(looked):
    process = looked[1]
    assert process() == (ALL, ALL)
    assert process() == (set(), ALL)


def test_what_is_kept_is_no_source_of_the_package(looked):
    house, process = looked
    process()
    assert kept(house).is_file() and {path.name for path in reachable("pipeline.*")} == ALL


def test_a_file_that_changed_is_looked_into_and_so_is_one_that_is_new(looked):
    house, process = looked
    process()
    (house / "b.py").write_text("from . import d\n")
    (house / "d.py").touch()
    assert process() == ({"b.py", "d.py"}, ALL - {"c.py"} | {"d.py"})
    assert process() == (set(), ALL - {"c.py"} | {"d.py"})


def test_where_the_finding_changed_all_files_are_looked_into(looked, monkeypatch):
    process = looked[1]
    process()
    monkeypatch.setattr(kept_imports, "FINDS", kept_imports.FINDS[1:])
    assert process() == (ALL, ALL)


@pytest.mark.parametrize("damage", ["", "[1]", "[" * 9000, "{}", '{"finder": 3}', "a string", "numbers"])
def test_what_is_kept_and_damaged_is_found_anew(looked, damage):
    house, process = looked
    process()
    content = json.loads(kept(house).read_text())
    if damage == "a string":
        content["entries"] = "pipeline"
    elif damage == "numbers":
        content["entries"] = {name: [entry[0], 3] for name, entry in content["entries"].items()}
    damaged = json.dumps(content) if damage in ("a string", "numbers") else damage
    kept(house).write_text(damaged)
    assert process() == (ALL, ALL)
    assert process() == (set(), ALL)


def test_where_nothing_compiled_is_kept_neither_are_imports(looked, monkeypatch):
    house, process = looked
    monkeypatch.setattr(kept_imports.sys, "dont_write_bytecode", True)
    process()
    assert not (house / "__pycache__").exists()
    monkeypatch.setattr(kept_imports.sys, "dont_write_bytecode", False)
    (house / "__pycache__").write_text("no folder")  # as where nobody may write
    assert process() == process() == (ALL, ALL)
