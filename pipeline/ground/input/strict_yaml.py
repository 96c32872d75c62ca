"""The one reader of YAML files: unclear, doubled or endless content is refused, never guessed.

Plain words are read as YAML 1.2 does: `yes`, `5:00` and a date are text. What YAML 1.1 and 1.2 read as different
numbers, such as `0300`, is refused.
"""

import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from ..errors import BadInput
from ..stored.regular_file import read_regular
from .complaint import syntax_mend

LARGEST = 1_000_000  # bytes of a file, and characters of it with its aliases written out
DEEPEST = 30
LONGEST_NUMBER = 40
WORDS: dict[str, bool | None] = {
    **{word: None for word in ("", "~", "null", "Null", "NULL")},
    **{word: True for word in ("true", "True", "TRUE")},
    **{word: False for word in ("false", "False", "FALSE")},
}
INTEGER = re.compile(r"[-+]?[0-9]+")
BASED = re.compile(r"0o[0-7]+|0x[0-9a-fA-F]+")
FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
LEADING_ZERO = re.compile(r"[-+]?0[0-9]+")
PARSER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # both give the same events; C's is ten times as fast


class Unclear(ValueError):
    """A value that is refused, as `problem; mend`."""


def plain_value(text: str) -> str | int | float | bool | None:
    """The value of a plain word of YAML; raises Unclear for a number that is not finite, too long or ambiguous."""
    if text in WORDS:
        return WORDS[text]
    number = next((kind for kind in (INTEGER, BASED, FLOAT) if kind.fullmatch(text)), None)
    if number is None:
        if NOT_FINITE.fullmatch(text):
            raise Unclear(f"{text} is no finite number; write the number that was measured, or leave it out")
        return text
    if len(text) > LONGEST_NUMBER:
        raise Unclear(
            f"is a number of {len(text)} characters; write it with 17 digits or fewer, or in quotes if a name"
        )
    if LEADING_ZERO.fullmatch(text):
        plain = int(text)
        raise Unclear(f"{text} is a number with a leading zero; write {plain}, or put it in quotes if it is a name")
    if number is not FLOAT:
        return int(text, 10 if number is INTEGER else 0)
    value = float(text)
    if math.isinf(value) or (value == 0.0 and re.search("[1-9]", re.split("[eE]", text)[0])):
        raise Unclear(f"{text} is a number that no computer holds; correct its exponent")
    return value


@dataclass
class _Node:
    """A list or mapping under construction, with the size of its content."""

    value: Any
    anchor: str | None
    size: int = 0
    key: Any = None
    has_key: bool = False


class _Reader:
    """Values from YAML's events, one document, without recursion."""

    def __init__(self, path: Path) -> None:
        self.path, self.line = path, 0
        self.open: list[_Node] = []
        self.anchors: dict[str, tuple[Any, int]] = {}
        self.documents, self.result = 0, None

    def refuse(self, problem: str, mend: str) -> BadInput:
        """BadInput at the line that is being read."""
        return BadInput(self.path, f"line {self.line}", problem, mend)

    def put(self, value: Any, size: int, scalar: bool) -> None:
        """Put a finished value in its place: into the open list or mapping, or as the whole document."""
        if not self.open:
            self.result = value
            return
        node = self.open[-1]
        node.size += size
        if node.size > LARGEST:
            raise self.refuse(
                "is huge once its aliases are written out", "write the values themselves, without & and *"
            )
        if isinstance(node.value, list):
            node.value.append(value)
        elif node.has_key:
            node.value[node.key] = value
            node.has_key = False
        else:
            if not scalar or isinstance(value, bool | float) or value is None:
                raise self.refuse("has a key that is no name", "write a name before the colon, in quotes if need be")
            if value in node.value:
                raise self.refuse(f"says {value!r} a second time", "keep one of the two")
            node.key, node.has_key = value, True

    def scalar(self, event: yaml.ScalarEvent) -> None:
        """Read a word."""
        try:
            value = event.value if event.style else plain_value(event.value)
        except Unclear as error:
            problem, _, mend = str(error).partition("; ")
            keyed = self.open and self.open[-1].has_key
            raise self.refuse(f"{self.open[-1].key}: {problem}" if keyed else problem, mend) from None
        size = len(event.value) + 1
        if event.anchor:
            self.anchors[event.anchor] = (value, size)
        self.put(value, size, scalar=True)

    def alias(self, name: str | None) -> None:
        """Read `*name`: the value that `&name` marks, if that is complete."""
        if name is None or name not in self.anchors:
            raise self.refuse(f"*{name} stands for nothing, or for what it stands in", "write the value itself")
        value, size = self.anchors[name]
        self.put(value, size, scalar=not isinstance(value, list | dict))

    def take(self, event: yaml.Event) -> None:
        """Read the next event."""
        self.line = event.start_mark.line + 1 if event.start_mark else self.line
        tag = getattr(event, "tag", None)
        if tag is not None:
            raise self.refuse(f"carries the tag {tag!r}", "remove it; no value needs a tag")
        if isinstance(event, yaml.DocumentStartEvent):
            self.documents += 1
            if self.documents > 1:
                raise self.refuse("begins a second document", "keep one; remove the line ---")
        elif isinstance(event, yaml.ScalarEvent):
            self.scalar(event)
        elif isinstance(event, yaml.AliasEvent):
            self.alias(event.anchor)
        elif isinstance(event, yaml.SequenceStartEvent | yaml.MappingStartEvent):
            if len(self.open) == DEEPEST:
                raise self.refuse(f"is nested more than {DEEPEST} deep", "check its brackets and its indentation")
            self.anchors.pop(event.anchor or "", None)
            self.open.append(_Node([] if isinstance(event, yaml.SequenceStartEvent) else {}, event.anchor))
        elif isinstance(event, yaml.SequenceEndEvent | yaml.MappingEndEvent):
            node = self.open.pop()
            if node.anchor:
                self.anchors[node.anchor] = (node.value, node.size)
            self.put(node.value, node.size + 1, scalar=False)


def read_yaml(path: Path) -> Any:
    """Content of a YAML file: dicts, lists, text, numbers, booleans and None; an empty file is None.

    Raises BadInput with the file, the line and the mend for what is no plain UTF-8 file of one YAML document, a key
    twice, a tag, nesting over 30 deep, a number that is unclear, or more than 1 MB, aliases written out.
    """
    try:
        text = read_regular(path, LARGEST, path.name).decode("utf-8")
    except UnicodeDecodeError:
        raise BadInput(path, path.name, "is not UTF-8 text", "save it as UTF-8") from None
    return parse_yaml(text, path)


def parse_yaml(text: str, where: Path) -> Any:
    """Content of YAML text that stands in the file, or was given as the option, `where`; raises BadInput as above."""
    reader = _Reader(where)
    try:
        for event in yaml.parse(text, PARSER):
            reader.take(event)
    except (yaml.YAMLError, UnicodeEncodeError) as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}" if mark else where.name
        raise BadInput(where, place, "is not YAML", syntax_mend(text)) from None
    return reader.result


class _Dumper(yaml.SafeDumper):
    """YAML's writer, which quotes the text that `plain_value` would read as something else."""


def _text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    try:
        plain = isinstance(plain_value(text), str)
    except Unclear:
        plain = False
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, None if plain else "'")


_Dumper.add_representer(str, _text)


def write_yaml(content: Any, flow: bool = False) -> str:
    """Text of YAML that `read_yaml` reads back as `content`, in the order given; `flow`: in braces, on one line."""
    how: dict[str, Any] = {"default_flow_style": True, "width": math.inf} if flow else {}
    return yaml.dump(content, Dumper=_Dumper, sort_keys=False, allow_unicode=True, **how).rstrip("\n" if flow else "")
