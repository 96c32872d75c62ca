"""The time constants of a named effect that carry most of it, not all that a recording could have shown."""

import math
import re

from .effects_named import WithParameters

BRANCH_S = re.compile(r"(?:^|_)([0-9.]+)_s_")  # in the name of a strength
COULD_SHOW = {"fastest_s", "slowest_s"}
CARRIES = 0.2  # of all strengths: time constants with less are not mentioned


def time_constants_s(entry: WithParameters) -> list[float]:
    """The time constants of a named mechanism, an entry of `mechanisms`, in s, the shortest first.

    Those that carry most of it, by the names of its strengths; else what its parameters give in seconds. The shortest
    and the longest that a recording could show (`fastest_s`, `slowest_s`) are no constants of the effect itself.
    """
    strengths: dict[float, float] = {}
    for name, quantity in entry["parameters"].items():
        match = BRANCH_S.search(name)
        if match and quantity["value"]:
            seconds = float(match[1])
            strengths[seconds] = strengths.get(seconds, 0.0) + abs(quantity["value"])
    least = CARRIES * sum(strengths.values())
    kept = sorted(seconds for seconds, strength in strengths.items() if strength >= least)
    others = {name: quantity for name, quantity in entry["parameters"].items() if name not in COULD_SHOW}
    return kept or sorted(float(quantity["value"]) for quantity in others.values() if quantity.get("unit") == "s")


def half_done_s(entry: WithParameters) -> tuple[float, float] | None:
    """The earliest and the latest time in s, from a step on, at which half of what follows it in the end is done.

    What follows a load alone and what follows it through the twist may be half done at different times. All together
    are so between the two, whatever the twist. None where no strength names a time, or where some work against others.
    """
    branches: dict[str, list[tuple[float, float]]] = {}
    for name, quantity in entry["parameters"].items():
        match = BRANCH_S.search(name)
        if match and quantity["value"]:
            branches.setdefault(name[: match.start()], []).append((float(match[1]), float(quantity["value"])))
    if len({math.copysign(1.0, strength) for parts in branches.values() for _, strength in parts}) != 1:
        return None
    halves = [_half_s(parts) for parts in branches.values()]
    return min(halves), max(halves)


def _half_s(parts: list[tuple[float, float]]) -> float:
    """The time in s at which the sum of strength x (1 - exp(-t / time constant)) is half of its end."""
    whole = sum(strength for _, strength in parts)
    low, high = (math.log(2.0) * end(seconds for seconds, _ in parts) for end in (min, max))
    while high > 1.001 * low:
        middle = math.sqrt(low * high)
        if sum(strength * -math.expm1(-middle / seconds) for seconds, strength in parts) < 0.5 * whole:
            low = middle
        else:
            high = middle
    return math.sqrt(low * high)
