"""A public function of arrays says what shape they have and in what unit; a model and a method, where it is from."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

from pipeline.ground.schemas import unit_of

PIPELINE = Path(__file__).parents[2] / "pipeline"
STRANGERS = PIPELINE / "rig" / "authors"  # by other hands, each in words of its own; never installed
ARRAY = re.compile(r"\b(Array|ndarray|NDArray|Values|Tensor)\b")
SHAPE = re.compile(
    r"\bshapes? \(|\b(any|its|their) shape\b|\bshapes broadcast|\bone value a sample\b"
    r"|\(\w+(, \w+)*,?\) to \(|\(\w+,\)",
    re.IGNORECASE,
)
UNIT = re.compile(
    r"(?<![\w-])(mm|turns?|rad|radians|deg|degrees|°C|N|Nm|N·mm|V|V/s|Hz|us|s|seconds?|microseconds|1/s|mm/turn|units?"
    r"|shares?|relative|counts?|bytes|indices|labels?|truth|whitened|factors?|probabilit(y|ies))(?![\w-])"
)


def sources() -> list[Path]:
    return sorted(path for path in PIPELINE.rglob("*.py") if not path.is_relative_to(STRANGERS))


@cache
def methods_of_classes() -> dict[str, str]:
    """What each class's methods say, under `Class.method`, of all classes: who fills one in need not say it again."""
    said: dict[str, str] = {}
    for path in sources():
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef):
                each = [one for one in node.body if isinstance(one, ast.FunctionDef)]
                said |= {f"{node.name}.{one.name}": ast.get_docstring(one) or "" for one in each}
    return said


def functions(path: Path) -> list[tuple[ast.FunctionDef, str]]:
    """Public functions and methods of a module, each with what its class says of itself."""
    listed: list[tuple[ast.FunctionDef, str]] = []
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef):
            listed.append((node, ""))
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            own, bases = ast.get_docstring(node) or "", [ast.unparse(base) for base in node.bases]
            for each in (one for one in node.body if isinstance(one, ast.FunctionDef)):
                above = " ".join(methods_of_classes().get(f"{base}.{each.name}", "") for base in bases)
                listed.append((each, f"{own} {above}"))
    return [(node, own) for node, own in listed if not node.name.startswith("_")]


def of_arrays(node: ast.FunctionDef) -> bool:
    """Whether a function takes or gives arrays."""
    arguments = [each.annotation for each in (*node.args.args, *node.args.kwonlyargs)]
    return any(ARRAY.search(ast.unparse(each)) for each in (*arguments, node.returns) if each)


def inherited(path: Path) -> dict[str, str]:
    """What the room's interface says of its methods: a file that fills one in need not say it again."""
    interface = path.parent / "interface.py"
    if not interface.is_file():
        return {}
    return {node.name: f"{own} {ast.get_docstring(node)}" for node, own in functions(interface) if own}


def unsaid(path: Path) -> list[str]:
    """The functions of arrays of a module whose shape or unit nobody says."""
    base, lacking = inherited(path), []
    for node, own in functions(path):
        if of_arrays(node):
            said = f"{ast.get_docstring(node) or ''} {own} {base.get(node.name, '')}"
            if not SHAPE.search(" ".join(said.split())):
                lacking.append(f"{node.name}: shape")
            if not UNIT.search(said) and unit_of(node.name) == "1":
                lacking.append(f"{node.name}: unit")
    return lacking


def test_a_public_function_of_arrays_says_shape_and_unit() -> None:
    lacking = {str(path.relative_to(PIPELINE)): unsaid(path) for path in sources()}
    assert not {name: said for name, said in lacking.items() if said}


def test_what_says_neither_is_found(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    for docstring, lacks in (
        ("The load of a shape, in N.", ["load: shape"]),
        ("The load.", ["load: shape", "load: unit"]),
        ("The load in N.", ["load: shape"]),
        ("The load, shape (samples,).", ["load: unit"]),
        ("The load in N, shape (samples,).", []),
    ):
        module.write_text(f'def load(x: int) -> Array:\n    """{docstring}"""\n')
        assert unsaid(module) == lacks


COMPARED = sorted(
    path
    for folder in ("proof/baselines", "real/black_boxes")
    for path in (PIPELINE / folder).glob("*.py")
    if re.search(r"^def learn\(", path.read_text(), re.M)
)
MODELS = sorted(path for path in (PIPELINE / "models").glob("*.py") if re.search(r"^MODEL\b", path.read_text(), re.M))


@pytest.mark.parametrize("path", [*MODELS, *COMPARED], ids=lambda path: path.stem)
def test_a_model_and_a_compared_method_name_their_published_source(path: Path) -> None:
    """Whom to read: a person or a paper, after `Source:` at the end of the module's docstring."""
    said = re.search(r"\nSource: (.+)", ast.get_docstring(ast.parse(path.read_text())) or "", re.S)
    assert said and re.search(r"[A-Z][a-z]+", said[1]) and re.search(r'\b(1[89]|20)\d\d\b|"', said[1])
