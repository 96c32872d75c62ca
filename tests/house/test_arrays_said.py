"""A public function of arrays says what shape they have and in what unit: a unit of measure, a share, a count."""

import ast
import re
from functools import cache
from pathlib import Path

from pipeline.ground.units import unit_of

PIPELINE = Path(__file__).parents[2] / "pipeline"
STRANGERS = PIPELINE / "rig" / "authors"  # by other hands, each in words of its own; never installed
ARRAYS = {"Array", "ndarray", "NDArray", "Values", "Tensor"}
ALIAS = re.compile(r"^(\w+) = NDArray\[", re.MULTILINE)
SHAPE = re.compile(
    r"\bshapes? \(|\b(any|its|their) shape\b|\bshapes broadcast|\bone value a sample\b"
    r"|\(\w+(, \w+)*,?\) to \(|\(\w+,\)",
    re.IGNORECASE,
)
NAMED = r"(mm|m|turns|strokes|rad|radians|deg|degrees|°C|N|Nm|V|Hz|us|ms|s|seconds|microseconds|damage)"
UNIT = re.compile(  # what stands by itself, as in "the first second" or "in turn", is no unit of an array
    rf"\b[Ii]n (all |both )?{NAMED}[²³]?(?![\w-])|\b[Ii]n ([^.;:]* )?units?\b|\b(any|one|no|whatever) units?\b"
    r"|\b[Ww]ithout (a )?units?\b|\bshares of 1\b|\bwhitened\b"
    r"|(\bis|\bare|\bas|\bby|\bin|,) (a share|shares|a count|counts|a mask|masks)\b"
    r"|(\bis|\bare|\bas|\bby|\bin|,) (labels|indices|places|probabilities|bytes)\b"
)


def sources() -> list[Path]:
    return sorted(path for path in PIPELINE.rglob("*.py") if not path.is_relative_to(STRANGERS))


@cache
def methods_of_classes() -> dict[str, str]:
    """What each class's methods say, under `Class.method`, of all classes: who fills one in need not say it again."""
    docstrings: dict[str, str] = {}
    for path in sources():
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef):
                each = [method for method in node.body if isinstance(method, ast.FunctionDef)]
                docstrings |= {f"{node.name}.{method.name}": ast.get_docstring(method) or "" for method in each}
    return docstrings


def functions(path: Path) -> list[tuple[ast.FunctionDef, str]]:
    """Public functions and methods of a module, each with what its class says of itself."""
    listed: list[tuple[ast.FunctionDef, str]] = []
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef):
            listed.append((node, ""))
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            own, bases = ast.get_docstring(node) or "", [ast.unparse(base) for base in node.bases]
            for each in (method for method in node.body if isinstance(method, ast.FunctionDef)):
                above = " ".join(methods_of_classes().get(f"{base}.{each.name}", "") for base in bases)
                listed.append((each, f"{own} {above}"))
    return [(node, own) for node, own in listed if not node.name.startswith("_")]


@cache
def aliases() -> dict[str, set[str]]:
    """Names that modules give to arrays of a kind, as `Mask`, by the names of those modules without their packages."""
    named = {path.stem: set(ALIAS.findall(path.read_text(encoding="utf-8"))) for path in sources()}
    return {stem: names for stem, names in named.items() if names}


@cache
def arrays_of(path: Path) -> re.Pattern[str]:
    """What an annotation of this module calls an array: the usual names, and aliases that it makes or imports."""
    text = path.read_text(encoding="utf-8")
    own = set(ALIAS.findall(text))
    for node in (each for each in ast.walk(ast.parse(text)) if isinstance(each, ast.ImportFrom)):
        module_aliases = aliases().get((node.module or "").rpartition(".")[2], set())
        own |= {each.asname or each.name for each in node.names if each.name in module_aliases}
    return re.compile(rf"\b({'|'.join(sorted(ARRAYS | own))})\b")


def of_arrays(node: ast.FunctionDef, array: re.Pattern[str]) -> bool:
    """Whether a function takes or gives arrays."""
    arguments = [each.annotation for each in (*node.args.args, *node.args.kwonlyargs)]
    return any(array.search(ast.unparse(each)) for each in (*arguments, node.returns) if each)


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
        if of_arrays(node, arrays_of(path)):
            documentation = f"{ast.get_docstring(node) or ''} {own} {base.get(node.name, '')}"
            if not SHAPE.search(" ".join(documentation.split())):
                lacking.append(f"{node.name}: shape")
            if not UNIT.search(" ".join(documentation.split())) and unit_of(node.name) == "1":
                lacking.append(f"{node.name}: unit")
    return lacking


def unsaid_fields(path: Path) -> list[str]:
    """The public fields of a module's dataclasses that are arrays whose shape or unit nobody says."""
    text, lacking = path.read_text(encoding="utf-8"), []
    classes = [node for node in ast.parse(text).body if isinstance(node, ast.ClassDef) and node.name[0] != "_"]
    for node in classes:
        if not any("dataclass" in ast.unparse(each) for each in node.decorator_list):
            continue
        for each in (field for field in node.body if isinstance(field, ast.AnnAssign)):
            name, kind = ast.unparse(each.target), ast.unparse(each.annotation)
            if name.startswith("_") or not arrays_of(path).search(kind) or "Callable" in kind:
                continue
            beside = text.splitlines()[(each.end_lineno or each.lineno) - 1].partition("#")[2]
            documentation = " ".join(f"{ast.get_docstring(node)} {beside}".split())
            if not SHAPE.search(documentation) and not re.search(r"\(\w[\w +-]*(, \w[\w +-]*)*,?\)", beside):
                lacking.append(f"{node.name}.{name}: shape")
            if not UNIT.search(documentation) and unit_of(name) == "1":
                lacking.append(f"{node.name}.{name}: unit")
    return lacking


def test_a_public_array_of_a_dataclass_says_shape_and_unit() -> None:
    lacking = {str(path.relative_to(PIPELINE)): unsaid_fields(path) for path in sources()}
    assert not {name: missing for name, missing in lacking.items() if missing}


def test_a_field_that_says_neither_is_found(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    for comment, lacks in (
        ("", ["Held.load: shape", "Held.load: unit"]),
        ("  # in N", ["Held.load: shape"]),
        ("  # (samples,)", ["Held.load: unit"]),
        ("  # (samples,), in N", []),
    ):
        module.write_text(f"@dataclass\nclass Held:\n    load: Array{comment}\n")
        assert unsaid_fields(module) == lacks


def test_a_public_function_of_arrays_says_shape_and_unit() -> None:
    lacking = {str(path.relative_to(PIPELINE)): unsaid(path) for path in sources()}
    assert not {name: missing for name, missing in lacking.items() if missing}


def test_what_says_neither_is_found(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    for docstring, lacks in (
        ("The load of a shape, in N.", ["load: shape"]),
        ("The load.", ["load: shape", "load: unit"]),
        ("The load in N.", ["load: shape"]),
        ("The load, shape (samples,).", ["load: unit"]),
        ("The load of the first second, in turn, shape (samples,).", ["load: unit"]),
        ("The share, the count and the truth of a turn, shape (samples,).", ["load: unit"]),
        ("The load in N, shape (samples,).", []),
        ("The load in its own unit, shape (samples,).", []),
        ("The load, a share of the usual one, shape (samples,).", []),
    ):
        module.write_text(f'def load(x: int) -> Array:\n    """{docstring}"""\n')
        assert unsaid(module) == lacks


def test_an_array_has_one_definition_and_an_alias_of_one_is_seen(tmp_path: Path) -> None:
    usual = {"Array": "ground/kinematics.py", "Mask": "ground/kinematics.py", "Places": "ground/kinematics.py"}
    for path in sources():
        inside = str(path.relative_to(PIPELINE))
        if inside != "wire/stamps.py":  # the wire stands on no room
            assert not [name for name in ALIAS.findall(path.read_text("utf-8")) if usual.get(name, inside) != inside]
    module = tmp_path / "module.py"
    module.write_text('Row = NDArray[np.intp]\ndef load(x: Row) -> int:\n    """The load."""\n')
    assert unsaid(module) == ["load: shape", "load: unit"]
    module = tmp_path / "another.py"
    module.write_text('from .kinematics import Mask\ndef load(x: Mask) -> int:\n    """The load."""\n')
    assert unsaid(module) == ["load: shape", "load: unit"]
