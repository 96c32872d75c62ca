"""Modules of a folder that are found by being there, read as text, since importing some takes seconds."""

import ast
import re
from pathlib import Path
from typing import TypeVar

Said = TypeVar("Said")


def holding(folder: Path, line: str) -> tuple[str, ...]:
    """Names, sorted, of the modules of a folder with a line that begins with a regular expression.

    They are not imported.
    """
    files = (path for path in folder.glob("*.py") if path.stem.isidentifier())
    return tuple(sorted(path.stem for path in files if re.search(f"^{line}", path.read_text("utf-8"), re.M)))


def literal(tree: ast.Module, name: str, otherwise: Said) -> Said:
    """The value that a module gives to a name at its top, where that is a literal; else `otherwise`."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == name:
            value: Said = ast.literal_eval(node.value)
            return value
    return otherwise


def said_true(tree: ast.Module, name: str) -> frozenset[str]:
    """The arguments that are True in the call that a module gives to a name at its top; none where it gives none."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == name and isinstance(node.value, ast.Call):
            return frozenset(each.arg for each in node.value.keywords if each.arg and ast.unparse(each.value) == "True")
    return frozenset()
