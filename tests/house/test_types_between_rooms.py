"""What one room hands to another has a type of its own; a bare `dict[str, Any]` is somebody else's document."""

import ast
import re
from pathlib import Path

from imported import imported

PIPELINE = Path(__file__).parents[2] / "pipeline"
BARE = re.compile(r"(dict|Mapping)\[str, (Any|object)\]")
# whose form another program or a person decides: it is read where it comes in, and made a type there
DOCUMENTS = {
    **{
        f"diagnosis.document.made_keys.{name}": "any typed part, read by a key that ends in the reading's unit"
        for name in ("amount", "amount_or_none", "by_name", "extent", "interval", "put")
    },
    "rig.authors.interface.HiddenEffect": "parameters of a law by another hand, never installed",
    "rig.effects.make": "an effect's parameters as a set-up's file has them, which it checks",
}


def bare(source: str, others: frozenset[str] = frozenset()) -> set[str]:
    """Public names of a module that are, take, give or hold a dictionary without a type; `others`: imported aliases."""
    body = ast.parse(source).body
    own = aliases(source)
    words = "|".join(sorted(own | others))
    is_bare = re.compile(rf"{BARE.pattern}|\b({words})\b" if words else BARE.pattern)
    names = set()
    for node in body:
        if isinstance(node, ast.FunctionDef):
            types = types_of(node)
        elif isinstance(node, ast.ClassDef):
            public = [each for each in node.body if isinstance(each, ast.FunctionDef) and not each.name.startswith("_")]
            fields = [ast.unparse(each.annotation) for each in node.body if isinstance(each, ast.AnnAssign)]
            types = [*fields, *(word for each in public for word in types_of(each))]
        else:
            continue
        if not node.name.startswith("_") and is_bare.search(" ".join(types)):
            names.add(node.name)
    return names


def aliases(source: str) -> set[str]:
    """Names that a module gives to a dictionary without a type."""
    assignments = [node for node in ast.parse(source).body if isinstance(node, ast.Assign)]
    return {ast.unparse(node.targets[0]) for node in assignments if BARE.match(ast.unparse(node.value))}


def types_of(node: ast.FunctionDef) -> list[str]:
    """The types that a function says."""
    annotations = [each.annotation for each in (*node.args.args, *node.args.kwonlyargs)]
    return [ast.unparse(each) for each in (*annotations, node.returns) if each]


def room(module: str) -> str:
    """The package that a module lies in: `diagnosis.facts` is a room beside `diagnosis.fit`."""
    return module if PIPELINE.joinpath(*module.split(".")).is_dir() else module.rpartition(".")[0] or module


def handed_on(sources: dict[str, Path]) -> dict[str, set[str]]:
    """What rooms hand each other in bare dictionaries, each with the modules that take it."""
    texts = {name: path.read_text("utf-8") for name, path in sources.items()}
    takes = {
        name: {imported_name.removeprefix("pipeline.") for imported_name in imported(path)}
        for name, path in sources.items()
    }
    hidden = {f"{name}.{alias}" for name, text in texts.items() for alias in aliases(text)}
    handed = set()
    for name, text in texts.items():
        others = frozenset(imported_name.rpartition(".")[2] for imported_name in takes[name] & hidden)
        handed |= {f"{name}.{each}" for each in bare(text, others)}
    used: dict[str, set[str]] = {}
    for name, text in texts.items():
        for full in handed:
            module, _, short = full.rpartition(".")
            by_module = module in takes[name] and f"{module.rpartition('.')[2]}.{short}" in text
            if room(module) != room(name) and (full in takes[name] or by_module):
                used.setdefault(full, set()).add(name)
    return used


def test_rooms_hand_each_other_types() -> None:
    sources = {".".join(path.relative_to(PIPELINE).with_suffix("").parts): path for path in PIPELINE.rglob("*.py")}
    used = handed_on({name.removesuffix(".__init__"): path for name, path in sources.items()})
    assert not {name: by for name, by in used.items() if name not in DOCUMENTS}, "give it a TypedDict or a dataclass"
    assert set(DOCUMENTS) <= set(used), "is handed to no other room any more: take it off the list"


def test_a_room_is_a_package_and_an_alias_hides_nothing() -> None:
    assert room("diagnosis.facts.loops") == "diagnosis.facts" != room("diagnosis.fit.locate")
    assert room("diagnosis.verdict") == "diagnosis"
    assert room("rig.effects") == "rig.effects" and room("adopt") == "adopt"
    assert bare("Row = dict[str, Any]\ndef a(x: Row) -> int: ...") == {"a"}
    assert bare("def a(x: list[Row]) -> int: ...", frozenset({"Row"})) == {"a"}
    assert not bare("def a(x: Rows) -> int: ...", frozenset({"Row"}))


def test_a_bare_dictionary_is_found() -> None:
    assert bare("def a(x: dict[str, Any]) -> int: ...") == {"a"}
    assert bare("class A:\n    x: list[dict[str, object]]\n") == {"A"}
    assert bare("class A:\n    def b(self) -> Mapping[str, Any]: ...\n") == {"A"}
    assert not bare("def _a(x: dict[str, Any]) -> int: ...\ndef b(x: dict[str, int]) -> int: ...")
