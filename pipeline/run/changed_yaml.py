"""A few values of a run's `run.yaml` are changed: the new text, checked; all other text of the file stays."""

import copy
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from ..ground.errors import BadInput
from ..ground.input.complaint import meant
from ..ground.input.strict_yaml import parse_yaml
from ..ground.input.yaml_value import with_value
from .description import parse_run
from .option_mend import entry_with
from .table.as_read import entry_as_read

SECTIONS = ("tare", "channels", "file", "tolerance", "string", "rig")  # what a mend of a message changes
Change = tuple[str, Any]  # a key such as channels.load_n.unit, and its new value


def exchanged(text: str, first: str, second: str, folder: Path) -> list[Change]:
    """The changes that exchange the columns of two channels of the run in a folder; raises BadInput."""
    path = folder / "run.yaml"
    run = parse_run(parse_yaml(text, path), path)
    columns: list[str | int] = []
    for name in (first, second):
        if name not in run.system.columns:
            raise BadInput("--exchange", name, "is not a known channel", f"use one of {', '.join(run.system.columns)}")
        column = run.channels[name].column if name in run.channels else entry_as_read(run, folder, name).get("column")
        columns.append(name if column is None else column)
    return [(f"channels.{first}.column", columns[1]), (f"channels.{second}.column", columns[0])]


def with_changes(text: str, changes: Sequence[Change], folder: Path) -> tuple[str, list[str]]:
    """The text of the run.yaml of a folder with the changes, and what they do, a sentence for each; BadInput.

    One that is there already is no change: where none is left, that is refused.
    """
    path = folder / "run.yaml"
    content, new_text, sentences = parse_yaml(text, path), text, []
    wanted = copy.deepcopy(content)
    for key, value in changes:
        keys = key.split(".")
        if keys[0] not in SECTIONS or (keys[0] == "tare") != (len(keys) == 1):
            problem = "is nothing that is changed here"
            raise BadInput(path, key, problem, f"{meant(keys[0], SECTIONS)}; as in tare, channels.load_n.unit")
        before = _at(content, keys)
        if before == value and type(before) is not bool:
            continue
        keys, value_there = _whole(wanted, keys, value, folder)
        new_text = _text_with(new_text, keys, value_there, path)
        wanted = _put(wanted, keys, value_there)
        was = "was not there" if before is None else f"was {before}"
        sentences.append(f"{key} is {value} now and {was}")
    if not sentences:
        words = ", ".join(f"{key}: {value}" for key, value in changes)
        raise BadInput(path, changes[0][0], f"says that already ({words})", "nothing is to be changed in it")
    try:
        right = parse_yaml(new_text, path) == wanted
    except BadInput:
        right = False
    if not right:
        raise _by_hand(path, changes)
    parse_run(wanted, path)
    return new_text, sentences


def _whole(content: Any, keys: list[str], value: Any, folder: Path) -> tuple[list[str], Any]:
    """Where a value goes: under its key, or with the whole entry of a channel that is not written out so far."""
    if keys[0] != "channels" or len(keys) < 3:
        return keys, value
    entries = content.get("channels") or {}
    name, own = keys[1], keys[2:]
    entry = entries.get(name)
    if isinstance(entry, dict):
        return keys, value
    if entry is None:
        entry = entry_as_read(parse_run(content, folder / "run.yaml"), folder, name)
        return keys[:2], {**entry, own[0]: value}
    return keys[:2], entry_with(own, value, entry, name)


def _text_with(text: str, keys: Sequence[str], value: Any, path: Path) -> str:
    try:
        return with_value(text, keys, value)
    except (yaml.YAMLError, AttributeError):  # it is no mapping, or has a list where a mapping must be
        raise _by_hand(path, [(".".join(keys), value)]) from None


def _by_hand(path: Path, changes: Sequence[Change]) -> BadInput:
    problem = "stands where it cannot be changed without changing other text"
    mend = "write it there by hand: " + ", ".join(f"{key}: {value}" for key, value in changes)
    return BadInput(path, changes[0][0], problem, mend)


def _at(content: Any, keys: Sequence[str]) -> Any:
    """The value at the end of a path of keys, None where there is none."""
    for key in keys:
        content = content.get(key) if isinstance(content, dict) else None
    return content


def _put(content: Any, keys: Sequence[str], value: Any) -> Any:
    """The content with a value at the end of a path of keys."""
    if not keys:
        return value
    inner = content if isinstance(content, dict) else {}
    return {**inner, keys[0]: _put(inner.get(keys[0]), keys[1:], value)}
