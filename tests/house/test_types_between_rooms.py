"""What one room hands to another has a type of its own; a bare `dict[str, Any]` is somebody else's document."""

import ast
import re
from pathlib import Path

from imported import imported

PIPELINE = Path(__file__).parents[2] / "pipeline"
BARE = re.compile(r"(dict|Mapping)\[str, (Any|object)\]")
# whose form another program or a person decides: it is read where it comes in, and made a type there
DOCUMENTS = {
    "foreign.axes.each_axis": "a mapping that a person writes",
    "new_run.make_run": "run.yaml",
    "rig.effects.make": "an effect's parameters, of its own kinds",
    "run.copied_run.as_in": "run.yaml",
    "run.copied_run.with_given": "run.yaml",
    "run.option_mend.by_option": "run.yaml",
}


def bare(source: str) -> set[str]:
    """Public functions and classes of a module that take, give or hold a dictionary without a type."""
    found = set()
    for node in ast.parse(source).body:
        if isinstance(node, ast.FunctionDef):
            said = said_by(node)
        elif isinstance(node, ast.ClassDef):
            public = [each for each in node.body if isinstance(each, ast.FunctionDef) and not each.name.startswith("_")]
            fields = [ast.unparse(each.annotation) for each in node.body if isinstance(each, ast.AnnAssign)]
            said = [*fields, *(word for each in public for word in said_by(each))]
        else:
            continue
        if not node.name.startswith("_") and BARE.search(" ".join(said)):
            found.add(node.name)
    return found


def said_by(node: ast.FunctionDef) -> list[str]:
    """The types that a function says."""
    annotations = [each.annotation for each in (*node.args.args, *node.args.kwonlyargs)]
    return [ast.unparse(each) for each in (*annotations, node.returns) if each]


def room(module: str) -> str:
    return module.split(".")[0]


def test_rooms_hand_each_other_types() -> None:
    sources = {".".join(path.relative_to(PIPELINE).with_suffix("").parts): path for path in PIPELINE.rglob("*.py")}
    sources = {name.removesuffix(".__init__"): path for name, path in sources.items()}
    handed = {f"{name}.{each}" for name, path in sources.items() for each in bare(path.read_text("utf-8"))}
    used = set()
    for name, path in sources.items():
        text = path.read_text("utf-8")
        for given in (one.removeprefix("pipeline.") for one in imported(path)):
            if room(given) != room(name):
                used |= {one for one in handed if one == given}
                short = given.rpartition(".")[2]
                used |= {
                    one
                    for one in handed
                    if one.rpartition(".")[0] == given and f"{short}.{one.rpartition('.')[2]}" in text
                }
    assert used - set(DOCUMENTS) == set(), "give it a TypedDict or a dataclass"
    assert set(DOCUMENTS) <= used, "is handed to no other room any more: take it off the list"


def test_a_bare_dictionary_is_found() -> None:
    assert bare("def a(x: dict[str, Any]) -> int: ...") == {"a"}
    assert bare("class A:\n    x: list[dict[str, object]]\n") == {"A"}
    assert bare("class A:\n    def b(self) -> Mapping[str, Any]: ...\n") == {"A"}
    assert not bare("def _a(x: dict[str, Any]) -> int: ...\ndef b(x: dict[str, int]) -> int: ...")
