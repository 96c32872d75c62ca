"""Programs that are written as text (in a test's string, on a page, in a notebook) import only what is there.

The type checker reads imports of modules alone, so a module that moves leaves its old name in such a text unseen.
"""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
IMPORT = re.compile(r"from (pipeline(?:\.\w+)*) import (\([\w\s,]+\)|[\w ,]+)")
TEXTS = sorted(
    path
    for place, kinds in ((".", ("*.md",)), ("docs", ("**/*.md", "**/*.ipynb")), ("tests", ("**/*.py",)))
    for kind in kinds
    for path in (ROOT / place).glob(kind)
)


def quoted(path: Path) -> str:
    """All that a file says as text: a page whole, of a module the strings."""
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".py":
        return text
    nodes = ast.walk(ast.parse(text)) if "from pipeline" in text else ()
    strings = (node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str))
    return "\n".join(strings)


def missing(module: str, names: str) -> list[str]:
    """The names that a module does not hold: neither a module under it nor a word of its source."""
    place = ROOT.joinpath(*module.split("."))
    source = place / "__init__.py" if place.is_dir() else place.with_suffix(".py")
    if not source.is_file():
        return [module]
    words = set(re.findall(r"\w+", source.read_text(encoding="utf-8")))
    wanted = [word.split(" as ")[0].strip() for word in names.strip("()").split(",")]
    under = {path.stem for path in place.iterdir()} if place.is_dir() else set()
    return [f"{module}.{name}" for name in wanted if name and name not in words | under]


def test_imports_in_a_text_are_there() -> None:
    imports = [(path, *match) for path in TEXTS for match in IMPORT.findall(quoted(path))]
    assert len(imports) > 20
    assert not [(path.name, lost) for path, module, names in imports for lost in missing(module, names)]


@pytest.mark.parametrize(("module", "name"), [("diagnosis", "engine"), ("no_room", "anything")])
def test_a_module_that_moved_is_seen(module: str, name: str) -> None:
    (quote,) = IMPORT.findall(f"from pipeline.{module} import {name}")
    assert missing(*quote)
