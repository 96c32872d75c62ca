"""The diagnosis' own constants → docs/numbers.md: each number that decides a verdict, and what it means.

`python -m pipeline.diagnosis.words.numbers_page > docs/numbers.md` makes the page anew after a change of a number.
"""

import argparse
import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from ...ground.errors import program

ROOM = Path(__file__).resolve().parents[1]
SAYING = ("drawing", "words")  # rooms whose numbers decide no verdict
# modules of others that say or propose, keep memory small, or reckon a planned motion: their numbers decide none
DECIDE_NOTHING = (
    *("adopt", "aspects", "bounds", "closest", "covered", "design", "evidence", "expected", "explanations", "foretold"),
    *("legs", "loops", "mechanism_entries", "next_runs", "not_kept", "own_rate", "planned_motion", "prediction_band"),
    *("problem", "products", "recursions", "residual", "simulation", "rounded", "uncertainty", "verdict"),
    *("without_a_name", "without_last"),
)
HEAD = """# Numbers that decide a verdict

Made from the diagnosis itself by `python -m pipeline.diagnosis.words.numbers_page > docs/numbers.md`: edit the number
and the comment beside it in its module, not this page. What the most important ones mean for a reader, how they were
set, and how far verdicts move when one of them does: [diagnosis.md](diagnosis.md#numbers-that-decide).

Here stand the numbers that have a name at the top of a module, as the module has them. Not here are those that a
formula holds without a name, the threshold in a mechanism's own entry (`least_mark`), and the judge's learnt weights
(`judge.json`).
A name that ends in `_s`, `_hz`, `_mm` or `_k` has that unit. Several names in one line have their meanings in the same
order.
"""


@dataclass(frozen=True)
class Number:
    """A constant at the top of a module, or several on one line: names, values as written, and the comment."""

    names: str
    value: str
    meaning: str


def numbers(text: str) -> Iterator[Number]:
    """The constants of a module's source that are numbers; a comment stands beside the line or above it."""
    lines = text.splitlines()
    for node in ast.parse(text).body:
        if isinstance(node, ast.Assign) and _is_number(node.value):
            names = ast.unparse(node.targets[0]).strip("()")
            if re.fullmatch(r"[A-Z][A-Z0-9_]*(, [A-Z][A-Z0-9_]*)*", names):
                last, above = lines[(node.end_lineno or node.lineno) - 1], lines[node.lineno - 2]
                beside = last[node.end_col_offset or 0 :].partition("#")[2].partition("# fmt:")[0]
                meaning = beside or (above[1:] if above.startswith("#") else "")
                yield Number(names, _written(node.value), meaning.strip())


def _written(value: ast.expr) -> str:
    """A value as the module has it; several values side by side without brackets."""
    text = ast.unparse(value)
    return text[1:-1] if isinstance(value, ast.Tuple) else text


def _is_number(value: ast.expr) -> bool:
    """Whether a value is a number, or consists only of numbers."""
    if isinstance(value, ast.Constant):
        return isinstance(value.value, int | float) and not isinstance(value.value, bool)
    if isinstance(value, ast.Tuple):
        return bool(value.elts) and all(map(_is_number, value.elts))
    if isinstance(value, ast.Dict):
        return bool(value.values) and all(map(_is_number, value.values))
    if isinstance(value, ast.UnaryOp):
        return _is_number(value.operand)
    return (
        isinstance(value, ast.Call) and ast.unparse(value.func).startswith("np.") and all(map(_is_number, value.args))
    )


def by_module() -> dict[str, list[Number]]:
    """Numbers by module, those of the engine first, then those of each mechanism."""
    deciding = (path for path in sorted(ROOM.rglob("*.py")) if path.stem not in DECIDE_NOTHING)
    engine = (path for path in deciding if path.relative_to(ROOM).parts[0] not in ("mechanisms", *SAYING))
    paths = [*engine, *sorted((ROOM / "mechanisms").glob("*.py"))]
    listed = {str(path.relative_to(ROOM)): list(numbers(path.read_text(encoding="utf-8"))) for path in paths}
    return {name: constants for name, constants in listed.items() if constants}


def page() -> str:
    """All of docs/numbers.md."""
    parts = [HEAD]
    for name, constants in by_module().items():
        doc = ast.get_docstring(ast.parse((ROOM / name).read_text(encoding="utf-8"))) or ""
        rows = [
            f"| `{each.names}` | `{each.value}` | {each.meaning.replace('|', chr(92) + '|')} |" for each in constants
        ]
        first = doc.partition("\n")[0]
        parts += [
            f"## {name.removesuffix('.py').replace('/', ': ')}",
            "",
            first,
            "",
            "| name | value | what it means |",
        ]
        parts += ["|---|---|---|", *rows, ""]
    return "\n".join(parts)


@program
def main() -> None:
    """Command line: print the page."""
    argparse.ArgumentParser(prog="python -m pipeline.diagnosis.words.numbers_page", description=__doc__).parse_args()
    print(page(), end="")


if __name__ == "__main__":
    main()
