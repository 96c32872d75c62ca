"""One value of a YAML text is changed, or put in; all other text stays, comments too."""

import json
from collections.abc import Sequence
from typing import Any

import yaml

from .strict_yaml import write_yaml


def with_value(text: str, keys: Sequence[str], value: Any) -> str:
    """Text of YAML, one mapping, in which the key at the end of a path of keys holds `value`.

    Whether the result says what it should is for the caller to check: `*name` and `<<` are not followed.
    """
    node: Any = yaml.compose(text, Loader=yaml.SafeLoader)
    as_json = node.flow_style
    for depth, key in enumerate(keys):
        inner = next((each for name, each in node.value if name.value == key), None)
        missing = keys[depth + 1 :]
        if inner is None:
            return _put_in(text, node, f"{_word(key, as_json)}: {_word(_nested(missing, value), as_json)}")
        if not missing or not isinstance(inner, yaml.MappingNode):
            start = inner.start_mark.index
            gap = " " * (text[start - 1] == ":")  # of a key that holds nothing
            return f"{text[:start]}{gap}{_word(_nested(missing, value), as_json)}{text[end_of(inner) :]}"
        node = inner
    return text


def end_of(node: yaml.Node) -> int:
    """Where the text of a node ends, without the comments and empty lines after it."""
    if isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
        last = node.value[-1]
        return end_of(last[1] if isinstance(last, tuple) else last)
    return int(node.end_mark.index)


def _put_in(text: str, node: Any, entry: str) -> str:
    """The text with one more entry at the end of a mapping."""
    if node.flow_style:
        end = end_of(node.value[-1][1]) if node.value else node.start_mark.index + 1
        return f"{text[:end]}{', ' * bool(node.value)}{entry}{text[end:]}"
    newline = "\r\n" if "\r\n" in text else "\n"
    end = text.find("\n", end_of(node))
    end = len(text) if end < 0 else end
    before = text[:end].removesuffix("\r")
    return f"{before}{newline}{' ' * node.value[0][0].start_mark.column}{entry}{text[len(before) :]}"


def _nested(keys: Sequence[str], value: Any) -> Any:
    for key in reversed(keys):
        value = {key: value}
    return value


def _word(value: Any, as_json: bool) -> str:
    """A value on one line."""
    return json.dumps(value, ensure_ascii=False) if as_json else write_yaml([value], flow=True)[1:-1]
