"""A new run like another: its `run.yaml` has the same string and rig, except for what the command line gives anew."""

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..ground.command import command, quoted
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import read_yaml, write_yaml
from .description import STRING_ACTUATORS
from .folder import read_run
from .run_yaml import RunYaml, StringYaml

OF_ONE_RUN = ("run", "mended", "tare")  # what a run.yaml says of its own recording alone
SECTIONS = ("string", "rig")


def as_in(folder: Path) -> RunYaml:
    """The content of a run's `run.yaml` without the keys of that one recording, its string named; raises BadInput.

    The strokes that the string had done are left out too: runs of one string are counted on.
    """
    run = read_run(folder)
    content: Any = {key: value for key, value in read_yaml(folder / "run.yaml").items() if key not in OF_ONE_RUN}
    if run.string is not None:
        string = {key: value for key, value in content["string"].items() if key != "strokes_before"}
        content["string"] = string | {"id": run.string_id}
    return content


def of_another_string(folder: Path, name: str) -> str:
    """The command that describes a new run of another string, of the size and on the rig of a run; raises BadInput.

    The new run and its string have one `name`.
    """
    own: RunYaml = {"run": name, "string": {"id": name}}
    return _anew(as_in(folder), own, {})


def with_given(
    content: RunYaml, from_options: RunYaml, source: Path, files: Mapping[str, Path | None] | None = None
) -> RunYaml:
    """The content with the command line's values in place; raises BadInput for values of another string.

    `files` are the options of files and folders that were given, for the command that makes that string's run.
    """
    string: Any = content.get("string")
    for key, value in (from_options.get("string") or {}).items():
        if string is None or (key in ("id", "material") and value != string[key]):
            raise _of_another(key, str(value), string, _anew(content, from_options, files or {}), source)
    old: dict[str, Any] = {**content}
    new: dict[str, Any] = {**from_options}
    new_content: Any = (
        {"run": from_options["run"]} | old | {key: value for key, value in new.items() if key not in SECTIONS}
    )
    for section in SECTIONS:
        if new.get(section):
            new_content[section] = (old.get(section) or {}) | new[section]
    return new_content


def _of_another(key: str, value: str, string: StringYaml | None, anew: str, source: Path) -> BadInput:
    """The error that a name or material was given that the string of run `source` does not have."""
    option, like = f"--{'string-id' if key == 'id' else key.replace('_', '-')}", f"--like {source}"
    if string is None:
        return BadInput(option, f"string.{key}", f"is {value}, but {like} has no string", f"leave {option} out")
    problem = f"is {value}, but {like} is of the string {string['id']}, of {string['material']}"
    mend = f"for that string leave {option} out; for another one of its size: {anew}"
    return BadInput(option, f"string.{key}", problem, mend)


def _anew(content: RunYaml, from_options: RunYaml, files: Mapping[str, Path | None]) -> str:
    """The command that makes the run of another string, with the sizes, the rig and the columns of the content."""
    own = from_options.get("string") or {}
    old_string = content.get("string")
    string = {**old_string, **own} if old_string else own
    values = {key: value for key, value in string.items() if key != "id"}
    values |= {"string_id": own.get("id"), **(content.get("rig") or {}), **(from_options.get("rig") or {})}
    if content.get("actuator", STRING_ACTUATORS[0]) != STRING_ACTUATORS[0]:
        values = {"actuator": content["actuator"], **values}
    values |= {"tare": from_options.get("tare"), **files}
    words = {key: f"{value:g}" if isinstance(value, float) else str(value) for key, value in values.items() if value}
    options = [f"--{key.replace('_', '-')} {shlex.quote(word)}" for key, word in words.items()]
    sections: dict[str, Any] = {**content, **from_options}
    in_yaml = {key: sections[key] for key in ("file", "channels", "tolerance") if sections.get(key)}
    options += [f"--{key} {quoted(write_yaml(section, flow=True))}" for key, section in in_yaml.items()]
    return " ".join([command("new_run"), shlex.quote(str(from_options["run"])), *options])
