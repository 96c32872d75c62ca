"""No module hands another a dictionary of anything, also not within a list: nobody could know what is in it."""

import ast
import re
from pathlib import Path

from imported import imported

PIPELINE = Path(__file__).parents[2] / "pipeline"
STRANGERS = "rig.authors."  # each is written apart from all else
DICTIONARIES = {"dict", "Mapping", "MutableMapping", "defaultdict", "OrderedDict"}
IN_QUOTES = re.compile(r"\[str, Any\]")
LEFT: dict[str, str] = {}  # by the full name below `pipeline`: why nobody can say more of it


def holds_anything(annotation: ast.AST | None, aliases: set[str]) -> bool:
    """Whether a type is, or holds, a dictionary of anything, or a name that stands for one."""
    for node in ast.walk(annotation) if annotation else ():
        if isinstance(node, ast.Subscript) and ast.unparse(node.value) in DICTIONARIES:
            *_, values = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
            if ast.unparse(values) == "Any":
                return True
        if isinstance(node, ast.Name) and node.id in aliases:
            return True
        if isinstance(node, ast.Constant) and IN_QUOTES.search(str(node.value)):
            return True
    return False


def aliases_of(body: list[ast.stmt]) -> set[str]:
    """Names that a module gives to such a type."""
    assignments = [node for node in body if isinstance(node, ast.Assign) and holds_anything(node.value, set())]
    return {target.id for node in assignments for target in node.targets if isinstance(target, ast.Name)}


def bare(source: str, others: set[str] = frozenset()) -> set[str]:
    """Public functions, and classes by their public functions and fields, that say such a type."""
    body = ast.parse(source).body
    aliases = aliases_of(body) | set(others)
    names = set()
    for node in body:
        parts = node.body if isinstance(node, ast.ClassDef) else [node]
        for part in parts:
            types: list[ast.AST | None] = []
            if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef) and not part.name.startswith("_"):
                parameters = part.args
                arguments = [
                    *parameters.posonlyargs,
                    *parameters.args,
                    *parameters.kwonlyargs,
                    parameters.vararg,
                    parameters.kwarg,
                ]
                types = [part.returns, *(each.annotation for each in arguments if each)]
            elif isinstance(node, ast.ClassDef) and isinstance(part, ast.AnnAssign):
                types = [part.annotation]
            if not getattr(node, "name", "_").startswith("_") and any(holds_anything(each, aliases) for each in types):
                names.add(node.name)
    return names


def handed_on() -> set[str]:
    """What modules hand each other in dictionaries of anything, by the full names below `pipeline`."""
    sources = {".".join(path.relative_to(PIPELINE).with_suffix("").parts): path for path in PIPELINE.rglob("*.py")}
    sources = {name.removesuffix(".__init__"): path for name, path in sources.items()}
    sources = {name: path for name, path in sources.items() if not f"{name}.".startswith(STRANGERS)}
    texts = {name: path.read_text("utf-8") for name, path in sources.items()}
    takes = {
        name: {imported_name.removeprefix("pipeline.") for imported_name in imported(path)}
        for name, path in sources.items()
    }
    hidden = {f"{name}.{alias}" for name, text in texts.items() for alias in aliases_of(ast.parse(text).body)}
    full = {
        f"{name}.{each}"
        for name, text in texts.items()
        for each in bare(text, {imported_name.rpartition(".")[2] for imported_name in takes[name] & hidden})
    }
    used = set()
    for name, text in texts.items():
        for each in full:
            module, _, short = each.rpartition(".")
            by_module = module in takes[name] and f"{module.rpartition('.')[2]}.{short}" in text
            if module != name and (each in takes[name] or by_module):
                used.add(each)
    return used


def test_modules_hand_each_other_types() -> None:
    assert handed_on() == set(LEFT), "give it a TypedDict, a dataclass or the one kind of its values"


def test_a_dictionary_of_anything_is_found() -> None:
    assert bare("def a(x: dict[str, Any]) -> int: ...") == {"a"}
    assert bare("def a() -> Iterator[tuple[int, list[dict[str, Any]]]]: ...") == {"a"}
    assert bare("def a(*, x: Mapping[str, dict[str, Any]] | None = None) -> int: ...") == {"a"}
    assert bare("def a(x: 'dict[str, Any]') -> int: ...") == {"a"}
    assert bare("class A:\n    x: dict[str, Any]\n") == {"A"}
    assert bare("class A:\n    def b(self) -> dict[str, Any]: ...\n") == {"A"}
    assert bare("Row = dict[str, Any]\ndef a(x: list[Row]) -> int: ...") == {"a"}
    assert bare("def a(x: Row) -> int: ...", {"Row"}) == {"a"}
    assert not bare("def a(x: dict[str, object], y: dict[str, list[Any]], z: Any) -> int: ...")
    assert not bare("def _a(x: dict[str, Any]) -> int: ...\ndef b() -> None:\n    x: dict[str, Any] = {}")
