"""A JSON recording: one object a line, a list of objects, or an object of lists, wherever in it they stand."""

import contextlib
import itertools
import json
import sys
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.input.complaint import short
from ..ground.input.text_file import TextFile
from .interface import Columns, Format
from .nested import columns_of, records
from .unpacked import unpacked

LARGEST = 200_000_000  # bytes: Python needs some ten times as much to hold them as values
SMALLER = "save it as CSV or Parquet, or cut it into runs"
LOOK = 20  # lines at the start by which a file of one object a line is told
SPLIT = {"columns", "data"}  # what pandas calls names and rows


class _Twice(ValueError):
    """A name that stands twice in one object."""


def _once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    entries = dict(pairs)
    if len(entries) < len(pairs):
        names = [name for name, _ in pairs]
        raise _Twice(next(name for name in names if names.count(name) > 1))
    return entries


def _parsed(text: str, path: Path, field: str) -> Any:
    """The value of a JSON text; raises BadInput where it is none, and json.JSONDecodeError."""
    try:
        return json.loads(text, object_pairs_hook=_once)
    except _Twice as error:
        raise BadInput(path, field, f"says {short(str(error))} twice in one object", "keep one of the two") from None
    except RecursionError:
        raise BadInput(path, field, "is nested too deep", "check its brackets") from None


def _has_lines(text: str) -> bool:
    """Whether one of the first lines is an object by itself, so that the file has one a line."""
    for line in itertools.islice((line for line in text.splitlines() if line.strip()), LOOK):
        with contextlib.suppress(ValueError, RecursionError):
            if isinstance(json.loads(line), dict):
                return True
    return False


def _lines(text: str, path: Path) -> list[Any]:
    """Values of one a line. A last line that was cut off is left out, which is said; raises BadInput for another."""
    lines = text.splitlines()
    rows = []
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            rows.append(_parsed(line, path, f"line {number}"))
        except ValueError as error:
            if number == len(lines) and rows:
                print(f"{path}: its last line, {short(line.strip())}, is cut off and was left out", file=sys.stderr)
                break
            problem = f"is no JSON ({str(error)[:80]}): {short(line.strip())}"
            raise BadInput(path, f"line {number}", problem, "remove that line") from None
    return rows


def read_json(path: Path, layout: TextFile) -> Columns:
    """Series of a JSON file under the paths to them, such as `samples.motor` or `x[0]`; raises BadInput."""
    try:
        text = unpacked(path, LARGEST, SMALLER).decode("utf-8-sig" if layout.encoding == "utf-8" else layout.encoding)
    except (UnicodeError, LookupError):
        mend = "set file.encoding, latin1 for instance"
        raise BadInput(path, "file.encoding", f"is not {layout.encoding}", mend) from None
    if not text.strip():
        raise BadInput(path, "file", "is empty", "record again; nothing was written by the logger")
    try:
        value = _parsed(text, path, "file")
    except ValueError as error:
        if not _has_lines(text):
            mend = "copy it again from the logger; a file that was cut off cannot be read"
            raise BadInput(path, "file", f"is not JSON ({str(error)[:80]})", mend) from None
        value = _lines(text, path)
    if isinstance(value, dict) and value.keys() >= SPLIT and isinstance(value["columns"], list):
        rows = value["data"] if isinstance(value["data"], list) else []
        names = [str(name) for name in value["columns"]]
        value = [dict(zip(names, row, strict=False)) for row in rows if isinstance(row, list)]
    if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
        plain = records(value)
        if any(len(values) > 1 for values in plain.values()):
            return {**dict(columns_of(value)), **plain}
    return dict(columns_of(value))


FORMAT = Format("a JSON file", (".json", ".jsonl", ".ndjson"), (b'{"', b"[{", b"[["), frozenset(), read_json)
