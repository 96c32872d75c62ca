"""A named mechanism → its sentence: the library's words with the size, the reach and the parameters that were found."""

import re
from string import Formatter
from typing import Any

from ..interface import Mechanism
from ..naming import Units
from .certainty import SURE
from .quantity import duration, listing, quantity, size
from .vocabulary import Vocabulary

HALF = "half_loop_mm"  # what the strengths add up to that follow neither load nor twist
SMALL = 0.2  # of an effect's rms: a part of a loop that is not worth a word
MOST_OF = 0.2  # of all strengths: time constants with less are not worth a word
CALCULATED = (
    "a temperature that is calculated from how fast and under what load the motor moves (it is not a measured one)"
)
NOTHING = (
    "The search's first fit, which is an approximation, gave it a part, but the exact fit of everything together gives "
    "it a strength of 0."
)
CONSTANT = re.compile(r"\d \S+ \([0-9.,]+ to [0-9.,]+\)")
ENTRY_S = re.compile(r"(?:^|_)([0-9.]+)_s_")


def sentence(mechanism: Mechanism, entry: dict[str, Any], span: float | None, words: Vocabulary, units: Units) -> str:
    """What a mechanism does on this rig, in one sentence; `entry` is its own of `mechanisms`, `span` low to high."""
    worth = entry[f"rms_{words.ending}"]["value"]
    if not worth:
        return f"{NOTHING} So nothing shows that it is at work."
    fields = {**words.fields, "size": f"{size(worth, words.unit)} rms"}
    fields["span"] = size(span, words.unit) if span is not None else ""
    fields["times"] = time_constants(entry["parameters"])
    fields["temperature"] = CALCULATED if calculated(mechanism, entry) else "the measured temperature"
    said = filled(mechanism.sentence, fields).rstrip(".")
    detail = details(mechanism, entry["parameters"], words, units, worth)
    return f"{said}{': ' if detail else ''}{detail}."


def interval(entry: dict[str, Any], words: Vocabulary) -> str:
    """The 90 % interval of an effect's size, or why it has none; nothing where the size is 0."""
    known = entry[f"rms_{words.ending}"]
    if not known["value"]:
        return ""
    if known["high"] <= known["low"]:
        return "Its rms has no interval: the fit gives it one value alone."
    low, high = (size(known[end], words.unit) for end in ("low", "high"))
    unit = high.partition(" ")[2]
    said = f"90 % interval of its rms, if this explanation is right: {low.removesuffix(f' {unit}')} to {high}."
    if known["low"] > 0.0 or entry.get("confidence", 0.0) < SURE:
        return said
    return f"{said} That it is there is sure, its size is not: dimensions or other effects can take its place."


def calculated(mechanism: Mechanism, entry: dict[str, Any]) -> bool:
    """Whether a mechanism follows a temperature, and this one is that of self-heating, from the motion."""
    return "{temperature}" in mechanism.sentence and not entry["parameters"].get("measured", {"value": 0.0})["value"]


def filled(template: str, fields: dict[str, str]) -> str:
    """A template with its fields; the words around a field that has nothing to say go with it."""
    parts = re.split(r"(?<=,) ", template)
    kept = [part for part in parts if all(fields.get(name, "") for name in names_in(part))]
    if len(kept) == len(parts):
        return template.format(**fields)
    return f"{' '.join(part.format(**fields) for part in kept).rstrip(',.')}."


def names_in(template: str) -> list[str]:
    """The fields of a template."""
    return [name for _, name, _, _ in Formatter().parse(template) if name]


def details(
    mechanism: Mechanism, parameters: dict[str, Any], words: Vocabulary, units: Units, worth: float = 0.0
) -> str:
    """The first detail whose parameters were all found, once for every event; `worth` is the effect's rms."""
    for template in loop_details(mechanism, parameters, units, worth):
        wanted = {name: units.name(name) for name in names_in(template) if name not in words.fields}
        found = []
        for number in range(1, mechanism.steps + 1):
            ending = "" if number == 1 else f"_{number}"
            values = {name: parameters.get(f"{key}{ending}") for name, key in wanted.items()}
            if any(value is None or not value["value"] for value in values.values()):
                continue
            said = {name: with_interval(value) for name, value in values.items() if value}
            found.append(template.format(**words.fields, **said))
        if found:
            return listing(found)
    return ""


def with_interval(known: dict[str, Any]) -> str:
    """A constant of an effect with its 90 % interval, if it has one: `0.141 turns (0.137 to 0.144)`."""
    value, low, high = (quantity(known[key], known["unit"], digits=3) for key in ("value", "low", "high"))
    unit = value.partition(" ")[2]
    return value if low == high else f"{value} ({low.removesuffix(unit).strip()} to {high.removesuffix(unit).strip()})"


def has_constants(entry: dict[str, Any]) -> bool:
    """Whether an effect's sentence gives a constant with its interval."""
    return bool(CONSTANT.search(entry["sentence"]))


def loop_details(mechanism: Mechanism, parameters: dict[str, Any], units: Units, worth: float) -> tuple[str, ...]:
    """The details of a mechanism; half a loop is told only where it is the same under every load and at every twist.

    Else the sum of those strengths is a part of the loop, and twice it is told as how wide that part is; nothing where
    that is little beside the effect's rms, `worth`.
    """
    part = parameters.get(units.name(HALF), {"value": 0.0})
    grown = [name for name, value in parameters.items() if value["unit"].startswith(f"{part.get('unit')}/")]
    others = [name for name in parameters if (name in grown or "slack_" in name) and parameters[name]["value"]]
    if not part["value"] or not others:
        return mechanism.details
    if part["value"] < SMALL * worth:
        return ()
    wide = quantity(2.0 * part["value"], part["unit"])
    return (f"{wide} of its width are the same under every load and at every {{motion}}",)


def time_constants(parameters: dict[str, Any]) -> str:
    """The time constants that carry most of an effect, from the names of its strengths."""
    strengths: dict[float, float] = {}
    for name, value in parameters.items():
        match = ENTRY_S.search(name)
        if match and value["value"]:
            seconds = float(match[1])
            strengths[seconds] = strengths.get(seconds, 0.0) + abs(value["value"])
    whole = sum(strengths.values())
    kept = sorted(seconds for seconds, strength in strengths.items() if strength >= MOST_OF * whole)
    if not kept:
        return ""
    longest = parameters.get("slowest_s", {"value": None})["value"]
    bound = f" ({duration(kept[-1])} is the longest, so it may be longer)" if kept[-1] == longest else ""
    if len(kept) == 1:
        return f"best with a time constant of {duration(kept[0])} of those that were tried{bound}"
    return f"best with time constants of {duration(kept[0])} to {duration(kept[-1])} of those that were tried{bound}"
