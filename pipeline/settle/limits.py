"""A person's limits: how far, how fast, under which load and how long; combined with the rig's own limits."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypedDict

from ..ground.errors import BadInput
from ..ground.input.strict_yaml import parse_yaml
from ..wire.motion import Leg, Limits, refusal

OPTION = "--limits"
EXAMPLE = "'{turns: [0, 25], turns_per_s: 8, load_n: [10, 40], seconds: 300}'"
PAIRS, NUMBERS = ("turns", "load_n"), ("turns_per_s", "seconds")
ALL = ("turns", "turns_per_s", "seconds")  # what nothing moves unattended without


class Given(TypedDict, total=False):
    """Limits as a person writes them: a range in turns, turns/s, s, and a range in N."""

    turns: list[float]
    turns_per_s: float
    seconds: float
    load_n: list[float]


@dataclass(frozen=True)
class Allowed:
    """Limits given by a person; a missing entry leaves the rig's own limit."""

    given: Given

    @staticmethod
    def read(text: str) -> "Allowed":
        """The limits in an option's YAML; raises BadInput."""
        content = parse_yaml(text, Path(OPTION))
        if not isinstance(content, dict):
            raise BadInput(OPTION, "value", "is not keys and values", f"write it as in {EXAMPLE}")
        for key, value in content.items():
            good = key in PAIRS and isinstance(value, list) and len(value) == 2 and all(map(_number, value))
            if not (good and value[0] <= value[1]) and not (key in NUMBERS and _number(value) and value > 0):
                raise BadInput(OPTION, str(key), "is no limit, or not of its form", f"write it as in {EXAMPLE}")
        limits: Any = content
        return Allowed(limits)

    def check_unattended(self, rig: Limits) -> None:
        """Raise BadInput where a limit is missing that unattended motion needs."""
        needed = [*ALL, *(["load_n"] if rig.load_n else [])]
        missing = [key for key in needed if key not in self.given]
        if missing:
            problem = f"{' and '.join(missing)} must be given before anything moves unattended"
            raise BadInput(OPTION, missing[0], problem, f"write it as in {EXAMPLE}, or use --approve ask")

    def within(self, rig: Limits) -> Limits:
        """The limits that both allow."""
        own_limits = self.given
        turns, load = own_limits.get("turns", rig.turns), own_limits.get("load_n", rig.load_n)
        return replace(
            rig,
            turns=(max(turns[0], rig.turns[0]), min(turns[1], rig.turns[1])),
            turns_per_s=min(own_limits.get("turns_per_s", rig.turns_per_s), rig.turns_per_s),
            seconds=min(own_limits.get("seconds", rig.seconds), rig.seconds),
            load_n=(max(load[0], rig.load_n[0]), min(load[1], rig.load_n[1])) if rig.load_n and load else None,
        )


class ByHand(Limits):
    """The limits if a person moves the rig: its place and its ramps are unknown."""


FREE = ByHand(10**6, (-1e6, 1e6), 1e6, 1e6, 1e9, 1.0, 0.0, (0.0, 1e9))  # where --limits say no less


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e9


def beyond(legs: list[Leg], limits: Limits | None) -> str | None:
    """How a run exceeds the limits, in words; None where it does not, or there are no limits."""
    reason = refusal(legs, limits) if limits is not None else None
    if reason is None:
        return None
    _, number, sentence = reason
    return f"leg {number} {sentence}" if number else sentence
