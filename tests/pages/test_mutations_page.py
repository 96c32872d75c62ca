"""docs/mutations.md names modules and tests that are there, and a draw begins with tests that pass."""

import importlib
import re
from itertools import product
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ROWS = re.findall(r"^\| \w+ \| `(\S+)` \| `(\S+)` \|", (ROOT / "docs" / "mutations.md").read_text("utf-8"), re.M)


def spelled_out(name: str) -> list[str]:
    """Every path that a name with braces stands for."""
    parts = [part.strip("{}").split(",") for part in re.split(r"(\{[^}]*\})", name)]
    return ["".join(chosen) for chosen in product(*parts)]


def test_each_module_and_test_of_the_table_is_there() -> None:
    assert len(ROWS) == 11
    modules = [ROOT / "pipeline" / path for row in ROWS for path in spelled_out(row[0])]
    tests = [ROOT / path for row in ROWS for path in spelled_out(row[1])]
    assert not [path for path in (*modules, *tests) if not path.is_file()]
    assert spelled_out("a{,_b}/{c,d}.py") == ["a/c.py", "a/d.py", "a_b/c.py", "a_b/d.py"]


def test_a_draw_whose_tests_fail_anyway_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each mutant would count as killed: a draw of November 28 had 40 of 40 so."""
    monkeypatch.syspath_prepend(str(ROOT / "benchmarks"))
    mutations = importlib.import_module("mutations")
    monkeypatch.setattr(mutations, "TARGETS", {"wire": ({"wire/cobs.py"}, "tests/there_is_none.py")})
    monkeypatch.setattr(mutations, "cosmic_ray", lambda *_: "")
    monkeypatch.setattr(mutations, "sample", lambda *_: None)
    with pytest.raises(SystemExit, match="wire: its tests fail without a mutant"):
        mutations.tried(tmp_path / "cosmic-ray", "wire", tmp_path, 1, 1)
