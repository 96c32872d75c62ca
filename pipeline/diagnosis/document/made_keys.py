"""Values under keys that are made at run time: from the reading's unit (`rms_mm`), or from a channel's name.

A type names only the keys that are the same on every rig; these are read and written here, and checked when they are.
"""

from collections.abc import Mapping
from typing import TypedDict, TypeVar, cast


class Interval(TypedDict):
    """A number with the ends of its 90 % interval, all three in the unit that its key or its owner says."""

    value: float
    low: float
    high: float


Made = float | None | list[float] | dict[str, float] | Interval  # what stands under such a key
AnyPart = TypeVar("AnyPart", bound=Mapping[str, object])


def amount(part: Mapping[str, object], key: str) -> float:
    """The number under a made key, in the unit that the key says; raises KeyError or TypeError where none stands."""
    value = part[key]
    if not isinstance(value, int | float):
        raise TypeError(f"{key} is no number")
    return value


def amount_or_none(part: Mapping[str, object], key: str) -> float | None:
    """The number under a made key, in the unit that the key says; None where the part does not have it."""
    return None if part.get(key) is None else amount(part, key)


def extent(part: Mapping[str, object], key: str) -> list[float]:
    """The lowest and the highest value of a channel, the made key, in its unit; raises TypeError where none stand."""
    value = part[key]
    if not isinstance(value, list):
        raise TypeError(f"{key} is no range")
    return value


def by_name(part: Mapping[str, object], key: str) -> dict[str, float]:
    """Numbers by name, mostly of effects, under a made key, in the key's unit; empty where there are none."""
    value = part.get(key, {})
    if not isinstance(value, dict):
        raise TypeError(f"{key} has no numbers by name")
    return value


def interval(part: Mapping[str, object], key: str) -> Interval:
    """The number with its interval under a made key, in the unit that the key says; raises TypeError without it."""
    value = part[key]
    if not isinstance(value, dict):
        raise TypeError(f"{key} has no value with an interval")
    return cast(Interval, value)  # a JSON object: nothing at run time tells one form of it from another


def with_made(part: AnyPart, by_made_key: Mapping[str, Made], before: str = "") -> AnyPart:
    """The part with the values under made keys before its entry `before`, else at its end, as in the file."""
    place = list(part).index(before) if before in part else len(part)
    first, last = ({key: part[key] for key in keys} for keys in (list(part)[:place], list(part)[place:]))
    # a type names no made key; a part may have them all the same
    return cast(AnyPart, {**first, **by_made_key, **last})


def put(part: Mapping[str, object], key: str, value: Made) -> None:
    """Write a value under a made key into a part."""
    cast(dict[str, object], part)[key] = value  # a type names no made key, and a part may have them all the same
