"""A mend as a command, where the `run.yaml` that the mend names does not exist yet, or a file is to be imported."""

import ast
import copy
import re
import shlex
from pathlib import Path
from typing import Any

from ..ground.command import command, quoted
from ..ground.errors import BadInput
from ..ground.input.bare_columns import written_out
from ..ground.input.strict_yaml import write_yaml
from ..ground.units import UNITS
from .run_yaml import RunYaml

KEY = re.compile(r"\b(channels|file|tolerance)\.(\w+(?:\.\w+)?)")  # of run.yaml, in a mend
EXCHANGE = re.compile(r"exchange the columns of (\w+) and (\w+)")  # in a mend
GAP = "…"  # where a mend names no value
UNIT = rf"(?:{'|'.join(map(re.escape, UNITS))})(?=[,.;]|$)"  # without quotation marks, and the last word on it
VALUE = re.compile(
    rf""" to (?:('[^'\n]*'|"[^"\n]*"|-?\d+(?:\.\d+)?)|({UNIT}))"""
)  # behind a key, where the mend knows the value
DOUBT = "find out which: "  # before units of which one alone is right
READING = ("file", "channels")  # the options that say how a log is read, each of no use without the other


def by_option(error: BadInput, content: RunYaml) -> BadInput:
    """The error with its mend as an option, where the mend names a key of a run.yaml that does not exist yet.

    The option in it has all that `content` has for it too: what is typed as it stands replaces what was given. Of
    `--file` and `--channels` the other one stands beside it where it was given.
    """
    change = _section(error.mend, content) or _exchange(error.mend, content)
    if change is None:
        return error
    section, whole, mend, rest = change
    sections: dict[str, Any] = {**content, section: whole}
    names = [section, *(name for name in READING if section in READING and name != section and content.get(name))]
    option = "here by " + " ".join(f"--{name} {quoted(write_yaml(sections[name], flow=True))}" for name in names)
    return BadInput(error.file, error.field, error.problem, f"{mend.removesuffix(' in run.yaml')}: {option}{rest}")


def import_command(content: RunYaml, recording: Path, name: str, out: Path) -> str:
    """What a person types to import a recording as run `name` in the folder `out`, as a run.yaml's content reads it."""
    mapping = {key: value for key, value in content.items() if key not in ("run", "mended")}
    file = f"{name}-map.yaml"
    words = f"{shlex.quote(str(recording))} --map {file} --run {name}"
    place = "" if out == Path("raw") else f" --out {shlex.quote(str(out))}"
    return f"echo {quoted(write_yaml(mapping, flow=True))} > {file} && {command('import_run')} {words}{place}"


def values_told(mend: str) -> list[tuple[str, Any]]:
    """The keys of run.yaml that a mend names, each with the value that it is to be set to, `…` where none is told."""
    return [(match[0], _value(mend, match)) for match in KEY.finditer(mend)]


def _value(mend: str, key: re.Match[str]) -> Any:
    to = VALUE.match(mend, key.end())
    if to is None or (to[2] and DOUBT in mend and len(KEY.findall(mend)) > 1):
        return GAP
    return to[2] or ast.literal_eval(to[1])


def _section(mend: str, content: RunYaml) -> tuple[str, dict[str, Any], str, str] | None:
    """The section that a mend changes, that section after the change, and the mend's text before and after it."""
    named = KEY.search(mend)
    if named is None:
        return None
    sections: dict[str, Any] = {**content}
    section, whole = named[1], copy.deepcopy(sections.get(named[1]) or {})
    end = mend.find("; ", named.end())
    mend, rest = (mend, "") if end < 0 else (mend[:end], mend[end:])
    for match in KEY.finditer(mend):
        key, *own = match[2].split(".")
        if match[1] == section:
            value = _value(mend, match)
            whole[key] = entry_with(own, value, whole.get(key) or {}, key)
    return section, whole, mend, rest


def _exchange(mend: str, content: RunYaml) -> tuple[str, dict[str, Any], str, str] | None:
    """The section of the channels with the columns of two of them exchanged, where a mend asks for that; as above."""
    pair = EXCHANGE.search(mend)
    sections: dict[str, Any] = {**content}
    channels: dict[str, Any] = copy.deepcopy(sections.get("channels") or {})
    if pair is None or not channels.keys() >= set(pair.groups()):
        return None
    columns = [written_out(name, channels[name]).get("column", name) for name in pair.groups()]
    for name, column in zip(pair.groups(), reversed(columns), strict=True):
        channels[name] = entry_with(["column"], column, channels[name], name)
    return "channels", channels, mend, ""


def entry_with(own: list[str], value: Any, old_entry: Any, key: str) -> Any:
    """The entry of a key with a new value: as the whole entry, or under the entry's own key `own`."""
    new_entry = written_out(key, old_entry) if own else {}
    if own == ["column"] and not new_entry.keys() - {"column"}:
        own = []  # a column's name alone says it
    return {**new_entry, own[0]: value} if own else value
