"""A new run like another: its `run.yaml` says the same string on the same rig, but for what is given anew."""

from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.strict_yaml import read_yaml
from .folder import read_run

OF_ONE_RUN = ("run", "mended", "tare")  # what a run.yaml says of its own recording alone
SECTIONS = ("string", "rig")


def as_in(folder: Path) -> dict[str, Any]:
    """The content of a run's `run.yaml` without what it says of that one recording, its string named; raises BadInput.

    The strokes that the string had done are left out too: runs of one string are counted on.
    """
    run = read_run(folder)
    content = {key: value for key, value in read_yaml(folder / "run.yaml").items() if key not in OF_ONE_RUN}
    if run.string is not None:
        string = {key: value for key, value in content["string"].items() if key != "strokes_before"}
        content["string"] = string | {"id": run.string_id}
    return content


def with_given(content: dict[str, Any], given: dict[str, Any], source: Path) -> dict[str, Any]:
    """The content with what the command line gave in its place; raises BadInput for a string that is another's."""
    string = content.get("string")
    for key, value in (given.get("string") or {}).items():
        if string is None or (key in ("id", "material") and value != string[key]):
            known = "has no string" if string is None else f"is of the string {string['id']!r}, {string['material']}"
            mend = f"leave out --like {source} and give all dimensions, or leave out what is given of the string"
            raise BadInput(source, f"string.{key}", known, mend)
    made = {"run": given["run"]} | content | {key: value for key, value in given.items() if key not in SECTIONS}
    for section in SECTIONS:
        if given.get(section):
            made[section] = (content.get(section) or {}) | given[section]
    return made
