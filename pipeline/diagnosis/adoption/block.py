"""The keys that adopting writes into the text of a `run.yaml`: put in, and taken out again; all other text stays."""

import json
import textwrap
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import yaml

from ...ground.errors import BadInput
from ...ground.input.strict_yaml import parse_yaml
from ...ground.input.yaml_value import end_of
from ...run.description import Included, parse_run
from ..document.content import Adoption
from ..fit.adopt import block

KEY, ORIGIN = "simulation", "adopted"


def with_block(text: str, entries: Sequence[Included | Adoption], named: str = KEY) -> str:
    """Text of a `run.yaml` with the key `named` replaced, or added at the end; all other text is kept.

    `text` must be one mapping of YAML; whether the result says what it should is for the caller to check.
    """
    root: Any = yaml.compose(text, Loader=yaml.SafeLoader)
    nodes = next(((key, value) for key, value in root.value if key.value == named), None)
    if root.flow_style:  # a run.yaml written as JSON
        written = json.dumps(entries, ensure_ascii=False)
        if nodes:
            return text[: nodes[1].start_mark.index] + written + text[nodes[1].end_mark.index :]
        first = root.start_mark.index + 1
        return f'{text[:first]}"{named}": {written}, {text[first:]}'
    newline = "\r\n" if "\r\n" in text else "\n"
    indent = " " * root.value[0][0].start_mark.column
    lines = textwrap.indent(block(entries, named).rstrip("\n"), indent).replace("\n", newline)
    if nodes:
        return text[: nodes[0].start_mark.index] + lines.lstrip() + text[end_of(nodes[1]) :]
    end = end_of(root.value[-1][1])
    if not text[:end].endswith("\n"):
        end = text.find("\n", end) + 1 or len(text)
    if not text[:end].endswith("\n"):  # the last line ends without one, and so does what comes after it
        return text[:end] + newline + lines
    return text[:end] + lines + newline + text[end:]


def adopted(text: str, entries: Sequence[Included], path: Path, origin: list[Adoption] | None = None) -> str:
    """The text with the entries; it is parsed to check that all else stays the same. Raises BadInput.

    `origin` is where they came from, as the run.yaml shall say it; an empty one replaces an older one only.
    """
    content = parse_yaml(text, path)
    keep = origin or (origin is not None and ORIGIN in content)
    wanted = {**content, KEY: entries, **({ORIGIN: origin} if keep else {})}

    def make() -> str:
        with_effects = with_block(text, entries)
        return with_block(with_effects, origin or [], ORIGIN) if keep else with_effects

    mend = f"put the block of simulation.yaml beside the diagnosis in its place by hand, under the key {KEY}"
    return _checked(make, wanted, path, "replaced", mend)


def without_block(text: str, named: str) -> str:
    """Text of a `run.yaml` without the key `named` and its value; unchanged where it has no such key.

    `text` must be one mapping of YAML; whether the result says what it should is for the caller to check.
    """
    root: Any = yaml.compose(text, Loader=yaml.SafeLoader)
    place = next((place for place, (key, _) in enumerate(root.value) if key.value == named), None)
    if place is None:
        return text
    key, value = root.value[place]
    start, end = key.start_mark.index, end_of(value)
    if root.flow_style:
        if place + 1 < len(root.value):
            return text[:start] + text[root.value[place + 1][0].start_mark.index :]
        before = end_of(root.value[place - 1][1]) if place else start
        return text[:before] + text[end:]
    start -= key.start_mark.column
    line, newline, rest = text[end:].partition("\n")
    if line.strip():  # a comment of somebody
        return text[:start] + line + newline + rest
    if newline or not start:
        return text[:start] + rest
    return text[:start].removesuffix("\n").removesuffix("\r")  # as before it: the last line ends without one


def bare(text: str, path: Path) -> str:
    """The text without the adopted keys; it is parsed to check that all else stays the same. Raises BadInput."""
    content = parse_yaml(text, path)
    wanted = {key: value for key, value in content.items() if key not in (KEY, ORIGIN)}
    mend = f"take the keys {KEY} and {ORIGIN} out by hand"
    return _checked(lambda: without_block(without_block(text, ORIGIN), KEY), wanted, path, "taken out", mend)


def _checked(make: Callable[[], str], wanted: dict[str, object], path: Path, done: str, mend: str) -> str:
    """The text that `make` gives, if it says what is wanted and describes a valid run; else raises BadInput."""
    try:
        new_text = make()
        right = parse_yaml(new_text, path) == wanted
    except (BadInput, yaml.YAMLError):
        right = False
    if not right:
        raise BadInput(path, KEY, f"stands where it cannot be {done} without changing other text", mend)
    parse_run(wanted, path)
    return new_text
