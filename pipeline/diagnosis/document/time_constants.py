"""The time constants of a named effect that carry most of it, not all that a recording could have shown."""

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
