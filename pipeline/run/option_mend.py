"""A mend for the command line, where the `run.yaml` that it names is not there yet."""

import ast
import copy
import re
from typing import Any

from ..ground.bare_columns import written_out
from ..ground.command import quoted
from ..ground.errors import BadInput
from ..ground.strict_yaml import write_yaml
from .run_yaml import RunYaml

KEY = re.compile(r"\b(channels|file|tolerance)\.(\w+(?:\.\w+)?)")  # of run.yaml, in a mend
VALUE = re.compile(r""" to ('[^'\n]*'|"[^"\n]*"|-?\d+(?:\.\d+)?)""")  # behind it, where the mend knows the value


def by_option(error: BadInput, content: RunYaml) -> BadInput:
    """The error with a mend for the command line, where its mend names a key of a run.yaml that is not there yet.

    The option in it has all that `content` has for it too: what is typed as it stands replaces what was given.
    """
    named = KEY.search(error.mend)
    if named is None:
        return error
    sections: dict[str, Any] = {**content}
    section, whole = named[1], copy.deepcopy(sections.get(named[1]) or {})
    end = error.mend.find("; ", named.end())
    mend, rest = (error.mend, "") if end < 0 else (error.mend[:end], error.mend[end:])
    for match in KEY.finditer(mend):
        key, *own = match[2].split(".")
        if match[1] == section:
            to = VALUE.match(mend, match.end())
            value = ast.literal_eval(to[1]) if to else "…"  # a gap where the mend names no value
            whole[key] = _with_value(own, value, whole.get(key) or {}, key)
    option = f"here by --{section} {quoted(write_yaml(whole, flow=True))}"
    return BadInput(error.file, error.field, error.problem, f"{mend.removesuffix(' in run.yaml')}: {option}{rest}")


def _with_value(own: list[str], value: Any, old_entry: Any, key: str) -> Any:
    """What stands under a key, with the value that is to be given: as all of it, or under its own key `own`."""
    new_entry = written_out(key, old_entry) if own else {}
    if own == ["column"] and not new_entry.keys() - {"column"}:
        own = []  # a column's name alone says it
    return {**new_entry, own[0]: value} if own else value
