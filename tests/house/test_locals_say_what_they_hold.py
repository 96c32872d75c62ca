"""A local is called after what it holds: words that would fit any value are no names."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
STRANGERS = ROOT / "pipeline" / "rig" / "authors"  # by other hands, each in words of its own
WORDS = {"one", "found", "told", "asked", "said", "here", "there", "those", "it", "some"}
FILLERS = {"known", "held", "left", "given", "made"}  # strangers may use them


def held_by(source: str) -> set[str]:
    """Words that a module gives to locals, arguments, or functions within functions."""
    tree, named = ast.parse(source), set()
    fields = {item.target for node in ast.walk(tree) if isinstance(node, ast.ClassDef) for item in node.body
              if isinstance(item, ast.AnnAssign)}  # fmt: skip
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node not in fields:
            named.add(node.id)
        elif isinstance(node, ast.arg):
            named.add(node.arg)
        elif isinstance(node, ast.FunctionDef):
            named |= {inner.name for inner in ast.walk(node) if isinstance(inner, ast.FunctionDef) and inner != node}
    return named & (WORDS | FILLERS)


@pytest.mark.parametrize(("folder", "at_least"), [("pipeline", 600), ("tests", 400)])
def test_a_local_says_what_it_holds(folder: str, at_least: int) -> None:
    words_of = {path: held_by(path.read_text("utf-8")) for path in ROOT.joinpath(folder).rglob("*.py")}
    named = {
        f"{path.relative_to(ROOT).as_posix()}: {word}" for path, words in words_of.items() for word in words
        if word in WORDS or not path.is_relative_to(STRANGERS)
    }  # fmt: skip
    assert len(words_of) > at_least
    assert named == set(), "call it after what it holds"


def test_a_word_is_found_wherever_a_name_is_given() -> None:
    assert held_by("def a():\n    one = 1\n") == {"one"}
    assert held_by("def a(found): ...") == {"found"} and held_by("known = 1") == {"known"}
    assert held_by("[some for some in x]\nlambda told: told\nwith x as there: ...\nif (it := 1): ...") == {
        "some", "told", "there", "it",
    }  # fmt: skip
    assert held_by("def a():\n    def said(): ...\n") == {"said"}
    assert not held_by("def told(): ...\nvalue.one = 1\nprint(found)\nf(asked=1)\nclass A:\n    said: str\n")
