"""A mapping of a file with several axes: the shared keys and the keys of each axis, as one mapping an axis."""

import re
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.input.bare_columns import all_written_out
from ..ground.input.complaint import key_name, short

AXIS_NAME = re.compile(r"[a-z0-9][a-z0-9-]*")


def _with_keys(mapping: dict[str, object]) -> dict[str, object]:
    """A mapping whose channels are written out with keys, so that an axis can change some of them."""
    return {key: all_written_out(value) if key == "channels" else value for key, value in mapping.items()}


def _over(whole: Any, own: Any) -> Any:
    """An axis' keys laid over the shared ones."""
    if not isinstance(whole, dict) or not isinstance(own, dict):
        return own
    return {**whole, **{key: _over(whole.get(key), value) for key, value in own.items()}}


def _named(mapping: dict[str, object], string_id: str, path: Path) -> dict[str, object]:
    """A mapping with the name of the individual string; raises BadInput where it has none."""
    string = mapping.get("string")
    if not isinstance(string, dict):
        raise BadInput(path, "string", "is not there, and --string-id names one", "leave --string-id out")
    return {**mapping, "string": {**string, "id": string_id}}


def each_axis(mapping: dict[str, object], path: Path, string_id: str | None = None) -> dict[str, dict[str, object]]:
    """The mapping of each axis by its name, one without a name where there are no `axes`; raises BadInput.

    `string_id` goes before the one that all share; the string of each of several axes is called by its axis too.
    """
    shared = {key: value for key, value in mapping.items() if key != "axes"}
    if "axes" not in mapping:
        return {"": shared if string_id is None else _named(shared, string_id, path)}
    axes = mapping["axes"]
    if not isinstance(axes, dict) or not axes:
        mend = "write one name an axis, each with the keys of a mapping that it has for itself"
        raise BadInput(path, "axes", f"is {short(axes)}", mend)
    for name, own in axes.items():
        field = f"axes.{key_name(name)}"
        if not AXIS_NAME.fullmatch(str(name)):
            raise BadInput(path, field, "cannot end a run's name", "use lower-case letters, digits and -")
        if not isinstance(own, dict):
            raise BadInput(path, field, f"is {short(own)}", "write the keys that this axis has for itself")
        if wrong := {"run", "mended", "axes", "file"} & own.keys():
            raise BadInput(path, f"{field}.{min(wrong)}", "belongs to no axis", "remove it, or say it once for all")
    whole = {str(name): _over(_with_keys(shared), _with_keys(own)) for name, own in axes.items()}
    if string_id is None:
        return whole
    return {name: _named(axis, f"{string_id}-{name}", path) for name, axis in whole.items()}
