"""The fields of a mapping that a person has left empty: all of them are named at once."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.input.complaint import key_name

MAY_BE_EMPTY = ("string.stiffness_n_per_mm", "string.id")


def refuse_empty(content: dict[Any, object], path: Path) -> None:
    """Raise BadInput that names every field of a mapping's sections that has no value, but for those that need none."""
    empty = list(_empty(content))
    if empty:
        each, are = ("each", "are") if len(empty) > 1 else ("it", "is")
        mend = f"fill {each} in, as the comment beside it says, then import again"
        raise BadInput(path, ", ".join(empty), f"{are} empty", mend)


def _empty(content: dict[Any, object], within: str = "") -> Iterator[str]:
    for key, value in content.items():
        name = f"{within}{key_name(key)}"
        if isinstance(value, dict):
            yield from _empty(value, f"{name}.")
        elif value is None and within and name not in MAY_BE_EMPTY:
            yield name
