"""The first of pydantic's complaints about a file, as file, field and mend."""

import difflib
import math
import re
import reprlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from ..command import command
from ..errors import BadInput

LONGEST = 60
JSON_KEY = re.compile(r'^[ \t\[{]*"[^"\n]*"[ \t]*:', re.MULTILINE)
_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = _SHORT.maxlong = LONGEST
_SHORT.maxlevel = 2


def short(value: Any) -> str:
    """A value on one line of bounded length, however large or deep it is."""
    return _SHORT.repr(value)


def key_name(key: Any) -> str:
    """A key unchanged; or in quotes and cut, if it is long or cannot be printed."""
    text = str(key)
    return text if text.strip() and text.isprintable() and len(text) <= LONGEST else short(text)


def meant(key: str, keys: Iterable[str]) -> str:
    """The mend for a misspelt key: the nearest known key, or all of them."""
    close = difflib.get_close_matches(key[:LONGEST], list(keys), n=1)
    return f"did you mean {close[0]!r}?" if close else f"remove it; known are {', '.join(keys)}"


def _as_keys(where: tuple[Any, ...], section: type[BaseModel]) -> str:
    """The mend where keys and values are expected; a channel may also be the name of a column."""
    keys = f"write {key_name(where[-1])}: {{{', '.join(f'{key}: …' for key in section.model_fields)}}}"
    return f"{keys}, or the column's name alone" if where[0] == "channels" and len(where) == 2 else keys


def _beyond_limit(kind: str, value: Any, limits: Mapping[str, Any]) -> str:
    """Which limit a number goes beyond, as a lab says it; empty for another complaint."""
    if kind not in ("less_than_equal", "greater_than_equal"):
        return ""
    number = float(value) if isinstance(value, str) else value
    if isinstance(number, float) and not math.isfinite(number):
        return "must be a finite number"
    if kind == "less_than_equal":
        return f"must be {float(limits['le']):g} or less"
    least = float(limits["ge"])
    return f"must be {least:g} or more" if least <= 0.0 or number > 0.0 else "must be more than 0"


def bad_section(
    path: Path, error: ValidationError, whole: type[BaseModel], sections: Mapping[str, type[BaseModel]]
) -> BadInput:
    """First complaint about a file that `whole` describes, whose keys hold the sections."""
    complaints = error.errors(include_url=False)
    # A misspelt key is one mistake but two complaints: the unknown key says more than the missing one.
    complaint = next((candidate for candidate in complaints if candidate["type"] == "extra_forbidden"), complaints[0])
    where, kind, wrong_input = complaint["loc"], complaint["type"], complaint["input"]
    message = _beyond_limit(kind, wrong_input, complaint.get("ctx", {})) or complaint["msg"].removeprefix(
        "Value error, "
    )
    if not where:  # a check over several keys, whose message names its field
        field, _, rest = message.partition(": ")
        problem, _, mend = rest.partition("; ")
        return BadInput(path, field, problem, mend)
    if "column" in where[2:]:  # after it pydantic names the types that it tried
        where = where[:3]
    field = ".".join(key_name(part) for part in where if part != "[key]")
    section = sections.get(str(where[0]), whole) if len(where) > 1 else whole
    if kind == "extra_forbidden":
        return BadInput(path, field, "is not a known key", meant(str(where[-1]), section.model_fields))
    info = section.model_fields.get(str(where[-1]))
    hint = f" ({info.description})" if info is not None and info.description else ""
    if kind in ("model_type", "dict_type"):
        return BadInput(path, field, f"is {short(wrong_input)}, where keys and values belong", _as_keys(where, section))
    if kind == "missing":
        return BadInput(path, field, "is missing", f"add it{hint}")
    if kind == "value_error" and "; " in message:
        problem, _, mend = message.rpartition("; ")
        return BadInput(path, field, problem, mend)
    if wrong_input is None:
        return BadInput(path, field, "is empty", f"fill it in{hint}")
    if kind == "string_type" and isinstance(wrong_input, int | float):
        return BadInput(path, field, f"is the number {short(wrong_input)}, not text", f"put it in quotes{hint}")
    return BadInput(path, field, f"is {short(wrong_input)}: {message}", f"correct it{hint}")


def syntax_mend(text: str) -> str:
    """The mend for text that is not YAML, especially for a piece of JSON pasted into it."""
    if text.lstrip().startswith("{") or not JSON_KEY.search(text):
        return "check its indentation, colons and quotes"
    return (
        'JSON within YAML is the value of a key: write `"key": [...]` from the left margin, indent the lines after it, '
        f"and put no comma after its last bracket; for a diagnosis.json let {command('adopt')} do it"
    )
