"""A new run like another: its `run.yaml` has the same string and rig, except for what the command line gives anew."""

import shlex
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.input.strict_yaml import read_yaml
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


def with_given(content: RunYaml, from_options: RunYaml, source: Path) -> RunYaml:
    """The content with the command line's values in place; raises BadInput for values of another string."""
    string: Any = content.get("string")
    for key, value in (from_options.get("string") or {}).items():
        if string is None or (key in ("id", "material") and value != string[key]):
            raise _of_another(key, str(value), string, _anew(content, from_options), source)
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
    mend = f"for that string leave {option} out; for another one of its size give, in place of --like: {anew}"
    return BadInput(option, f"string.{key}", problem, mend)


def _anew(content: RunYaml, from_options: RunYaml) -> str:
    """The options that make a run of another string with the sizes and the rig of the content."""
    own = from_options.get("string") or {}
    old_string = content.get("string")
    string = {**old_string, **own} if old_string else own
    values = {key: value for key, value in string.items() if key != "id"}
    values |= {"string_id": own.get("id"), **(content.get("rig") or {}), **(from_options.get("rig") or {})}
    if content.get("actuator", STRING_ACTUATORS[0]) != STRING_ACTUATORS[0]:
        values = {"actuator": content["actuator"], **values}
    words = {key: f"{value:g}" if isinstance(value, float) else str(value) for key, value in values.items() if value}
    return " ".join(f"--{key.replace('_', '-')} {shlex.quote(word)}" for key, word in words.items())
