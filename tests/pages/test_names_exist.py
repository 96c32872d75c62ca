"""What stands in backticks in the pages and in the source's docstrings exists: paths, modules and names in them."""

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path

import pytest
from files_shown import shown

ROOT = Path(__file__).parents[2]
SOURCE, TREES = ROOT / "pipeline", ("pipeline", "tests", "benchmarks", "examples", "firmware", "docs", "env")
PAGES = [*sorted((ROOT / "docs").glob("*.md")), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
MODULES = sorted(SOURCE.rglob("*.py"))
QUOTED = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
CODE = re.compile(r"^ *```.*?^ *```$", re.M | re.S)
PATH = re.compile(rf"((?:[\w.-]+/)*[\w-]+\.py|(?:{'|'.join(TREES)})/[\w./-]+)(?:::(\w+))?")
DOTTED = re.compile(r"[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)+")
# what follows the dot in names of files, which modules are called like
FILES = {
    "csv", "frames", "html", "json", "lines", "lock", "mat", "md", "parquet", "pdf", "png", "py", "sha256", "txt",
    "yaml",
}  # fmt: skip
# sections of run.yaml and diagnosis.json, which modules are called like: what is in them is no name of the module
KEYS = {"evidence", "fit", "next_run", "rig", "samples", "string"}
ELSEWHERE = {
    "env/.venv": "the first start makes it",
    "env/.venv/bin/python": "the first start makes it",
    "persistence/file.py": "of Snakemake",
}


@cache
def tree_of(path: Path) -> ast.Module:
    return ast.parse(path.read_text("utf-8"))


def texts(path: Path) -> Iterator[str]:
    """A page without its blocks of code, or the docstrings of a module."""
    if path.suffix == ".md":
        yield CODE.sub("", path.read_text("utf-8"))
        return
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            yield ast.get_docstring(node) or ""


def quoted(path: Path) -> set[str]:
    return {name.removesuffix("()") for text in texts(path) for name in QUOTED.findall(text)}


def defined(body: list[ast.stmt]) -> Iterator[str]:
    """The names that a module or a class gives values, its functions' `self.` included."""
    for node in body:
        for inner in ast.walk(node):
            if isinstance(inner, ast.ClassDef | ast.FunctionDef):
                yield inner.name
            elif isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store):
                yield inner.id
            elif isinstance(inner, ast.Attribute) and isinstance(inner.ctx, ast.Store):
                yield inner.attr
            elif isinstance(inner, ast.alias):
                yield (inner.asname or inner.name).partition(".")[0]


@cache
def inside() -> dict[str, set[str]]:
    """By the name of a module, a room or a class: the names in those that are called so."""
    names = defaultdict(set)
    for path in MODULES:
        name = path.parent.name if path.name == "__init__.py" else path.stem
        tree = tree_of(path)
        names[name] |= set(defined(tree.body))
        names[path.parent.name].add(path.stem)
        names[path.parent.parent.name].add(path.parent.name)
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                names[node.name] |= set(defined(node.body))
    names["twistbench"] = names["pipeline"]
    return names


@cache
def by_last_part() -> dict[str, list[Path]]:
    """The files and folders of the checkout by the last part of their path."""
    paths = defaultdict(list)
    for path in (path for tree in TREES for path in (ROOT / tree).rglob("*") if ".venv" not in path.parts):
        paths[path.name].append(path)
    return paths


def is_there(path: str, test: str | None) -> bool:
    """Whether a path, or a file whose path ends with it, is in the checkout, with such a function."""
    parts = Path(path).parts
    at = [each for each in by_last_part()[parts[-1]] if each.parts[-len(parts) :] == parts]
    return bool(at) and (test is None or any(f"def {test}(" in each.read_text("utf-8") for each in at))


def is_known(dotted: str) -> bool:
    """Whether each part of a dotted name is in what stands before it; keys, files and others' names are not asked."""
    first, second, *_ = parts = dotted.split(".")
    if parts[-1] in FILES or first in KEYS:
        return True
    if first not in inside():  # what begins with a capital is a constant or a class of some module
        return not second[0].isupper() or find_spec(first) is not None
    return all(after in inside()[before] for before, after in pairwise(parts))


def missing(path: Path) -> list[str]:
    """What a page or a module names that is not there."""
    recipe = shown(str(path)) if path.suffix == ".md" else {}
    names = sorted(quoted(path) - set(ELSEWHERE) - set(recipe))
    return [
        name
        for name in names
        if ((match := PATH.fullmatch(name)) and not is_there(match[1], match[2]))
        or (not match and DOTTED.fullmatch(name) and not is_known(name))
    ]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_what_a_page_names_exists(page: Path) -> None:
    assert not missing(page)


def test_what_docstrings_name_exists() -> None:
    wrong = {str(path.relative_to(ROOT)): names for path in MODULES if (names := missing(path))}
    assert not wrong


def test_a_name_that_has_moved_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("`recalibration.TAKEN_BACK`, `choice/recalibration.py`, `Recording.read`, `run.yaml`")
    assert not missing(page)
    moved = ["disguise.TAKEN_BACK", "choice/disguise.py", "models.rational", "Recording.peruse"]
    gone = ["recalibration.STRAIT", "tests/pages/test_names_exist.py::test_gone"]
    page.write_text(", ".join(f"`{name}`" for name in moved + gone))
    assert missing(page) == sorted(moved + gone)
