"""Settings of a model: a frozen dataclass whose fields carry their bounds, checked when it is made.

A model declares `bins: Annotated[int, Field(ge=1, le=128)] = 16`; what is outside, of another type or unknown is a
`pydantic.ValidationError`, which is a ValueError, whether it comes from a command line or from a saved model.
"""

import dataclasses
import json
import math
from collections.abc import Mapping
from typing import Annotated, Any, TypeVar, dataclass_transform

import pydantic
from pydantic import ConfigDict, Field, JsonValue, ValidationError
from pydantic.dataclasses import dataclass

Class = TypeVar("Class")

Width = Annotated[int, Field(ge=1, le=2048)]  # neurons of a layer
Layers = Annotated[int, Field(ge=1, le=16)]
Blocks = Annotated[int, Field(ge=1, le=64)]
Epochs = Annotated[int, Field(ge=1, le=100_000)]
Batch = Annotated[int, Field(ge=1, le=1_000_000)]  # points
Rate = Annotated[float, Field(ge=0, le=1)]  # of learning
Clamp = Annotated[float, Field(gt=0, le=20)]
Drawn = Annotated[int, Field(ge=0, lt=2**32)]  # a seed
SHOWN = 80  # characters of a wrong value


@dataclass_transform(frozen_default=True, field_specifiers=(Field,))
def checked(settings: type[Class]) -> type[Class]:
    """A class of settings whose bounds, types and names are checked when it is made."""
    checked_class: Any = dataclass(frozen=True, config=ConfigDict(extra="forbid", strict=True, allow_inf_nan=False))(
        settings
    )
    return checked_class


def values(settings: Any) -> dict[str, JsonValue]:
    """Settings as plain values for a file."""
    return dataclasses.asdict(settings)


class Refused(ValueError):
    """Settings that a model does not take: `field` is the setting, `problem` and `mend` say the rest."""

    def __init__(self, field: str, problem: str, mend: str) -> None:
        super().__init__(f"{field}: {problem}")
        self.field, self.problem, self.mend = field, problem, mend


def told(text: str) -> dict[str, JsonValue]:
    """Settings written as a JSON object; raises Refused for anything else, or a setting that stands twice."""

    def once(pairs: list[tuple[str, JsonValue]]) -> dict[str, JsonValue]:
        twice = [name for place, (name, _) in enumerate(pairs) if name in dict(pairs[:place])]
        if twice:
            raise Refused(shown(twice[0]), "stands twice", "keep one of the two")
        return dict(pairs)

    mend = 'write a JSON object, such as {"epochs": 30}'
    try:
        settings = json.loads(text, object_pairs_hook=once)
    except Refused:
        raise
    except (ValueError, RecursionError) as error:
        raise Refused("JSON", f"cannot be read ({shown(str(error))})", mend) from None
    if not isinstance(settings, dict):
        raise Refused("JSON", f"is {shown(text)}, not an object", mend)
    return settings


def refusal(
    error: ValidationError | TypeError, settings: type | None, settings_given: Mapping[str, JsonValue]
) -> Refused:
    """The complaint of a model's class on its settings; `settings` is its dataclass, None if it has none."""
    if settings is None:
        return Refused(
            shown(next(iter(settings_given), "settings")), "is no setting: this model has none", "leave it out"
        )
    can: dict[str, Any] = pydantic.TypeAdapter(settings).json_schema()["properties"]
    if isinstance(error, TypeError):
        return Refused("settings", shown(str(error)), f"use {', '.join(can)}")
    complaint = error.errors(include_url=False)[0]
    field = str(complaint["loc"][0]) if complaint["loc"] else "settings"
    if field not in can:
        return Refused(shown(field), "is no setting of this model", f"use {', '.join(can)}")
    problem = f"is {shown(repr(complaint['input']))}: {complaint['msg'].removeprefix('Value error, ')}"
    return Refused(field, problem, f"give {_words(can[field])}")


def shown(text: str) -> str:
    """A text cut to what fits a line."""
    return text if len(text) <= SHOWN else f"{text[:SHOWN]}…"


def _words(schema: dict[str, Any]) -> str:
    """The allowed values of a setting, from its JSON schema."""
    if "enum" in schema:
        return " or ".join(f'"{value}"' for value in schema["enum"])
    if schema.get("type") == "array":
        return f"a list, each item {_words(schema.get('items', {}))}"
    kind = {"integer": "a whole number", "number": "a number", "boolean": "true or false"}.get(
        schema.get("type", ""), "text"
    )
    low, high = schema.get("minimum"), schema.get("maximum", schema.get("exclusiveMaximum", math.inf))
    if low is not None:
        return f"{kind} from {low:g} to {high:g}"
    return f"{kind} above {schema['exclusiveMinimum']:g}, at most {high:g}" if "exclusiveMinimum" in schema else kind
